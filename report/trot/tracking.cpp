#include "report/trot/tracking.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/ensure.hpp"
#include "core/fault.hpp"
#include "robot/derive.hpp"
#include "signals/signals.hpp"

namespace farrier::report {
namespace {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
constexpr int kFirstJudgedStride = 2;     // the third
constexpr double kSettling_s = 1.0;       // of a robot that only stands, after its lead-in
constexpr double kSmallestScale = 0.05;   // of the rating: a reference at rest asks for no better than this
constexpr std::size_t kJointsOfALeg = 3;  // HAA, HFE, KFE
constexpr int kKnee = 2;

/// Mean and spread of the reference by Welford's recursion (1962), which does not cancel as sums of squares do.
class PhaseSums {
 public:
  void add(double reference, double force) noexcept {
    const double error = reference - force;
    ++ticks_;
    error_squares_ += error * error;
    const double from_mean = reference - mean_;
    mean_ += from_mean / static_cast<double>(ticks_);
    reference_squares_ += from_mean * (reference - mean_);
  }

  PhaseError result(double rating) const noexcept {
    const auto n = static_cast<double>(ticks_);
    PhaseError result{.ticks = ticks_,
                      .rms_error = std::sqrt(error_squares_ / n),
                      .rms_reference = std::sqrt(reference_squares_ / n),
                      .nrmse = kNan};
    // In this order std::max keeps a reference that is not a number.
    result.nrmse = result.rms_error / std::max(result.rms_reference, kSmallestScale * rating);
    return result;
  }

 private:
  std::uint64_t ticks_ = 0;
  double mean_ = 0.0, reference_squares_ = 0.0, error_squares_ = 0.0;
};

struct JointSums {
  Tick first_judged = 0;
  PhaseSums stance, swing;
  double lowest = std::numeric_limits<double>::infinity(), highest = -lowest;
  bool position_finite = true;
  std::uint64_t missed_ticks = 0;
  std::uint64_t not_tracking_ticks = 0;
  bool tripped = false;

  void add(const trace::TraceRow& row, gait::Phase planned, int loop_delay_ticks) noexcept {
    (planned == gait::Phase::kStance ? stance : swing).add(row.force_reference_N_or_Nm, row.force_N_or_Nm);
    lowest = std::min(lowest, row.position_m_or_rad);
    highest = std::max(highest, row.position_m_or_rad);
    position_finite = position_finite && std::isfinite(row.position_m_or_rad);
    not_tracking_ticks += row.state != signals::JointState::kTracking ? 1 : 0;
    missed_ticks += row.command_age_ticks > static_cast<std::uint32_t>(loop_delay_ticks) ? 1 : 0;
  }

  // The angle is monotonous in the position, so the ends of one are the ends of the other.
  double travel_rad(const plant::Linkage& linkage) const noexcept {
    return position_finite && lowest <= highest ? std::abs(linkage.angle(highest) - linkage.angle(lowest)) : kNan;
  }
};

int completed_strides(const robot::Robot& robot, const gait::Schedule& schedule, Tick ticks) {
  int strides = std::numeric_limits<int>::max();
  for (int leg = 0; leg < static_cast<int>(robot.plan.legs.size()); ++leg) {
    strides = std::min(strides, schedule.stride(leg, ticks));
  }
  return std::max(0, robot.plan.legs.empty() ? 0 : strides);
}

const robot::JointTemplate& template_of(const robot::Robot& robot, const robot::Joint& joint) {
  const robot::Leg& leg = robot.file.legs.at(static_cast<std::size_t>(joint.leg)).second;
  return *config::find(robot.file.joints, leg.joints.at(static_cast<std::size_t>(joint.index_in_leg)).second);
}

// A rig whose joint is its piston moves in metres.
bool turns(const robot::Robot& robot, const robot::Joint& joint) {
  return rating_of(robot, joint).rotary ||
         config::find(robot.file.linkages, template_of(robot, joint).linkage)->triangle.has_value();
}

}  // namespace

Rating rating_of(const robot::Robot& robot, const robot::Joint& joint) {
  const robot::JointTemplate& from = template_of(robot, joint);
  if (const auto* electric = config::find(robot.file.electric_actuators, from.actuator)) {
    return {robot::rated_torque_Nm(*electric), true};
  }
  const robot::Actuator& actuator = *config::find(robot.file.actuators, from.actuator);
  return actuator.cylinder ? Rating{actuator.cylinder->rated_force_N, false}
                           : Rating{actuator.rotary_motor->rated_torque_Nm, true};
}

Tick first_judged_tick(const robot::Robot& robot, const gait::Schedule& schedule, int leg) {
  if (robot.plan.gait.pattern == gait::Pattern::kStand) {
    return schedule.lead_in_ticks() + std::llround(kSettling_s / robot.period_s);
  }
  // The first lift-off comes within a stride of the lead-in, every leg's first touchdown within another.
  const Tick latest = schedule.lead_in_ticks() + (kFirstJudgedStride + 3) * schedule.stride_ticks();
  Tick tick = 0;
  while (tick < latest && schedule.stride(leg, tick) < kFirstJudgedStride) {
    ++tick;
  }
  return tick;
}

Tracking track(const robot::Robot& robot, const gait::Schedule& schedule, std::span<const trace::TraceRow> rows,
               int loop_delay_ticks) {
  std::vector<JointSums> sums(robot.joints.size());
  for (const robot::Joint& joint : robot.joints) {
    sums[joint.number].first_judged = first_judged_tick(robot, schedule, joint.leg);
  }
  Tracking tracking;
  for (const trace::TraceRow& row : rows) {
    FARRIER_ENSURE(row.joint < sums.size(), "a trace row of a joint the robot does not have");
    tracking.ticks = std::max(tracking.ticks, row.tick + 1);
    sums[row.joint].tripped = sums[row.joint].tripped || FaultSet(row.faults).has(Fault::kTripped);
    if (row.tick >= sums[row.joint].first_judged) {
      sums[row.joint].add(row, schedule.phase(robot.joints[row.joint].leg, row.tick), loop_delay_ticks);
    }
  }
  for (const robot::Joint& joint : robot.joints) {
    const JointSums& of_joint = sums[joint.number];
    const double rating = rating_of(robot, joint).force;
    tracking.joints.push_back({.stance = of_joint.stance.result(rating),
                               .swing = of_joint.swing.result(rating),
                               .travel_rad = of_joint.travel_rad(joint.linkage),
                               .missed_ticks = of_joint.missed_ticks,
                               .not_tracking_ticks = of_joint.not_tracking_ticks,
                               .tripped = of_joint.tripped});
  }
  tracking.strides = completed_strides(robot, schedule, tracking.ticks);
  return tracking;
}

bool long_enough(const robot::Robot& robot, const Tracking& tracking) {
  const bool swings = robot.plan.gait.pattern == gait::Pattern::kTrot;
  return std::ranges::all_of(tracking.joints, [&](const JointTracking& joint) {
    return joint.stance.ticks > 0 && (!swings || joint.swing.ticks > 0);
  });
}

void add_tracking(Figures& figures, const robot::Robot& robot, const Tracking& tracking, Judgement judgement) {
  const bool lockstep = judgement == Judgement::kLockstep;
  const auto judged = [&](bool applies, double bound) {
    return applies && lockstep && robot.bounds.judged ? std::optional(bound) : std::nullopt;
  };
  const bool legs_move = robot.plan.gait.pattern == gait::Pattern::kTrot &&
                         robot.plan.gait.reference == gait::ReferenceKind::kLegKinematics;
  figures.add("trot.ticks", static_cast<double>(tracking.ticks));
  figures.add("trot.strides", tracking.strides);
  figures.add("trot.tripped_joints",
              static_cast<double>(std::ranges::count_if(tracking.joints, &JointTracking::tripped)), 0.0);
  for (const robot::Joint& joint : robot.joints) {
    const JointTracking& of_joint = tracking.joints[joint.number];
    const bool knee = joint.index_in_leg == kKnee &&
                      robot.plan.legs[static_cast<std::size_t>(joint.leg)].joints.size() == kJointsOfALeg;
    const std::string prefix = "trot." + joint.name + ".";
    figures.add(prefix + "stance_nrmse", of_joint.stance.nrmse, judged(true, robot.bounds.stance_nrmse));
    if (of_joint.swing.ticks > 0) {
      figures.add(prefix + "swing_nrmse", of_joint.swing.nrmse);
    }
    figures.add(prefix + "missed_ticks", static_cast<double>(of_joint.missed_ticks),
                lockstep ? std::optional(0.0) : std::nullopt);
    figures.add(prefix + "not_tracking_ticks", static_cast<double>(of_joint.not_tracking_ticks),
                lockstep ? std::optional(0.0) : std::nullopt);
    if (turns(robot, joint)) {
      figures.add(prefix + "travel_rad", of_joint.travel_rad, judged(knee && legs_move, kKneeTravel_rad));
    }
  }
}

void add_swing_design_tracking(Figures& figures, const robot::Robot& robot, const Tracking& tracking) {
  for (const robot::Joint& joint : robot.joints) {
    const JointTracking& of_joint = tracking.joints[joint.number];
    figures.add("trot." + joint.name + ".swing_design_stance_nrmse", of_joint.stance.nrmse);
    if (of_joint.swing.ticks > 0) {
      figures.add("trot." + joint.name + ".swing_design_swing_nrmse", of_joint.swing.nrmse);
    }
  }
}

}  // namespace farrier::report
