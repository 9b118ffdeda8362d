#include "locomotion/body_state_signal.hpp"

#include <Eigen/Geometry>
#include <cmath>

namespace farrier::locomotion {
namespace {

constexpr std::size_t kAxes = 3;

std::array<double, kAxes> array_of(const Eigen::Vector3d& vector) noexcept {
  return {vector.x(), vector.y(), vector.z()};
}

template <std::size_t kSize>
void put(const PerLeg<Eigen::Vector3d>& vectors, std::array<double, kSize>& numbers) noexcept {
  static_assert(kSize == kAxes * kMaxLegs);
  for (std::size_t leg = 0; leg < vectors.size(); ++leg) {
    for (std::size_t axis = 0; axis < kAxes; ++axis) {
      numbers[kAxes * leg + axis] = vectors[leg][static_cast<Eigen::Index>(axis)];
    }
  }
}

}  // namespace

signals::BodyState body_state_signal(const LocomotionState& state, const MotionCommand& command, Tick tick) noexcept {
  signals::BodyState signal;
  signal.tick = tick;
  signal.mode = state.mode;
  signal.position_m = array_of(state.trunk.position_m);
  const Eigen::Quaterniond attitude(state.trunk.rotation);
  signal.attitude = {attitude.w(), attitude.x(), attitude.y(), attitude.z()};
  signal.velocity_m_s = array_of(state.trunk.velocity_m_s);
  signal.angular_velocity_rad_s = array_of(state.trunk.rotation.transpose() * state.trunk.angular_velocity_rad_s);
  signal.command = {command.forward_m_s, command.left_m_s, command.yaw_rate_rad_s, command.height_m};
  for (std::size_t i = 0; i < signal.wrench.size(); ++i) {
    signal.wrench[i] = state.wrench[static_cast<Eigen::Index>(i)];
  }
  put(state.forces_N, signal.foot_force_N);
  put(state.felt_forces_N, signal.felt_force_N);
  put(state.footholds_m, signal.foothold_m);
  for (std::size_t leg = 0; leg < signal.stands.size(); ++leg) {
    signal.stands[leg] = state.actions[leg] == LegAction::kStance ? 1 : 0;
  }
  return signal;
}

bool is_possible(const signals::BodyCommand& command) noexcept {
  return known(command.request) && std::isfinite(command.forward_m_s) && std::isfinite(command.left_m_s) &&
         std::isfinite(command.yaw_rate_rad_s) && std::isfinite(command.height_m);
}

}  // namespace farrier::locomotion
