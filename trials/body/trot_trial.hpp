#pragma once

#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "core/phase.hpp"
#include "core/result.hpp"
#include "trials/body/actuated_robot.hpp"
#include "trials/body/body_trial.hpp"
#include "trials/body/supply_judge.hpp"
#include "world/energy_audit.hpp"
#include "trials/body/trot_cases.hpp"

namespace farrier::trials {

/// By place in the leg and phase.
using ForceErrors = std::array<std::array<double, kPhaseCount>, body::kJointsPerLeg>;

/// The true motion of one case, and the errors of the controller's own estimate. Means are over the judged time.
struct TrotFigures {
  std::optional<double> fell_s;  ///< also when motion became so wild that it could not be simulated
  std::string fall;              ///< why it counts as fallen: "tilt", "height" or the fault of the simulation
  double height_rms_m = 0.0;     ///< of the trunk's origin above the ground's plane, about its mean
  double height_offset_m = 0.0;  ///< mean less the default height
  double sag_m = 0.0;            ///< largest depth below the default height, from the settled trot on
  /// The same from TrotCase::kLoadSettled_s after a load is put on. None of a case without a load.
  std::optional<double> loaded_sag_m = std::nullopt;
  double tilt_rms_rad = 0.0;  ///< between the trunk's z axis and the plane's normal
  double speed_error = 0.0;   ///< of the mean velocity, or turning on the spot of the mean yaw rate, relative
  std::optional<double> odometry_error;  ///< of the estimated way since the trot began, relative; none below 1 m
  double heading_drift_rad_s = 0.0;      ///< of the estimated heading, mean since the trot began, signed
  /// Way of the trunk to the left of the line that it was asked to follow, per time, signed. The line begins with the
  /// trot, in the direction of the command as the trunk then stood. None for a command that turns or has no direction.
  std::optional<double> lateral_drift_m_s = std::nullopt;
  double largest_torque_Nm = 0.0;
  /// Force error of HAA, HFE and KFE by the phase of the foot, over all legs: RMS over RMS of the reference. Zero of
  /// ideal joints.
  ForceErrors force_nrmse{};
  GainSwitches switches{};  ///< of the joints' gains, all legs and the whole run; 0 of ideal joints
  std::optional<AdaptationCounts> adaptation = std::nullopt;  ///< of a case that adapts
  /// Work of the pump that the account of supply, oil and body does not find again, relative to it; 0 without a pump.
  double energy_error = 0.0;
  double least_supply_Pa = 0.0;  ///< of the shared supply; 0 without a pump
  double mean_flow_m3_s = 0.0;   ///< that the pump gives to valves, without what the relief valve spills
  world::EnergyAudit energy{};   ///< of the pump's work from the judged time on; 0 without a pump
  double way_m = 0.0;            ///< of the trunk in the judged time, from its begin to its end
  int finer = 1;                 ///< the case's
  std::optional<SupplyFigures> supply = std::nullopt;  ///< of a case with a fault of the supply
  std::uint64_t hash = 0;                              ///< of all states of the run
};

/// The IMU of world::kImuNoise, and assumed noise of encoders and of torques that are computed from forces.
inline constexpr world::BodyNoise kTrotNoise = [] {
  world::BodyNoise noise = world::kImuNoise;
  noise.angle_rad = 4.4e-5;
  noise.velocity_rad_s = 0.033;
  noise.torque_Nm = 0.5;
  return noise;
}();

/// The drives of a trial's joints: ideal torques with kTrotNoise, or the robot's actuators with their sensors.
enum class Joints { kIdeal, kActuators };

/// Runs one case: the robot's TrotController with its own estimate, in a world of its own. False by `keep_on` ends it
/// with nothing. Actuators tell the `listener` their measurements. Refuses a robot without body or locomotion, a scene
/// that does not fit, and what ActuatedRobot refuses.
Result<std::optional<TrotFigures>> run_trot_case(const robot::Robot& robot, const TrotCase& one, Joints joints,
                                                 const std::function<bool()>& keep_on = {},
                                                 const ActuatedRobot::Listener& listener = {});

/// A case that was run.
struct TrotRow {
  std::string trial, name;
  TrotFigures figures;
  std::string failure;  ///< why there are no figures; empty: there are
};

/// A case and its robot, which outlives the run.
struct TrotJob {
  const robot::Robot* robot;
  TrotCase one;
};

/// Runs the jobs on so many threads. Tells `done` of each as it comes, one at a time; false by `keep_on` ends all.
void run_trot_jobs(std::span<const TrotJob> jobs, Joints joints, int threads,
                   const std::function<void(const TrotRow&)>& done, const std::function<bool()>& keep_on);

/// One job for each case.
std::vector<TrotJob> jobs_of(const robot::Robot& robot, std::span<const TrotCase> cases);

}  // namespace farrier::trials
