#pragma once

#include "gait/gait_params.hpp"
#include "locomotion/controller.hpp"
#include "locomotion/foothold.hpp"
#include "locomotion/force_distribution.hpp"
#include "locomotion/ground_plane.hpp"
#include "locomotion/guards/joint_guard.hpp"
#include "locomotion/leg_controller.hpp"
#include "locomotion/leg_sequencer.hpp"
#include "locomotion/mode_sequencer.hpp"
#include "locomotion/payload/payload_estimator.hpp"
#include "locomotion/phase_announcer.hpp"
#include "locomotion/state_estimator.hpp"
#include "locomotion/swing_trajectory.hpp"
#include "locomotion/trot_schedule.hpp"
#include "locomotion/trunk_reference.hpp"
#include "locomotion/trunk_wrench.hpp"

namespace farrier::locomotion {

/// A leg's place on the trunk and its folded pose.
struct LegMount {
  Eigen::Vector3d hip_m = Eigen::Vector3d::Zero();       ///< HAA axis in the leg's plane, trunk frame
  double outward = 1.0;                                  ///< +1 for a left leg, -1 for a right one
  Eigen::Vector3d folded_rad = Eigen::Vector3d::Zero();  ///< joint angles of a robot that lies
};

/// All parameters of locomotion. The schedule's are in gait::GaitParams.
struct LocomotionParams {
  PerLeg<LegMount> mounts;
  StateEstimatorParams estimator;
  LegSequencerParams contact;
  FeltTouchdownParams felt_touchdown;
  GroundPlaneParams ground;
  TrunkReferenceParams reference;
  TrunkWrenchParams trunk;
  PayloadParams payload;
  ForceDistributionParams forces;
  FootholdParams foothold;
  SwingParams swing;
  LegControllerParams leg;
  ModeSequencerParams mode;
  JointGuardParams joint_guard;
};

/// State of the controller after one tick, for body/state, logs and tests.
struct LocomotionState {
  Mode mode = Mode::kLie;
  TrunkState trunk, wanted;
  Wrench wrench = Wrench::Zero();
  Payload payload;      ///< estimated
  AssumedMass assumed;  ///< by which the wrench is computed and distributed
  PerLeg<LegAction> actions{};
  PerLeg<Eigen::Vector3d> forces_N;       ///< wanted forces of the ground on the feet, world frame
  PerLeg<Eigen::Vector3d> felt_forces_N;  ///< by the joint torques, world frame
  PerLeg<Eigen::Vector3d> footholds_m;    ///< where the foot stands or is going to, world frame
  std::optional<LegJoint> dead_joint;     ///< does not follow, so the robot lies down
};

/// Trot controller for a robot with legs of three joints. It estimates the state, plans trunk and feet, distributes the
/// trunk's wrench over the feet on the ground, and commands joint torques for the next tick.
///
///   readings -> StateEstimator -> LegSequencer -> GroundPlane, TrunkReference -> TrunkWrench
///            -> ForceDistribution -> LegController -> torques.
///
/// The method is that of MIT's Cheetah 3 with its balance controller (Bledt et al. 2018; Focchi et al. 2016). Footholds
/// are after Raibert (1986).
class TrotController final : public Controller {
 public:
  /// `plan` must pass gait::validate() and have the model's legs. `model` must outlive the controller.
  TrotController(const LocomotionParams& params, const gait::RobotPlan& plan, const BodyModel& model);

  const LegTorques& step(Tick now, const Readings& readings, const MotionCommand& asked) noexcept override;

  std::optional<gait::PhaseSwitch> announcement(int leg) const noexcept override {
    return announcers_[leg].announcement();
  }
  const LocomotionState* published_state() const noexcept override { return &state_; }

  const LocomotionState& state() const noexcept { return state_; }
  const TrotSchedule& schedule() const noexcept { return schedule_; }
  const StateEstimator& estimator() const noexcept { return estimator_; }
  const ForceDistribution& force_distribution() const noexcept { return distribution_; }

 private:
  /// True if every joint has about the torque that was commanded last.
  bool obeyed(const Readings& readings) const noexcept;
  void estimate(const Readings& readings) noexcept;
  void sequence_legs(Tick now) noexcept;
  void plan_trunk(const MotionCommand& command) noexcept;
  void plan_swing(int leg) noexcept;
  bool on_its_feet() const noexcept;
  void estimate_payload(const Readings& readings) noexcept;
  void distribute() noexcept;
  void command_legs(const Readings& readings) noexcept;
  double trust(int leg) const noexcept;
  double load_limit_N(int leg) const noexcept;

  LocomotionParams params_;
  const BodyModel& model_;
  int legs_;
  TrotSchedule schedule_;
  StateEstimator estimator_;
  GroundPlane ground_;
  TrunkReference reference_;
  TrunkWrench trunk_;
  PayloadEstimator payload_;
  ForceDistribution distribution_;
  LegController leg_controller_;
  ModeSequencer mode_;
  JointGuard joint_guard_;
  PerLeg<LegSequencer> sequencers_;
  PerLeg<PhaseAnnouncer> announcers_;
  PerLeg<SwingTrajectory> swings_;
  PerLeg<gait::PointMotion> foot_references_;
  PerLeg<Eigen::Vector3d> touchdowns_;     // last place on the ground of each foot's lowest point, world frame
  PerLeg<Eigen::Vector3d> first_pose_;     // joint angles from which the soft start begins
  PerLeg<Eigen::Vector3d> accelerations_;  // joint accelerations commanded last
  LegTorques torques_;
  bool started_ = false;
  LocomotionState state_;
};

}  // namespace farrier::locomotion
