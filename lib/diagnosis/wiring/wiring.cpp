#include "diagnosis/wiring/wiring.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <optional>

#include "diagnosis/data/recording_units.hpp"
#include "diagnosis/data/sample_statistics.hpp"

namespace farrier::diagnosis {
namespace {

using enum WiredChannel;

constexpr double kBad = 0.03;            // of a law unexplained: a joint much like this one may leave no more
constexpr double kLeastMovement = 10.0;  // of a sensor's noise, that a channel should have had

bool recorded(const Recording& recording, WiredChannel channel) {
  return !column(recording, channel).empty() && !(channel == kVelocity && recording.velocity_derived);
}

double noise_of(const robot::Joint& joint, WiredChannel channel) {
  switch (channel) {
    case kVelocity:
      return joint.noise.velocity;
    case kForce:
      return joint.noise.force;
    case kPosition:
      return joint.noise.velocity;
    case kCurrent:
      return 1e-3 * joint.actuator.valve_current_max_A;
    case kPressureA:
    case kPressureB:
    case kSupply:
      return 1e-4 * joint.actuator.supply_pressure_Pa;
  }
  return 0.0;
}

/// Channels without any movement that the others say they should have.
std::vector<WiringFault> dead_channels(const WiringJudge& judge, const Recording& recording, const robot::Joint& joint,
                                       double share) {
  std::vector<WiringFault> dead;
  for (const WiredChannel channel : {kPosition, kVelocity, kForce, kCurrent, kPressureA, kPressureB}) {
    const double expected = judge.expected(channel);
    if (recorded(recording, channel) && expected > kLeastMovement * noise_of(joint, channel) &&
        judge.seen(channel) < share * expected) {
      dead.push_back({.kind = WiringKind::kDead, .channel = channel});
    }
  }
  if (!recording.supply_pressure_Pa.empty()) {
    // A constant supply is good, one far below its chambers is not.
    double chambers = 0.0;
    for (const WiredChannel chamber : {kPressureA, kPressureB}) {
      if (recorded(recording, chamber)) {
        chambers = std::max(chambers, quantile(column(recording, chamber), 0.5));
      }
    }
    const double supply = std::abs(quantile(recording.supply_pressure_Pa, 0.5));
    if (supply < 1e-3 * std::max(chambers, joint.actuator.supply_pressure_Pa) &&
        standard_deviation(recording.supply_pressure_Pa) < 1e-3 * joint.actuator.supply_pressure_Pa) {
      dead.push_back({.kind = WiringKind::kDead, .channel = kSupply});
    }
  }
  return dead;
}

/// The factor by which a supply's level is a power of ten or another unit away from the file's; none for a right one.
std::optional<double> factor_of_supply(const Recording& recording, const robot::Joint& joint) {
  if (recording.supply_pressure_Pa.empty()) {
    return std::nullopt;
  }
  const double level = quantile(recording.supply_pressure_Pa, 0.5) / joint.actuator.supply_pressure_Pa;
  const auto found = std::ranges::find_if(
      kPressureFactors, [level](double factor) { return level > 0.75 * factor && level < 1.3 * factor; });
  return found == kPressureFactors.end() ? std::nullopt : std::optional(*found);
}

double relative_difference(const std::vector<double>& one, const std::vector<double>& other) {
  double difference = 0.0;
  for (std::size_t i = 0; i < one.size(); ++i) {
    difference += (one[i] - other[i]) * (one[i] - other[i]);
  }
  const double moves = standard_deviation(one);
  return moves > 0.0 ? std::sqrt(difference / static_cast<double>(one.size())) / moves : INFINITY;
}

/// Faults that put a channel of another joint in the place of this joint's.
std::vector<JudgedFault> of_other_joints(const WiringJudge& judge, const Recording& recording,
                                         const robot::Joint& joint, std::span<const OtherJoint> others,
                                         double same_share) {
  std::vector<JudgedFault> faults;
  const Unexplained& none = judge.without_fault();
  for (const OtherJoint& other : others) {
    if (other.recording.position.size() != recording.position.size() ||
        (other.recording.position == recording.position && other.recording.force == recording.force) ||
        (!recording.time_s.empty() && !other.recording.time_s.empty() &&
         std::abs(other.recording.time_s.front() - recording.time_s.front()) > 0.5 * recording.period_s)) {
      continue;
    }
    for (const WiredChannel channel : {kForce, kPosition, kVelocity, kCurrent}) {
      if (!recorded(recording, channel) || !recorded(other.recording, channel)) {
        continue;
      }
      Recording undone = recording;
      column(undone, channel) = column(other.recording, channel);
      JudgedFault fault{{.kind = WiringKind::kOtherJoint, .channel = channel, .joint = other.name}, none, 0.0};
      if (relative_difference(column(recording, channel), column(other.recording, channel)) < same_share) {
        // Its own is not recorded anywhere: without it the laws of this channel say nothing.
        WiringHypothesis touched;
        touched.of(channel).factor = -1.0;
        const Unexplained reversed = judge.judge(touched);
        for (std::size_t i = 0; i < kWiringLaws; ++i) {
          fault.unexplained[i] = reversed[i] == none[i] ? none[i] : std::min(none[i], 0.01);
        }
      } else {
        fault.unexplained = WiringJudge(undone, joint).without_fault();
      }
      fault.gain = log_gain(none, fault.unexplained);
      faults.push_back(fault);
    }
  }
  return faults;
}

/// True if each law that undoing the fault changes is explained well enough then.
bool explains(const Unexplained& before, const JudgedFault& fault, const WiringRules& rules) {
  const bool lag = fault.fault.kind == WiringKind::kLate || fault.fault.kind == WiringKind::kEarly;
  const double most_unexplained = lag ? rules.most_unexplained_of_lag : rules.most_unexplained;
  for (std::size_t i = 0; i < kWiringLaws; ++i) {
    if (!std::isnan(before[i]) && fault.unexplained[i] != before[i] && fault.unexplained[i] > most_unexplained) {
      return false;
    }
  }
  return true;
}

double share_left(const Unexplained& before, const JudgedFault& fault) {
  double sum = 0.0;
  int changed = 0;
  for (std::size_t i = 0; i < kWiringLaws; ++i) {
    if (!std::isnan(before[i]) && fault.unexplained[i] != before[i]) {
      Unexplained one{}, other{};
      one.fill(NAN);
      other.fill(NAN);
      one[i] = before[i];
      other[i] = fault.unexplained[i];
      sum -= 0.5 * log_gain(one, other);
      ++changed;
    }
  }
  return changed == 0 ? 1.0 : std::exp(sum / changed);
}

}  // namespace

std::vector<WiringAnswer> find_wiring(const Recording& recording, const robot::Joint& joint,
                                      std::span<const OtherJoint> others, const WiringRules& rules) {
  std::vector<WiringAnswer> answers;
  if (recording.position.size() < kFewestSamples || !has_coordinates_of(recording, joint)) {
    return answers;
  }
  const auto answer = [&](const WiringFault& fault, double confidence, double left) {
    answers.push_back({fault, columns_of(fault, recording), std::min(confidence, rules.most_confidence), left});
  };
  const WiringJudge judge(recording, joint);
  std::vector<JudgedFault> faults = judge_faults(judge, recording, joint);
  const std::vector<JudgedFault> foreign = of_other_joints(judge, recording, joint, others, rules.same_share);
  faults.insert(faults.end(), foreign.begin(), foreign.end());
  std::erase_if(faults, [&](const JudgedFault& fault) { return !explains(judge.without_fault(), fault, rules); });
  std::ranges::stable_sort(faults, std::greater{}, &JudgedFault::gain);
  if (const std::optional<double> factor = factor_of_supply(recording, joint)) {
    answer({.kind = WiringKind::kScaled, .channel = kSupply, .amount = *factor}, 1.0, 0.0);
  }
  if (!faults.empty() && faults.front().gain >= rules.least_gain) {
    double weights = std::exp(-faults.front().gain);  // of no fault
    for (const JudgedFault& fault : faults) {
      weights += std::exp(fault.gain - faults.front().gain);
    }
    for (const JudgedFault& fault : faults) {
      const double weight = std::exp(fault.gain - faults.front().gain);
      if (weight < rules.rival_weight || fault.gain < rules.least_gain) {
        break;
      }
      answer(fault.fault, weight / weights, share_left(judge.without_fault(), fault));
    }
    return answers;
  }
  for (const WiringFault& fault : dead_channels(judge, recording, joint, rules.dead_share)) {
    answer(fault, 1.0, 0.0);
  }
  return answers;
}

bool may_be_of_another_joint(const Recording& recording, const robot::Joint& joint) {
  if (recording.position.size() < kFewestSamples) {
    return false;
  }
  const Unexplained laws = WiringJudge(recording, joint).without_fault();
  return std::ranges::any_of(laws, [](double unexplained) { return unexplained > kBad; });
}

}  // namespace farrier::diagnosis
