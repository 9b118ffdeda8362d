#pragma once

#include "participant/clock.hpp"
#include "recorder/recorder.hpp"
#include "signals/sequence_of.hpp"

namespace farrier::recorder {

/// Steady clocks of two computers have nothing to do with each other.
inline constexpr std::int64_t kBelievable_ns = 1'000'000'000;

/// When a sample came to be, where its sender said so by the steady clock of this computer; otherwise now.
template <class Signal>
std::uint64_t publish_time(const Signal& signal, std::uint64_t now_ns, std::int64_t steady_now_ns) {
  if constexpr (requires { signal.sample_time_ns; }) {
    const std::int64_t age_ns = steady_now_ns - signal.sample_time_ns;
    if (age_ns >= 0 && age_ns < kBelievable_ns) {
      return now_ns - static_cast<std::uint64_t>(age_ns);
    }
  }
  return now_ns;
}

/// This computer's clocks when a tap was drained.
struct Now {
  std::uint64_t date_ns = participant::date_now_ns();
  std::int64_t steady_ns = participant::steady_now().time_since_epoch().count();
};

/// Samples of one topic on their way on.
template <class Signal>
class Stream {
 public:
  /// `age_ns`: since it was published, as far as that is known.
  void hand_on(const Signal& signal, std::span<const std::uint8_t> cdr, const Now& now, std::uint32_t age_ns,
               const recording::TakeSample& take) {
    ++samples_;
    take({.topic = bus::TopicOf<Signal>::id,
          .sequence = static_cast<std::uint32_t>(signals::sequence_of(signal).value_or(0)),
          .log_time_ns = now.date_ns - age_ns,
          .publish_time_ns = publish_time(signal, now.date_ns, now.steady_ns),
          .cdr = cdr});
  }
  TopicProgress progress(std::uint64_t lost, const bus::ReaderStatus& reader) const {
    return {bus::TopicOf<Signal>::id, samples_, lost, reader};
  }

 private:
  std::uint64_t samples_ = 0;
};

}  // namespace farrier::recorder
