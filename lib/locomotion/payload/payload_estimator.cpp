#include "locomotion/payload/payload_estimator.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "locomotion/rotation.hpp"

namespace farrier::locomotion {
namespace {

// Part of gravity that presses a robot on its feet at least.
constexpr double kLeastGravityShare = 0.2;

// Larger forces and accelerations are no measurement.
constexpr double kMostGravities = 10.0;

// Memory of the spread over that of the mass.
constexpr double kSlower = 4.0;

double towards(double from, double to, double most) noexcept { return from + std::clamp(to - from, -most, most); }

}  // namespace

PayloadEstimator::PayloadEstimator(const PayloadParams& params, double mass_kg, double period_s) noexcept
    : params_(params), mass_kg_(mass_kg), period_s_(period_s) {
  reset();
}

void PayloadEstimator::reset() noexcept {
  force_N_ = mass_kg_ * kGravity_m_s2;
  specific_force_m_s2_ = kGravity_m_s2;
  slow_mass_kg_ = 0.0;
  variance_kg2_ = 0.0;
  moment_Nm_.setZero();
  unexplained_N_.setZero();
  shortfall_N_ = 0.0;
  direction_m_s2_ = kGravity_m_s2 * Eigen::Vector3d::UnitZ();
  payload_ = {};
  assumed_ = {.mass_kg = mass_kg_};
}

bool PayloadEstimator::pushed(const ForceBalance& balance) noexcept {
  const double mass = mass_kg_ + payload_.mass_kg;
  const Eigen::Vector3d all = balance.force_N - mass * balance.specific_force_m_s2;
  const Eigen::Vector3d horizontal = all - balance.up.dot(all) * balance.up;
  unexplained_N_ += std::min(1.0, period_s_ / params_.push_time_constant_s) * (horizontal - unexplained_N_);
  return unexplained_N_.norm() > params_.push_gate_m_s2 * mass;
}

bool PayloadEstimator::falls_short(const ForceBalance& balance) noexcept {
  const double missing_N = balance.wanted_lift_N - balance.up.dot(balance.force_N);
  shortfall_N_ += std::min(1.0, period_s_ / params_.shortfall_time_constant_s) * (missing_N - shortfall_N_);
  return shortfall_N_ > params_.shortfall_gate_m_s2 * (mass_kg_ + payload_.mass_kg);
}

void PayloadEstimator::update(const ForceBalance& balance) noexcept {
  const double lift_N = balance.up.dot(balance.force_N);
  const double specific = balance.up.dot(balance.specific_force_m_s2);
  const Eigen::Vector3d moment =
      balance.moment_Nm - mass_kg_ * balance.com_m.cross(balance.specific_force_m_s2);  // of the payload
  const double most = kMostGravities * kGravity_m_s2;
  const bool believable = std::isfinite(lift_N) && balance.force_N.norm() <= most * mass_kg_ &&
                          balance.specific_force_m_s2.norm() <= most && moment.allFinite() &&
                          std::abs(balance.wanted_lift_N) <= most * mass_kg_;  // false for NaN
  if (!believable) {
    return;
  }
  const bool push = pushed(balance);
  if (falls_short(balance) || push) {
    return;
  }
  const double share = std::min(1.0, period_s_ / params_.time_constant_s);
  force_N_ += share * (lift_N - force_N_);
  specific_force_m_s2_ += share * (specific - specific_force_m_s2_);
  const double moment_share = std::min(1.0, period_s_ / params_.moment_time_constant_s);
  moment_Nm_ += moment_share * (moment - moment_Nm_);
  direction_m_s2_ += moment_share * (balance.specific_force_m_s2 - direction_m_s2_);
  const double pressed = std::max(specific_force_m_s2_, kLeastGravityShare * kGravity_m_s2);
  payload_.mass_kg = force_N_ / pressed - mass_kg_;
  // The balance errs with the period of the stride, so the spread of its means shows the error.
  slow_mass_kg_ += share / kSlower * (payload_.mass_kg - slow_mass_kg_);
  const double spread_kg = payload_.mass_kg - slow_mass_kg_;
  variance_kg2_ += share / kSlower * (spread_kg * spread_kg - variance_kg2_);
  payload_.mass_error_kg = std::sqrt(variance_kg2_);
  // s x (d x s) = d |s|^2 - s (s . d)
  payload_.moment_kgm = direction_m_s2_.cross(moment_Nm_) / std::max(direction_m_s2_.squaredNorm(), pressed * pressed);
  payload_.validity += share * (1.0 - payload_.validity);
}

void PayloadEstimator::assume(const Eigen::Vector3d& com_m) noexcept {
  if (!params_.on) {
    return;
  }
  const double most = params_.largest_rate_1_s * period_s_ * mass_kg_;
  const double load = std::clamp(payload_.mass_kg, params_.least_share * mass_kg_, params_.largest_share * mass_kg_);
  assumed_.mass_kg = towards(assumed_.mass_kg, mass_kg_ + load, most);
  // c = (m_0 c_0 + d) / m, and its shift across gravity from c_0
  const Eigen::Vector3d up = direction_m_s2_.normalized();
  const Eigen::Vector3d across = com_m - up.dot(com_m) * up;
  const Eigen::Vector3d shift = (payload_.moment_kgm - payload_.mass_kg * across) / (mass_kg_ + load);
  for (Eigen::Index axis = 0; axis < 3; ++axis) {
    const double wanted = std::clamp(shift[axis], -params_.largest_shift_m, params_.largest_shift_m);
    if (std::isfinite(wanted)) {
      assumed_.shift_m[axis] = towards(assumed_.shift_m[axis], wanted, params_.largest_shift_rate_m_s * period_s_);
    }
  }
}

}  // namespace farrier::locomotion
