#include "trials/body/body_trial.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

namespace farrier::trials {
namespace {

constexpr double kFallenShare = 0.5;
constexpr double kFallenTilt_rad = 0.25 * std::numbers::pi;

/// The trunk relative to the ground's plane.
struct Posture {
  double height_m;
  double tilt_rad;
};

Posture posture_of(const body::BodyState& state, const Eigen::Vector3d& normal) {
  const double cosine = normal.dot(state.attitude * Eigen::Vector3d::UnitZ());
  return {normal.dot(state.position_m), std::acos(std::clamp(cosine, -1.0, 1.0))};
}

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

const char* to_string(FallReason reason) noexcept {
  switch (reason) {
    case FallReason::kHeight:
      return "height";
    case FallReason::kTilt:
      return "tilt";
  }
  return "unknown reason";
}

BodyController::~BodyController() = default;

BodyFigures run_body_trial(world::BodyWorld& world, BodyController& controller, Tick ticks,
                           const BodyObserver& observer) {
  BodyFigures figures;
  std::vector<double> torques_Nm(world.joints(), 0.0);
  const Eigen::Vector3d normal = world.ground_normal();
  const Eigen::Vector3d start_m = world.state().position_m;
  const double start_height_m = posture_of(world.state(), normal).height_m;
  double height_squares_m2 = 0.0;
  double tilt_squares = 0.0;
  while (figures.ticks < ticks && figures.passes()) {
    controller.step(world, torques_Nm);
    if (observer && !observer()) {
      break;
    }
    if (!world.advance(torques_Nm)) {
      figures.failure = world.failure();
      break;
    }
    ++figures.ticks;
    note_loads(world, torques_Nm, figures);
    const Posture posture = posture_of(world.state(), normal);
    const double sag_m = posture.height_m - start_height_m;
    height_squares_m2 += sag_m * sag_m;
    tilt_squares += posture.tilt_rad * posture.tilt_rad;
    if (posture.height_m < kFallenShare * start_height_m || posture.tilt_rad > kFallenTilt_rad) {
      figures.fell = world.tick();
      figures.fall = posture.tilt_rad > kFallenTilt_rad ? FallReason::kTilt : FallReason::kHeight;
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
