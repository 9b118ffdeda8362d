#include "diagnosis/wiring/wiring_hypotheses.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <utility>

#include "core/units.hpp"

namespace farrier::diagnosis {
namespace {

/// Unexplained parts that count as nothing, by law. Those of oil and drive have no winding, spool or nonlinear flow.
constexpr std::array<double, kWiringLaws> kFloors{1e-6, 1e-6, 1e-6, 5e-4, 5e-4, 1e-6, 1e-6};

/// Weights of the laws. No effect changes velocity and position, and pressures and force, beyond what their laws allow.
constexpr std::array<double, kWiringLaws> kWeights{2.0, 1.0, 1.0, 1.0, 1.0, 2.0, 1.0};

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
      add({.kind = WiringKind::kExchanged, .channel = kPressureA, .other = kPressureB});
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
  /// Adds a fault that has a wiring_hypothesis().
  void add(const WiringFault& fault) {
    const Unexplained left = judge_.judge(*wiring_hypothesis(fault));
    faults_.push_back({fault, left, log_gain(judge_.without_fault(), left)});
  }

  void reverse(WiredChannel channel) {
    add({.kind = channel == WiredChannel::kPosition ? WiringKind::kMirrored : WiringKind::kReversed,
         .channel = channel});
  }

  void scale(WiredChannel channel, double factor, bool both = false) {
    if (factor != 1.0) {
      add({.kind = WiringKind::kScaled, .channel = channel, .amount = factor, .both_pressures = both});
    }
  }

  /// Adds the best lag of either sign.
  void lag(const std::vector<WiredChannel>& channels) {
    for (const int sign : {1, -1}) {
      const bool delayed = sign < 0 && channels.front() == WiredChannel::kCurrent;
      WiringFault best;
      double least = std::numeric_limits<double>::infinity();
      for (int samples = delayed ? judge_.longest_delay() + 1 : 1; samples <= judge_.most_late(); ++samples) {
        const WiringFault fault{.kind = sign > 0 ? WiringKind::kLate : WiringKind::kEarly,
                                .channel = channels.front(),
                                .amount = static_cast<double>(samples),
                                .both_pressures = channels.size() > 1};
        const double misfit = judge_.misfit_of_lag(channels.front(), *wiring_hypothesis(fault));
        if (misfit < least) {
          least = misfit;
          best = fault;
        }
      }
      if (std::isfinite(least)) {
        add(best);
      }
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

std::optional<WiringHypothesis> wiring_hypothesis(const WiringFault& fault) noexcept {
  WiringHypothesis hypothesis;
  ChannelChange& change = hypothesis.of(fault.channel);
  switch (fault.kind) {
    case WiringKind::kReversed:
    case WiringKind::kMirrored:
      change.factor = -1.0;
      break;
    case WiringKind::kScaled:
      change.factor = fault.amount;
      break;
    case WiringKind::kLate:
      change.late = static_cast<int>(fault.amount);
      break;
    case WiringKind::kEarly:
      change.late = -static_cast<int>(fault.amount);
      break;
    case WiringKind::kExchanged:
      if (fault.channel != WiredChannel::kPressureA || fault.other != WiredChannel::kPressureB) {
        return std::nullopt;
      }
      hypothesis.pressures_exchanged = true;
      break;
    case WiringKind::kDead:
    case WiringKind::kOtherJoint:
      return std::nullopt;
  }
  if (fault.both_pressures) {
    hypothesis.of(WiredChannel::kPressureB) = change;
  }
  return hypothesis;
}

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
      const auto at_most_all = [&](double unexplained) { return std::clamp(unexplained, kFloors[i], 1.0); };
      gain += kWeights[i] * std::log(at_most_all(before[i]) / at_most_all(after[i]));
    }
  }
  return gain;
}

std::vector<JudgedFault> judge_faults(const WiringJudge& judge, const Recording& recording, const robot::Joint& joint) {
  return Search(judge, recording, joint).all();
}

}  // namespace farrier::diagnosis
