#pragma once

#include <Eigen/Core>
#include <optional>

#include "core/motion.hpp"
#include "core/time.hpp"
#include "gait/schedule.hpp"
#include "locomotion/body_model.hpp"

namespace farrier::locomotion {

/// One reading of the inertial measurement unit at the trunk's origin, trunk frame.
struct ImuReading {
  Eigen::Vector3d angular_velocity_rad_s = Eigen::Vector3d::Zero();
  Eigen::Vector3d specific_force_m_s2 = Eigen::Vector3d::Zero();  ///< (0, 0, +9.81) for an upright trunk at rest
};

/// Everything a controller reads at one tick.
struct Readings {
  PerLeg<LegReadings> legs;
  ImuReading imu;
};

using Request = MotionRequest;

/// Command of the operator.
struct MotionCommand {
  Request request = Request::kLie;
  double forward_m_s = 0.0;     ///< vx, in the heading frame
  double left_m_s = 0.0;        ///< vy
  double yaw_rate_rad_s = 0.0;  ///< positive to the left
  double height_m = 0.0;        ///< trunk's origin above the ground; 0 selects the default
  bool at_once = false;         ///< brakes and sits down several times as fast, and does not settle before
  bool feet_down = false;       ///< with at_once: no further foot lifts off, though the robot still moves
  bool weak_supply = false;     ///< joints may lack torque because the supply is weak, so none counts as dead
};

/// Joint torques of each leg, Nm, in the order HAA, HFE, KFE.
using LegTorques = PerLeg<Eigen::Vector3d>;

struct LocomotionState;

/// A controller of the whole robot. Locomotion's process calls it once a tick; a user's own controller implements it.
class Controller {
 public:
  virtual ~Controller() = default;

  /// Takes the readings of tick `now` and returns the torques for tick now + 1. Allocates nothing and has no clock.
  virtual const LegTorques& step(Tick now, const Readings& readings, const MotionCommand& command) noexcept = 0;

  /// The change of phase of a leg that the last step announced, or a touchdown that it felt. Joints choose their gains by
  /// it. Counts rise by one. None by default.
  virtual std::optional<gait::PhaseSwitch> announcement(int leg) const noexcept {
    static_cast<void>(leg);
    return std::nullopt;
  }

  /// State after the last step for the topic body/state. Null, the default, publishes none.
  virtual const LocomotionState* published_state() const noexcept { return nullptr; }
};

}  // namespace farrier::locomotion
