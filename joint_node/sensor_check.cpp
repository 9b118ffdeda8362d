#include "joint_node/sensor_check.hpp"

#include <algorithm>
#include <cmath>

namespace farrier::joint_node {
namespace {

// Readings beyond these cannot come from this joint. The margins allow for compliant stops, for noise, and for a foot
// that lands on the oil behind a closed valve, where the force exceeds that of the supply.
constexpr double kBeyondStops = 0.1;   // of the stroke
constexpr double kBeyondLimits = 5.0;  // times the larger force limit
constexpr double kLargestJump = 0.1;   // of the stroke, in a tick
constexpr Tick kTicksForTheStroke = static_cast<Tick>((1.0 + 2 * kBeyondStops) / kLargestJump);

/// Also where both are no number.
bool same(double a, double b) noexcept { return a == b || (std::isnan(a) && std::isnan(b)); }

bool alike(const signals::JointSensors& a, const signals::JointSensors& b) noexcept {
  return same(a.position_m_or_rad, b.position_m_or_rad) && same(a.velocity_m_s_or_rad_s, b.velocity_m_s_or_rad_s) &&
         same(a.force_N_or_Nm, b.force_N_or_Nm);
}

}  // namespace

SensorCheck::SensorCheck(const robot::Joint& joint, const robot::Safety& safety) noexcept
    : stroke_(joint.actuator.stroke),
      largest_force_(kBeyondLimits * std::max(joint.push_limit, joint.pull_limit)),
      safety_(safety) {}

bool SensorCheck::position_in_range(const signals::JointSensors& sensors) const noexcept {
  const double beyond = kBeyondStops * stroke_;
  return sensors.position_m_or_rad >= -beyond && sensors.position_m_or_rad <= stroke_ + beyond;
}

/// True if the position change is physically possible. Always true after an invalid reading or a gap long enough for a
/// full stroke.
bool SensorCheck::reachable(const signals::JointSensors& now) const noexcept {
  if (last_.tick < 0 || !position_in_range(last_) || now.tick <= last_.tick ||
      now.tick - kTicksForTheStroke > last_.tick) {
    return true;
  }
  const auto ticks = static_cast<double>(now.tick - last_.tick);
  return std::abs(now.position_m_or_rad - last_.position_m_or_rad) <= kLargestJump * ticks * stroke_;
}

SensorCheck::Verdict SensorCheck::take(const signals::JointSensors& newest, double age_s) noexcept {
  const int new_samples = newest.tick != last_.tick ? 1 : 0;
  alike_ = alike(newest, last_) ? alike_ + new_samples : 0;
  const bool frozen = safety_.frozen_samples > 0 && alike_ >= safety_.frozen_samples;
  const bool finite = std::isfinite(newest.position_m_or_rad) && std::isfinite(newest.velocity_m_s_or_rad_s);
  const bool motion_good =
      age_s <= safety_.sensors_stale_s && finite && position_in_range(newest) && reachable(newest) && !frozen;
  // The force of an end stop has no limit. Both are false if the force is not a number.
  const bool at_stop =
      std::isfinite(newest.force_N_or_Nm) && (newest.position_m_or_rad <= 0.0 || newest.position_m_or_rad >= stroke_);
  const bool force_good = std::abs(newest.force_N_or_Nm) <= largest_force_ || at_stop;
  last_ = newest;
  return {motion_good, force_good, new_samples};
}

}  // namespace farrier::joint_node
