#include "report/trot/adaptation.hpp"

#include <algorithm>
#include <cmath>

#include "report/figures/text_format.hpp"

namespace farrier::report {
namespace {

constexpr std::size_t kFlexingLegJoints = 3;  // HAA, HFE, KFE

bool flexes(const robot::Robot& robot, const robot::Joint& joint) {
  return joint.index_in_leg != 0 &&
         robot.plan.legs[static_cast<std::size_t>(joint.leg)].joints.size() == kFlexingLegJoints;
}

}  // namespace

void add_updates(Figures& figures, const robot::Robot& robot, std::span<const DecisionInfo> decisions, Tick ticks,
                 bool judged) {
  const bool bounded = judged && robot.bounds.judged && robot.plan.gait.pattern == gait::Pattern::kTrot &&
                       ticks >= std::llround(kUpdatesJudgedFrom_s / robot.period_s);
  for (const robot::Joint& joint : robot.joints) {
    const auto count = [&](bool accepted) {
      return static_cast<double>(std::ranges::count_if(decisions, [&](const DecisionInfo& decision) {
        return decision.joint == joint.name && decision.accepted() == accepted;
      }));
    };
    // The torque of a rigid drive does not depend on its load: the first design suits both phases.
    const bool rigid = joint.electric && joint.electric->rigid;
    figures.add("trot." + joint.name + ".updates", count(true),
                bounded && !rigid && flexes(robot, joint) ? std::optional(kUpdatesAtLeast) : std::nullopt);
    figures.add("trot." + joint.name + ".refused_designs", count(false));
  }
  figures.add("trot.updates", static_cast<double>(std::ranges::count_if(decisions, &DecisionInfo::accepted)));
}

std::string decision_text(const DecisionInfo& info) {
  const signals::JointUpdateDecision& decision = info.decision;
  return info.joint + ' ' + signals::to_string(decision.phase) + ": " + signals::to_string(decision.verdict) +
         ", generation " + std::to_string(decision.generation) + ", poles " + short_number(decision.pole_distance) +
         " from the designed, spread " + short_number(decision.pole_spread) + ", validity " +
         short_number(decision.validity);
}

}  // namespace farrier::report
