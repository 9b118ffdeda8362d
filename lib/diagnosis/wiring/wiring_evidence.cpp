#include "diagnosis/wiring/wiring_evidence.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace farrier::diagnosis {
namespace {

/// Laws with two sides over time.
constexpr std::array kShown{WiringLaw::kKinematics,         WiringLaw::kLoadByPosition,     WiringLaw::kLoadByVelocity,
                            WiringLaw::kActuatorByPosition, WiringLaw::kActuatorByVelocity, WiringLaw::kCell};

double at(const Unexplained& unexplained, WiringLaw law) { return unexplained[static_cast<std::size_t>(law)]; }

/// The law that improves most from one judgement to the other; none if no law has both.
std::optional<WiringLaw> most_telling(const Unexplained& before, const Unexplained& after) {
  std::optional<WiringLaw> best;
  double most = 0.0;
  for (const WiringLaw law : kShown) {
    Unexplained one{}, other{};
    one.fill(NAN);
    other.fill(NAN);
    one[static_cast<std::size_t>(law)] = at(before, law);
    other[static_cast<std::size_t>(law)] = at(after, law);
    if (const double gain = log_gain(one, other); gain > most) {
      most = gain;
      best = law;
    }
  }
  return best;
}

/// The law whose left side is a channel that does not move, or the one that the channel's motion should explain.
std::optional<WiringLaw> law_of_dead(const WiringJudge& judge, WiredChannel channel) {
  const Unexplained& none = judge.without_fault();
  const auto known = [&](WiringLaw law) { return std::isnan(at(none, law)) ? std::nullopt : std::optional(law); };
  switch (channel) {
    case WiredChannel::kPosition:
    case WiredChannel::kVelocity:
      return known(WiringLaw::kKinematics);
    case WiredChannel::kForce:
      return known(WiringLaw::kLoadByPosition);
    case WiredChannel::kCurrent:
      return known(WiringLaw::kActuatorByPosition);
    case WiredChannel::kPressureA:
    case WiredChannel::kPressureB:
      return known(WiringLaw::kCell);
    case WiredChannel::kSupply:
      break;
  }
  return std::nullopt;
}

/// The recording with the columns that a fault put elsewhere in their places; none if it has them nowhere.
std::optional<Recording> with_own_columns(const Recording& recording, const WiringFault& fault,
                                          std::span<const OtherJoint> others) {
  Recording undone = recording;
  if (fault.kind == WiringKind::kExchanged) {
    std::swap(column(undone, fault.channel), column(undone, fault.other));
    return undone;
  }
  const auto other = std::ranges::find(others, fault.joint, &OtherJoint::name);
  if (fault.kind != WiringKind::kOtherJoint || other == others.end()) {
    return std::nullopt;
  }
  column(undone, fault.channel) = column(other->recording, fault.channel);
  return undone;
}

LawOverTime over_time(const LawLine& line, double period_s) {
  LawOverTime over{{}, line.left, line.right};
  for (const std::size_t i : line.at) {
    over.time_s.push_back((static_cast<double>(i) + 0.5) * period_s);
  }
  return over;
}

}  // namespace

std::optional<WiringEvidence> wiring_evidence(const Recording& recording, const robot::Joint& joint,
                                              const WiringFault& fault, std::span<const OtherJoint> others) {
  const WiringJudge judge(recording, joint);
  const WiringHypothesis none;
  const auto recorded = [&](WiringLaw law, const LawFit& fit) {
    return over_time(judge.line(law, none, fit), recording.period_s);
  };
  if (const auto hypothesis = wiring_hypothesis(fault); hypothesis && fault.channel != WiredChannel::kSupply) {
    const auto law = most_telling(judge.without_fault(), judge.judge(*hypothesis));
    if (!law) {
      return std::nullopt;
    }
    const LawFit fit = judge.fit(*law, *hypothesis);
    return WiringEvidence{*law, recorded(*law, fit), over_time(judge.line(*law, *hypothesis, fit), recording.period_s)};
  }
  if (const auto undone = with_own_columns(recording, fault, others)) {
    const WiringJudge mended(*undone, joint);
    if (const auto law = most_telling(judge.without_fault(), mended.without_fault())) {
      const LawFit fit = mended.fit(*law, none);
      return WiringEvidence{*law, recorded(*law, fit), over_time(mended.line(*law, none, fit), recording.period_s)};
    }
  }
  const auto law = law_of_dead(judge, fault.channel);
  return law ? std::optional(WiringEvidence{*law, recorded(*law, judge.fit(*law, none)), {}}) : std::nullopt;
}

}  // namespace farrier::diagnosis
