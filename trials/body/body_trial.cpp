#include "trials/body/body_trial.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

namespace farrier::trials {
namespace {

void note_loads(const world::BodyWorld& world, std::span<const double> torques_Nm, BodyFigures& figures) {
  for (std::size_t joint = 0; joint < torques_Nm.size(); ++joint) {
    double& largest_Nm = figures.largest_torque_Nm[joint % body::kJointsPerLeg];
    largest_Nm = std::max(largest_Nm, std::abs(torques_Nm[joint]));
  }
  for (int leg = 0; leg < world.body().legs(); ++leg) {
    figures.largest_foot_force_N = std::max(figures.largest_foot_force_N, world.foot_force_N(leg).norm());
  }
}

}  // namespace

BodyController::~BodyController() = default;

BodyFigures run_body_trial(world::World& robot, const world::BodyWorld& world, BodyController& controller, Tick ticks,
                           const BodyObserver& observer, bool may_sink) {
  BodyFigures figures;
  std::vector<double> torques_Nm(world.joints(), 0.0);
  const Eigen::Vector3d normal = world.ground_normal();
  const Eigen::Vector3d start_m = world.state().position_m;
  const double start_height_m = body::posture_of(start_m, world.state().attitude, normal).height_m;
  double height_squares_m2 = 0.0;
  double tilt_squares = 0.0;
  while (figures.ticks < ticks && figures.passes()) {
    controller.step(robot, torques_Nm);
    if (observer && !observer()) {
      break;
    }
    if (!robot.advance(torques_Nm)) {
      figures.failure = robot.failure();
      break;
    }
    ++figures.ticks;
    note_loads(world, torques_Nm, figures);
    const body::Posture posture = body::posture_of(world.state().position_m, world.state().attitude, normal);
    const double sag_m = posture.height_m - start_height_m;
    height_squares_m2 += sag_m * sag_m;
    tilt_squares += posture.tilt_rad * posture.tilt_rad;
    figures.fall = body::fall_of(posture, start_height_m);
    if (may_sink && figures.fall == FallReason::kHeight) {
      figures.fall.reset();
    }
    if (figures.fall) {
      figures.fell = world.tick();
    }
  }
  if (figures.ticks > 0) {
    const auto count = static_cast<double>(figures.ticks);
    figures.height_rms_m = std::sqrt(height_squares_m2 / count);
    figures.tilt_rms_rad = std::sqrt(tilt_squares / count);
  }
  figures.travel_m = (world.state().position_m - start_m).head<2>();
  return figures;
}

}  // namespace farrier::trials
