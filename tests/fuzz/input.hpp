#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <limits>
#include <type_traits>

#include "core/time.hpp"
#include "signals/fields.hpp"
#include "tests/fuzz/harness.hpp"

namespace farrier::fuzz {

#define FARRIER_COUNT(Signal, file) +1
inline constexpr std::size_t kTopicCount = 0 FARRIER_SIGNALS(FARRIER_COUNT);
#undef FARRIER_COUNT

/// Values drawn from the bytes of an input, front to back; zeros once they are used up.
class Input {
 public:
  explicit Input(Bytes bytes) : left_(bytes) {}

  bool empty() const noexcept { return left_.empty(); }
  Bytes rest() const noexcept { return left_; }

  template <class Number>
  requires std::is_arithmetic_v<Number> Number raw()
  noexcept {
    Number value{};
    const std::size_t size = std::min(sizeof(Number), left_.size());
    if (size > 0) {  // nothing has no place
      std::memcpy(&value, left_.data(), size);
    }
    left_ = left_.subspan(size);
    return value;
  }
  std::uint8_t byte() noexcept { return raw<std::uint8_t>(); }
  std::size_t below(std::size_t bound) noexcept { return byte() % bound; }

  /// A number of any size, one of the values that break things, or one within +-size. One byte decides, so that
  /// mutations reach all.
  double number(double size) noexcept {
    using Limits = std::numeric_limits<double>;
    static constexpr std::array kExtremes = {Limits::quiet_NaN(),
                                             Limits::infinity(),
                                             -Limits::infinity(),
                                             Limits::max(),
                                             Limits::lowest(),
                                             Limits::denorm_min(),
                                             Limits::min(),
                                             0.0,
                                             -0.0};
    const std::uint8_t kind = byte();
    if (kind < kExtremes.size()) {
      return kExtremes[kind];
    }
    if (kind < 32) {
      return raw<double>();
    }
    return size * raw<std::int16_t>() / std::numeric_limits<std::int16_t>::max();
  }

  /// One of the ends, any, or a little after `last`, as ticks are.
  Tick tick(Tick last) noexcept {
    using Limits = std::numeric_limits<Tick>;
    const std::uint8_t kind = byte();
    switch (kind) {
      case 0:
        return Limits::max();
      case 1:
        return Limits::min();
      case 2:
        return Limits::max() - 1;
      case 3:
        return kNoTick;
      case 4:
        return raw<Tick>();
      default:
        return std::clamp<Tick>(last, Limits::min() + 8, Limits::max() - 8) + kind % 8 - 1;
    }
  }

  /// Any content in every field.
  template <class Signal>
  Signal signal() noexcept {
    Signal signal;
    signals::visit_fields(signal, [this](const char*, auto& field) { fill(field); });
    return signal;
  }

 private:
  template <class Field>
  void fill(Field& field) noexcept {
    if constexpr (std::is_same_v<Field, double>) {
      field = number(1.0);
    } else if constexpr (std::is_arithmetic_v<Field>) {
      field = raw<Field>();
    } else if constexpr (std::is_enum_v<Field>) {
      field = static_cast<Field>(byte());
    } else if constexpr (signals::kIsOctets<Field>) {
      field.assign(left_.first(std::min<std::size_t>(left_.size(), raw<std::uint16_t>())));
    } else {
      for (auto& element : field) {
        fill(element);
      }
    }
  }

  Bytes left_;
};

/// True if two signals are the same, bit for bit in every field.
template <class Signal>
bool alike(const Signal& one, const Signal& other) noexcept {
  bool same = true;
  const auto compare = [&same]<class Field>(const Field& a, const Field& b) {
    if constexpr (signals::kIsOctets<Field>) {
      same = same && a == b;
    } else {
      same = same && std::memcmp(&a, &b, sizeof a) == 0;
    }
  };
#define FARRIER_COMPARE(field) compare(one.field, other.field);
#define FARRIER_COMPARE_IF(Of, file)                   \
  if constexpr (std::is_same_v<Signal, signals::Of>) { \
    FARRIER_FIELDS_##Of(FARRIER_COMPARE)               \
  }
  FARRIER_SIGNALS(FARRIER_COMPARE_IF)
#undef FARRIER_COMPARE_IF
#undef FARRIER_COMPARE
  return same;
}

/// Calls use(signal) with a signal of a topic; `topic` in [0, kTopicCount).
template <class Use>
void with_signal_of(std::size_t topic, Use&& use) {
  std::size_t place = 0;
#define FARRIER_USE(Signal, file) \
  if (topic == place++) {         \
    use(signals::Signal{});       \
  }
  FARRIER_SIGNALS(FARRIER_USE)
#undef FARRIER_USE
}

}  // namespace farrier::fuzz
