#include "body/scene/scene.hpp"

#include <algorithm>
#include <cmath>

#include "core/portable_math.hpp"

namespace farrier::body {
namespace {

// Depth by which a foot may rest in the ground at the start: more than its weight presses it in.
constexpr double kRestingDepth_m = 1e-3;

Eigen::Quaterniond turn(const Eigen::Vector3d& axis, double angle_rad) noexcept {
  const portable::SineCosine half = portable::sincos(0.5 * angle_rad);
  const Eigen::Vector3d imaginary = half.sine * axis;
  return {half.cosine, imaginary.x(), imaginary.y(), imaginary.z()};
}

// Distance of a point from a box; negative inside by the depth.
double distance_m(const Box& box, const Eigen::Vector3d& point_m) noexcept {
  const Eigen::Vector3d local_m = box.attitude.toRotationMatrix().transpose() * (point_m - box.centre_m);
  const Eigen::Vector3d beyond_m = local_m.cwiseAbs() - box.half_extents_m;
  const double inside_m = beyond_m.maxCoeff();
  return inside_m < 0.0 ? inside_m : beyond_m.cwiseMax(0.0).norm();
}

Result<Done> check_box(const Box& box) {
  const bool finite = box.centre_m.allFinite() && box.half_extents_m.allFinite() && box.attitude.coeffs().allFinite();
  if (!finite || !(box.half_extents_m.minCoeff() > 0.0)) {
    return Error{"box " + box.name + " has no volume: give three half extents in m, above zero"};
  }
  return Done{};
}

Result<Done> check_push(const Push& push) {
  if (!(push.start_s >= 0.0) || !(push.duration_s > 0.0) || !push.impulse_Ns.allFinite()) {
    return Error{"push " + push.name + " has no duration or begins before the run: give seconds above zero"};
  }
  return Done{};
}

Result<Done> check_payload(const Payload& payload) {
  if (!(payload.start_s >= 0.0) || !(payload.mass_kg > 0.0) || !payload.position_m.allFinite()) {
    return Error{"payload " + payload.name + " has no mass or begins before the run: give kg above zero"};
  }
  return Done{};
}

/// Absent, or finite and not negative.
bool possible(const std::optional<double>& value) noexcept {
  return !value || (*value >= 0.0 && std::isfinite(*value));
}

Result<Done> check_supply_change(const SupplyChange& change) {
  if (!(change.start_s >= 0.0) || !possible(change.pump_flow_m3_s) || !possible(change.accumulator_volume_m3)) {
    return Error{"supply change " + change.name +
                 " begins before the run, or is negative or not finite: give values of zero or more"};
  }
  return Done{};
}
Result<Done> check_actuator_change(const ActuatorChange& change) {
  const auto factor = [](const std::optional<double>& value) {
    return !value || (*value > 0.0 && std::isfinite(*value));
  };
  if (!(change.start_s >= 0.0) || !(change.duration_s >= 0.0) || !factor(change.valve_gain) ||
      !factor(change.bulk_modulus) || !possible(change.viscosity) || !possible(change.seal_friction) ||
      !possible(change.leakage_m3_s_Pa) || !possible(change.overlap_A) ||
      !std::isfinite(change.stuck_A.value_or(0.0))) {
    return Error{"actuator change " + change.name +
                 " begins before the run, or has a value that no actuator has: give factors above zero, and a leakage "
                 "and an overlap of zero or more"};
  }
  return Done{};
}

}  // namespace

Result<Done> validate(const Scene& scene) {
  if (!(scene.friction >= 0.0) || !std::isfinite(scene.friction)) {
    return Error{"the friction is negative or not finite: give its coefficient"};
  }
  if (!(scene.ground.toRotationMatrix()(2, 2) > 0.0)) {
    return Error{"the ground does not face upwards: give a slope below a right angle"};
  }
  for (const Box& box : scene.boxes) {
    FARRIER_TRY(check_box(box));
  }
  for (const Push& push : scene.pushes) {
    FARRIER_TRY(check_push(push));
  }
  for (const Payload& payload : scene.payloads) {
    FARRIER_TRY(check_payload(payload));
  }
  for (const SupplyChange& change : scene.supply_changes) {
    FARRIER_TRY(check_supply_change(change));
  }
  for (const ActuatorChange& change : scene.actuator_changes) {
    FARRIER_TRY(check_actuator_change(change));
  }
  return Done{};
}

Result<Done> check_start(const Scene& scene, const BodyModel& model, const RigidBody& body) {
  const Eigen::Vector3d normal = scene.ground.toRotationMatrix().col(2);
  for (int i = 0; i < body.legs(); ++i) {
    const LegModel& leg = model.legs[static_cast<std::size_t>(i)];
    const Eigen::Vector3d foot_m = body.foot_position_m(i);
    const double least_m = leg.foot_radius_m - kRestingDepth_m;
    if (!(normal.dot(foot_m) >= least_m)) {
      return Error{"the foot of leg " + leg.name + " starts below the ground: start higher"};
    }
    for (const Box& box : scene.boxes) {
      if (!(distance_m(box, foot_m) >= least_m)) {
        return Error{(box.origin.empty() ? "" : box.origin + ": ") + "the foot of leg " + leg.name + " starts in box " +
                     box.name + ": move the box or start higher"};
      }
    }
  }
  return Done{};
}

Eigen::Vector3d push_force_N(const Scene& scene, double from_s, double to_s) noexcept {
  Eigen::Vector3d impulse_Ns = Eigen::Vector3d::Zero();
  for (const Push& push : scene.pushes) {
    const double overlap_s = std::min(to_s, push.start_s + push.duration_s) - std::max(from_s, push.start_s);
    if (overlap_s > 0.0) {
      impulse_Ns += overlap_s / push.duration_s * push.impulse_Ns;
    }
  }
  return impulse_Ns / (to_s - from_s);
}

RigidInertia loaded_trunk(const RigidInertia& trunk, const Scene& scene, double time_s) noexcept {
  SpatialInertia sum = SpatialInertia::of(trunk.mass_kg, trunk.com_m, trunk.tensor_kg_m2);
  bool loaded = false;
  for (const Payload& payload : scene.payloads) {
    if (time_s >= payload.start_s) {
      sum = sum + SpatialInertia::of(payload.mass_kg, payload.position_m, Eigen::Matrix3d::Zero());
      loaded = true;
    }
  }
  if (!loaded) {
    return trunk;
  }
  const Eigen::Vector3d com_m = sum.first_moment_kg_m / sum.mass_kg;
  const SpatialInertia at_com = SpatialInertia::of(sum.mass_kg, com_m, Eigen::Matrix3d::Zero());
  return {sum.mass_kg, com_m, sum.tensor_kg_m2 - at_com.tensor_kg_m2};
}

Eigen::Quaterniond attitude_of(double roll_rad, double pitch_rad, double yaw_rad) noexcept {
  return turn(Eigen::Vector3d::UnitZ(), yaw_rad) * turn(Eigen::Vector3d::UnitY(), pitch_rad) *
         turn(Eigen::Vector3d::UnitX(), roll_rad);
}

}  // namespace farrier::body
