#include "diagnosis/wiring/wiring_hypotheses.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <utility>

#include "core/units.hpp"

namespace farrier::diagnosis {
namespace {

/// Unexplained parts that count as nothing, by law: the noise and a shape that is not exact. The oil's nonlinearity in a
/// trot leaves 1 % of the current's mean square.
constexpr std::array<double, kWiringLaws> kFloors{5e-4, 1e-3, 1e-3, 5e-3, 5e-3, 5e-4, 5e-4};

/// Searches the faults of one recording.
class Search {
 public:
  Search(const WiringJudge& judge, const Recording& recording, const robot::Joint& joint)
      : judge_(judge), recording_(recording), joint_(joint) {}

  std::vector<JudgedFault> all() && {
    using enum WiredChannel;
    const bool velocity = !recording_.velocity_derived && !recording_.velocity.empty();
    const bool current = !recording_.valve_current_A.empty();
    const bool pressures = !recording_.pressure_a_Pa.empty() && !recording_.pressure_b_Pa.empty();
    std::vector<WiredChannel> channels{kPosition, kForce};
    if (velocity) {
      channels.push_back(kVelocity);
    }
    if (current) {
      channels.push_back(kCurrent);
    }
    for (const WiredChannel channel : channels) {
      reverse(channel);
      for (int power = -4; power <= 4; ++power) {
        scale(channel, std::pow(10.0, power));
      }
      lag({channel});
    }
    if (recording_.coordinates == Coordinates::kRotary) {
      scale(kPosition, kDegrees);
      scale(kVelocity, kDegrees);
    }
    if (pressures) {
      WiringHypothesis exchanged;
      exchanged.pressures_exchanged = true;
      add({.kind = WiringKind::kExchanged, .channel = kPressureA, .other = kPressureB}, exchanged);
      for (const double factor : kPressureFactors) {
        scale(kPressureA, factor);
        scale(kPressureB, factor);
        scale(kPressureA, factor, true);
      }
      lag({kPressureA, kPressureB});
    }
    exchange(channels);
    std::ranges::stable_sort(faults_, std::greater{}, &JudgedFault::gain);
    return std::move(faults_);
  }

 private:
  JudgedFault judged(const WiringFault& fault, const WiringHypothesis& hypothesis) const {
    const Unexplained left = judge_.judge(hypothesis);
    return {fault, left, log_gain(judge_.without_fault(), left)};
  }
  void add(const WiringFault& fault, const WiringHypothesis& hypothesis) {
    faults_.push_back(judged(fault, hypothesis));
  }

  void reverse(WiredChannel channel) {
    WiringHypothesis hypothesis;
    hypothesis.of(channel).factor = -1.0;
    add({.kind = channel == WiredChannel::kPosition ? WiringKind::kMirrored : WiringKind::kReversed,
         .channel = channel},
        hypothesis);
  }

  void scale(WiredChannel channel, double factor, bool both = false) {
    if (factor == 1.0) {
      return;
    }
    WiringHypothesis hypothesis;
    hypothesis.of(channel).factor = factor;
    if (both) {
      hypothesis.of(WiredChannel::kPressureB).factor = factor;
    }
    add({.kind = WiringKind::kScaled, .channel = channel, .amount = factor, .both_pressures = both}, hypothesis);
  }

  /// Adds the best lag of either sign, from coarse to fine.
  void lag(const std::vector<WiredChannel>& channels) {
    for (const int sign : {1, -1}) {
      const auto at = [&](int samples) {
        WiringHypothesis hypothesis;
        for (const WiredChannel channel : channels) {
          hypothesis.of(channel).late = sign * samples;
        }
        return judged({.kind = sign > 0 ? WiringKind::kLate : WiringKind::kEarly,
                       .channel = channels.front(),
                       .amount = static_cast<double>(samples),
                       .both_pressures = channels.size() > 1},
                      hypothesis);
      };
      const bool delayed = sign < 0 && channels.front() == WiredChannel::kCurrent;
      const int first = delayed ? judge_.longest_delay() + 1 : 1;
      const int last = judge_.most_late();
      if (first > last) {
        continue;
      }
      JudgedFault best = at(first);
      int step = 1;
      for (int samples = first + 1; samples <= last; samples += step) {
        step = std::max(1, samples / 5);
        if (JudgedFault next = at(samples); next.gain > best.gain) {
          best = next;
        }
      }
      for (int reach = std::max(1, static_cast<int>(best.fault.amount) / 5) / 2 + 1; reach >= 1; reach /= 2) {
        const int middle = static_cast<int>(best.fault.amount);
        for (const int samples : {middle - reach, middle + reach}) {
          if (samples >= first && samples <= last) {
            if (JudgedFault next = at(samples); next.gain > best.gain) {
              best = next;
            }
          }
        }
      }
      faults_.push_back(best);
    }
  }

  void exchange(const std::vector<WiredChannel>& channels) {
    for (std::size_t i = 0; i < channels.size(); ++i) {
      for (std::size_t j = i + 1; j < channels.size(); ++j) {
        Recording undone = recording_;
        std::swap(column(undone, channels[i]), column(undone, channels[j]));
        const Unexplained left = WiringJudge(undone, joint_).without_fault();
        faults_.push_back({{.kind = WiringKind::kExchanged, .channel = channels[i], .other = channels[j]},
                           left,
                           log_gain(judge_.without_fault(), left)});
      }
    }
  }

  const WiringJudge& judge_;
  const Recording& recording_;
  const robot::Joint& joint_;
  std::vector<JudgedFault> faults_;
};

}  // namespace

std::vector<double>& column(Recording& recording, WiredChannel channel) noexcept {
  switch (channel) {
    case WiredChannel::kPosition:
      return recording.position;
    case WiredChannel::kVelocity:
      return recording.velocity;
    case WiredChannel::kForce:
      return recording.force;
    case WiredChannel::kCurrent:
      return recording.valve_current_A;
    case WiredChannel::kPressureA:
      return recording.pressure_a_Pa;
    case WiredChannel::kPressureB:
      return recording.pressure_b_Pa;
    case WiredChannel::kSupply:
      return recording.supply_pressure_Pa;
  }
  return recording.position;
}

const std::vector<double>& column(const Recording& recording, WiredChannel channel) noexcept {
  return column(const_cast<Recording&>(recording), channel);
}

double log_gain(const Unexplained& before, const Unexplained& after) noexcept {
  double gain = 0.0;
  for (std::size_t i = 0; i < kWiringLaws; ++i) {
    if (!std::isnan(before[i]) && !std::isnan(after[i])) {
      gain += std::log(std::max(std::min(before[i], 1.0), kFloors[i]) / std::max(std::min(after[i], 1.0), kFloors[i]));
    }
  }
  return gain;
}

std::vector<JudgedFault> judge_faults(const WiringJudge& judge, const Recording& recording, const robot::Joint& joint) {
  return Search(judge, recording, joint).all();
}

}  // namespace farrier::diagnosis
