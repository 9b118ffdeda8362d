#include "locomotion/trot_controller.hpp"

#include <Eigen/Geometry>
#include <algorithm>

#include "gait/smooth_step.hpp"
#include "locomotion/rotation.hpp"

namespace farrier::locomotion {
namespace {

// A foot that just touched down or is about to lift off may still carry this much.
constexpr double kLeastLimit_N = 1.0;

// Largest difference of a joint's torque from its command while it obeys: HyQ's joints keep 5 Nm in the soft start.
constexpr double kObeyed_Nm = 50.0;

JointDuty duty_in(Mode mode) noexcept {
  return mode == Mode::kLie || mode == Mode::kFallen ? JointDuty::kNone
         : mode == Mode::kTrot                       ? JointDuty::kWalk
                                                     : JointDuty::kStand;
}

}  // namespace

TrotController::TrotController(const LocomotionParams& params, const gait::RobotPlan& plan, const BodyModel& model)
    : params_(params),
      model_(model),
      legs_(model.leg_count()),
      schedule_(plan),
      estimator_(params.estimator, model, plan.period_s),
      ground_(params.ground, plan.period_s),
      reference_(params.reference, plan.period_s),
      trunk_(params.trunk, model.mass_kg(), plan.period_s),
      payload_(params.payload, model.mass_kg(), plan.period_s),
      distribution_(params.forces),
      leg_controller_(params.leg),
      mode_(params.mode, plan.period_s),
      joint_guard_(params.joint_guard, params.leg.torque_limit_Nm, legs_, plan.period_s),
      sequencers_(for_every_leg(LegSequencer(params.contact, plan.period_s))),
      announcers_(for_every_leg(PhaseAnnouncer(params.felt_touchdown, plan.period_s))),
      swings_(for_every_leg(SwingTrajectory(params.swing))) {
  FARRIER_ENSURE(legs_ == static_cast<int>(plan.legs.size()), "gait plan and body model differ in their legs");
  for (auto* vectors :
       {&touchdowns_, &accelerations_, &torques_, &state_.forces_N, &state_.felt_forces_N, &state_.footholds_m}) {
    vectors->fill(Eigen::Vector3d::Zero());
  }
}

const LegTorques& TrotController::step(Tick now, const Readings& readings, const MotionCommand& asked) noexcept {
  estimate(readings);
  const Mode before = mode_.mode();
  joint_guard_.step(readings, torques_, asked.weak_supply ? JointDuty::kNone : duty_in(before));
  const MotionCommand command = joint_guard_.command(asked, before == Mode::kLie);
  state_.dead_joint = joint_guard_.dead();
  // Joints that are not armed do not obey. The soft start waits for them in the pose that they have: a torque that grew
  // with their distance from the folded pose would make the legs give way when they are armed.
  if (mode_.mode() == Mode::kLie && !obeyed(readings)) {
    mode_.restart();
    started_ = false;
  }
  mode_.step(now, command, state_.trunk.rotation(2, 2), reference_, schedule_);
  state_.mode = mode_.mode();
  schedule_.step(now);
  sequence_legs(now);
  plan_trunk(command);
  estimate_payload(readings);
  distribute();
  command_legs(readings);
  return torques_;
}

bool TrotController::obeyed(const Readings& readings) const noexcept {
  for (int leg = 0; leg < legs_; ++leg) {
    if (!((readings.legs[leg].torque_Nm - torques_[leg]).cwiseAbs().maxCoeff() <= kObeyed_Nm)) {
      return false;
    }
  }
  return true;
}

// Trust in a standing foot falls at both ends of its stance, as it was and as it is planned.
double TrotController::trust(int leg) const noexcept {
  if (!sequencers_[leg].stands()) {
    return 0.0;
  }
  const double since_touchdown = sequencers_[leg].since_s() / schedule_.stance_s();
  const double planned = schedule_.stance_progress(leg);
  const double load = mode_.force_share() < 1.0
                          ? 1.0
                          : std::clamp(state_.felt_forces_N[leg].z() / params_.estimator.trusted_force_N, 0.0, 1.0);
  return load * std::min(estimator_.base().trust(std::min(since_touchdown, 0.5)),
                         estimator_.base().trust(std::max(planned, 0.5)));
}

void TrotController::estimate(const Readings& readings) noexcept {
  PerLeg<double> trusts{};
  for (int leg = 0; leg < legs_; ++leg) {
    trusts[leg] = trust(leg);
  }
  estimator_.update(readings, trusts, mode_.standing(), accelerations_);
  state_.trunk = estimator_.trunk();
}

void TrotController::sequence_legs(Tick now) noexcept {
  const Eigen::Vector3d normal = ground_.normal();
  for (int leg = 0; leg < legs_; ++leg) {
    const Eigen::Vector3d foot = estimator_.foot_m(leg);
    state_.felt_forces_N[leg] = estimator_.ground_force_N(leg);
    // a foot that carries no load by force control cannot lose the ground
    const double speed = mode_.force_share() >= 1.0 ? normal.dot(estimator_.foot_velocity_m_s(leg)) : 0.0;
    const double force_N = normal.dot(state_.felt_forces_N[leg]);
    sequencers_[leg].step(schedule_.swing_progress(leg), force_N, speed);
    announcers_[leg].step(now, {.planned = schedule_.announcement(leg),
                                .phase = schedule_.phase(leg),
                                .stands = sequencers_[leg].stands(),
                                .normal_force_N = force_N});
    if (sequencers_[leg].lifted_off()) {
      swings_[leg].lift_off(foot);
    }
    if (sequencers_[leg].stands()) {
      touchdowns_[leg] = foot - params_.estimator.foot_radius_m * normal;
    }
    state_.actions[leg] = sequencers_[leg].action();
  }
}

void TrotController::plan_trunk(const MotionCommand& command) noexcept {
  const TrunkState& trunk = state_.trunk;
  ground_.update(touchdowns_, legs_, trunk.position_m, heading_of(trunk.rotation));
  if (mode_.mode() == Mode::kLie || (mode_.entered() && mode_.mode() == Mode::kStandUp && mode_.force_share() <= 0.0)) {
    reference_.reset(trunk, trunk.position_m.z() - ground_.height_at(trunk.position_m));
    trunk_.reset_integrals();
  }
  reference_.step(command, mode_.moving(), mode_.height_m(command, reference_), trunk, ground_);
  state_.wanted = reference_.wanted();
  for (int leg = 0; leg < legs_; ++leg) {
    if (!sequencers_[leg].stands()) {
      plan_swing(leg);
    }
  }
}

void TrotController::plan_swing(int leg) noexcept {
  const TrunkState& trunk = state_.trunk;
  const LegMount& mount = params_.mounts[leg];
  const Eigen::Matrix3d heading = heading_of(trunk.rotation);
  Eigen::Vector3d neutral = mount.hip_m + Eigen::Vector3d{0.0, mount.outward * params_.foothold.wider_m, 0.0};
  neutral.head<2>() += estimator_.body().com_m.head<2>();
  const Eigen::Vector3d from_trunk = heading * neutral;
  const double progress = schedule_.swing_progress(leg);
  const double rest_s = progress >= 0.0 ? (1.0 - progress) * schedule_.swing_s() : 0.0;
  if (sequencers_[leg].action() == LegAction::kSwing) {
    Eigen::Vector3d place = foothold(params_.foothold, {.hip_m = trunk.position_m + from_trunk,
                                                        .from_trunk_m = from_trunk,
                                                        .velocity_m_s = trunk.velocity_m_s,
                                                        .wanted_velocity_m_s = state_.wanted.velocity_m_s,
                                                        .wanted_yaw_rate_rad_s = reference_.yaw_rate_rad_s(),
                                                        .rest_s = rest_s,
                                                        .stance_s = schedule_.stance_s()});
    place.z() = ground_.height_at(place) + params_.estimator.foot_radius_m;
    state_.footholds_m[leg] = place;
    foot_references_[leg] = swings_[leg].at(progress, schedule_.swing_s(), place);
  } else {
    if (sequencers_[leg].lost()) {
      // from where the foot is, or from the end of its path
      state_.footholds_m[leg] = estimator_.foot_m(leg) + Eigen::Vector3d{0.0, 0.0, params_.swing.press_m};
    }
    foot_references_[leg] = swings_[leg].reach(sequencers_[leg].since_s(), state_.footholds_m[leg]);
  }
}

// Upper limit of a foot's normal force: the torques of its joints, with ramps after touchdown and before lift-off.
double TrotController::load_limit_N(int leg) const noexcept {
  const Eigen::Vector3d normal = state_.trunk.rotation.transpose() * ground_.normal();
  const double full = leg_controller_.largest_force_N(estimator_.body().legs[leg], normal);
  const auto ramp = [](double time_s, double length_s) {
    return length_s > 0.0 ? std::clamp(time_s / length_s, 0.0, 1.0) : 1.0;
  };
  const double planned = schedule_.stance_progress(leg);
  const double to_lift_off_s = (1.0 - std::max(planned, 0.0)) * schedule_.stance_s();
  const double share =
      std::min(ramp(sequencers_[leg].since_s(), params_.leg.load_in_s), ramp(to_lift_off_s, params_.leg.load_out_s));
  return std::max(kLeastLimit_N, mode_.force_share() * share * full);
}

// The balance of forces holds while nothing but the feet carries the robot.
bool TrotController::on_its_feet() const noexcept {
  const Mode mode = mode_.mode();
  int standing = 0;
  for (int leg = 0; leg < legs_; ++leg) {
    standing += sequencers_[leg].stands() ? 1 : 0;
  }
  return mode_.force_share() >= 1.0 && (mode == Mode::kStand || mode == Mode::kTrot || mode == Mode::kStop) &&
         standing >= 2;
}

void TrotController::estimate_payload(const Readings& readings) noexcept {
  if (mode_.mode() == Mode::kLie) {
    payload_.reset();
  }
  const Eigen::Vector3d com = estimator_.body().com_m;
  if (on_its_feet()) {
    const Eigen::Matrix3d to_trunk = state_.trunk.rotation.transpose();
    ForceBalance balance{.specific_force_m_s2 = readings.imu.specific_force_m_s2, .up = to_trunk.col(2), .com_m = com};
    for (int leg = 0; leg < legs_; ++leg) {
      if (sequencers_[leg].stands()) {
        const Eigen::Vector3d force = to_trunk * state_.felt_forces_N[leg];
        balance.wanted_lift_N += state_.forces_N[leg].z();  // of the last tick
        balance.force_N += force;
        balance.moment_Nm += (to_trunk * (touchdowns_[leg] - state_.trunk.position_m)).cross(force);
      }
    }
    payload_.update(balance);
  }
  payload_.assume(com);
  state_.payload = payload_.payload();
  state_.assumed = payload_.assumed();
}

void TrotController::distribute() noexcept {
  trunk_.set_mass(state_.assumed.mass_kg);
  state_.wrench = trunk_.step(state_.wanted, state_.trunk, mode_.force_share());
  const Eigen::Vector3d normal = ground_.normal();
  const Eigen::Vector3d com =
      state_.trunk.position_m + state_.trunk.rotation * (estimator_.body().com_m + state_.assumed.shift_m);
  PerLeg<Contact> contacts;
  PerLeg<int> numbers{};
  PerLeg<Eigen::Vector3d> forces;
  int count = 0;
  for (int leg = 0; leg < legs_; ++leg) {
    state_.forces_N[leg].setZero();
    if (sequencers_[leg].stands()) {
      numbers[count] = leg;
      contacts[count++] = {.lever_m = touchdowns_[leg] - com, .normal = normal, .limit_N = load_limit_N(leg)};
    }
  }
  distribution_.distribute(state_.wrench, contacts, count, forces);
  for (int i = 0; i < count; ++i) {
    state_.forces_N[numbers[i]] = forces[i];
  }
}

void TrotController::command_legs(const Readings& readings) noexcept {
  const TrunkState& trunk = state_.trunk;
  const Eigen::Matrix3d to_trunk = trunk.rotation.transpose();
  const double pose_gain = 1.0 - mode_.force_share();
  const double to_folded = gait::smooth_step(mode_.soft_start()).value;
  for (int leg = 0; leg < legs_; ++leg) {
    const LegState& state = estimator_.body().legs[leg];
    accelerations_[leg].setZero();
    // The soft start moves the pose from where the joints are, so no torque jumps and no leg gives way.
    if (!started_) {
      first_pose_[leg] = readings.legs[leg].position_rad;
    }
    const Eigen::Vector3d folded = first_pose_[leg] + to_folded * (params_.mounts[leg].folded_rad - first_pose_[leg]);
    Eigen::Vector3d torque;
    if (mode_.mode() == Mode::kFallen) {
      torque = leg_controller_.damp(readings.legs[leg]);
    } else if (sequencers_[leg].stands()) {
      torque = leg_controller_.pose(readings.legs[leg], folded, pose_gain) +
               leg_controller_.stance(state, to_trunk * state_.forces_N[leg]);
    } else {
      const gait::PointMotion& foot = foot_references_[leg];
      const Eigen::Vector3d from_trunk = foot.position - trunk.position_m;
      const Eigen::Vector3d relative =
          foot.velocity - trunk.velocity_m_s - trunk.angular_velocity_rad_s.cross(from_trunk);
      const FootReference local{
          .position_m = leg_controller_.within_reach(params_.mounts[leg].hip_m, to_trunk * from_trunk),
          .velocity_m_s = to_trunk * relative,
          .acceleration_m_s2 = to_trunk * foot.acceleration};
      torque = leg_controller_.swing(state, local, accelerations_[leg]);
    }
    torques_[leg] = leg_controller_.limited(torque);
  }
  started_ = true;
}

}  // namespace farrier::locomotion
