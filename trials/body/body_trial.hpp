#pragma once

// A trial of the whole robot, in process and without a bus:
//
//   world ── readings ──▶ BodyController ── torques ──▶ world, once a tick.
//
// The world is a BodyWorld with ideal joints or an ActuatedRobot.

#include <Eigen/Core>
#include <array>
#include <functional>
#include <optional>
#include <span>
#include <string>

#include "body/model/body_model.hpp"
#include "core/time.hpp"
#include "body/model/posture.hpp"
#include "world/body_world.hpp"
#include "world/world.hpp"

namespace farrier::trials {

/// Control of the whole robot. It sees readings alone, as a process would.
class BodyController {
 public:
  virtual ~BodyController();

  /// Writes the torques of all joints (Nm) for the readings of the present tick.
  virtual void step(const world::World& world, std::span<double> torques_Nm) noexcept = 0;

 protected:
  BodyController() = default;
  BodyController(const BodyController&) = default;
  BodyController& operator=(const BodyController&) = default;
};

using body::FallReason;

/// The true motion of a trial, which no controller knows.
struct BodyFigures {
  Tick ticks = 0;                      ///< simulated
  std::optional<Tick> fell;            ///< first tick in which it counts as fallen, which ends the trial
  std::optional<FallReason> fall;      ///< of that tick; the tilt if both hold
  std::optional<std::string> failure;  ///< of the simulation
  double height_rms_m = 0.0;           ///< about the height of the start, above the ground's plane
  double tilt_rms_rad = 0.0;           ///< angle between the trunk's z axis and the ground's normal
  Eigen::Vector2d travel_m = Eigen::Vector2d::Zero();           ///< in the world, from start to end
  std::array<double, body::kJointsPerLeg> largest_torque_Nm{};  ///< of HAA, HFE and KFE, over all legs
  double largest_foot_force_N = 0.0;                            ///< mean of a tick

  /// True if the robot is upright at the end of a complete simulation.
  bool passes() const noexcept { return !fell && !failure; }
};

/// Called at every tick after the controller's step, before the world moves. False ends the trial.
using BodyObserver = std::function<bool()>;

/// Runs a trial for that many ticks, or until the robot falls or the simulation fails. The robot takes torques; `body` is
/// the truth of its body. With `may_sink` a low trunk is no fall.
BodyFigures run_body_trial(world::World& robot, const world::BodyWorld& body, BodyController& controller, Tick ticks,
                           const BodyObserver& observer = {}, bool may_sink = false);

/// The same of ideal joints.
inline BodyFigures run_body_trial(world::BodyWorld& world, BodyController& controller, Tick ticks,
                                  const BodyObserver& observer = {}) {
  return run_body_trial(world, world, controller, ticks, observer);
}

}  // namespace farrier::trials
