#pragma once

#include <algorithm>
#include <limits>

#include "bus/bus.hpp"
#include "core/ticks_since.hpp"
#include "participant/clock.hpp"
#include "signals/journal.hpp"

namespace farrier::participant {

/// Gathers a port's samples for recorders, while there are some: one journal replaces a hundred datagrams to a
/// recorder. Used by the thread that publishes on the port.
class StreamJournal {
 public:
  StreamJournal(bus::Publisher<signals::SystemJournal> publisher, std::uint16_t participant, bus::TopicId topic,
                bus::ClockKind clock)
      : publisher_(std::move(publisher)), most_(clock == bus::ClockKind::kLockstep ? kInLockstep : kInRealtime) {
    journal_.stream = signals::stream_of(participant, static_cast<std::uint8_t>(topic));
    journal_.contract = bus::contract_hash();
  }
  /// Sends what it holds.
  ~StreamJournal() { send(); }
  StreamJournal(const StreamJournal&) = delete;
  StreamJournal& operator=(const StreamJournal&) = delete;

  /// Probe of the greeting: a journal without samples.
  void probe() noexcept {
    signals::SystemJournal empty;
    empty.stream = journal_.stream;
    publisher_.publish(empty);
  }

  /// Looks whether there is a recorder.
  void look() noexcept { heard_ = publisher_.matched_readers() > 0; }

  /// A sample of its topic.
  template <class Signal>
  void add(const Signal& signal) noexcept {
    if (!heard_ && ++unheard_ % kLookEvery == 0) {
      look();
    }
    if (!heard_) {
      return;
    }
    if (!signals::has_room<Signal>(journal_, most_.bytes)) {
      send();
    }
    if (journal_.samples == 0 || signal.tick != journal_.tick) {
      newest_ns_ = date_now_ns();  // a tick's samples come together
    }
    if (journal_.samples == 0) {
      first_ns_ = newest_ns_;
      first_tick_ = signal.tick;
    }
    signals::append(journal_, signal, after_first(newest_ns_));
    journal_.tick = signal.tick;
    const bool many_ticks = signal.tick < first_tick_ || ticks_since(first_tick_, signal.tick) >= most_.ticks;
    due_ = due_ || many_ticks || most_.bytes - journal_.bytes.size() < kRoomForATick;
  }

  /// Sends its content if it is time to. Called when the samples themselves are on their way.
  void flush() noexcept {
    if (due_) {
      send();
    }
  }

  /// Sends its content and, from now on, every sample as it comes: the run is over.
  void finish() noexcept {
    send();
    over_ = true;
    due_ = true;
  }

 private:
  /// Largest content of one journal. A recorder loses at most so much of a process that was killed.
  struct Most {
    std::size_t bytes;
    std::uint64_t ticks;
  };
  static constexpr Most kInRealtime{8000, 16};    // six frames of Ethernet, of which none may be lost
  static constexpr Most kInLockstep{32'000, 192};
  static constexpr std::size_t kRoomForATick = 1500;
  static constexpr std::uint64_t kLookEvery = 16;  // asking the transport takes a lock of its

  std::uint32_t after_first(std::uint64_t now_ns) const noexcept {
    constexpr std::uint64_t kMost = std::numeric_limits<std::uint32_t>::max();
    return static_cast<std::uint32_t>(std::min(now_ns - std::min(first_ns_, now_ns), kMost));  // the date may be set
  }

  void send() noexcept {
    if (journal_.samples == 0) {
      return;
    }
    journal_.closed_after_ns = after_first(date_now_ns());
    publisher_.publish(journal_);
    journal_.samples_before += journal_.samples;
    signals::clear(journal_);
    due_ = over_;
    look();
  }

  bus::Publisher<signals::SystemJournal> publisher_;
  Most most_;
  signals::SystemJournal journal_;
  std::uint64_t first_ns_ = 0, newest_ns_ = 0;
  Tick first_tick_ = kNoTick;
  std::uint64_t unheard_ = 0;
  bool heard_ = false;
  bool due_ = false;
  bool over_ = false;
};

}  // namespace farrier::participant
