#include "trials/truth/electric_driver.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "trials/truth/excitation.hpp"

namespace farrier::truth::electric {
namespace {

constexpr double kTwoPi = 2.0 * std::numbers::pi;
constexpr double kCompensated = 0.5;  ///< share of the rotor's damping that the command makes up for
constexpr double kFollows_Hz = 6.0;   ///< bandwidth with which a position is followed

double moved_inertia(const robot::Joint& joint) {
  const plant::ElectricParams& a = *joint.electric;
  return joint.swing_load.mass + (a.rigid ? a.rotor_inertia_kg_m2 * a.gear_ratio * a.gear_ratio : 0.0);
}

// 12 lines of torque, 0.4 to 60 Hz. Each moves the joint by at most 7 % of its travel and asks at most a tenth of its
// rating.
std::vector<double> torque_sines(const robot::Joint& joint, const Plan& plan, double stiffness, double period_s,
                                 std::size_t ticks) {
  std::vector<double> out(ticks, 0.0);
  Draws draws(joint, plan, "truth multisine");
  for (int i = 0; i < 12; ++i) {
    const double f = 0.4 * std::pow(std::min(60.0, 0.25 / period_s) / 0.4, (i + draws.within(-0.3, 0.3)) / 11.0);
    const double omega = kTwoPi * f;
    const double reach = std::hypot(moved_inertia(joint) * omega * omega - stiffness, joint.swing_load.damping * omega);
    const double amplitude = std::min(0.1 * joint.push_limit, 0.07 * joint.electric->travel * reach);
    add_sine(out, period_s, omega, amplitude * draws.within(0.8, 1.2), draws.within(0.0, kTwoPi));
  }
  return out;
}

// Levels up to a third of the rating, held 20 to 200 ms; long ones lower, to stay within 15 % of the travel.
std::vector<double> torque_steps(const robot::Joint& joint, const Plan& plan, double period_s, std::size_t ticks) {
  std::vector<double> out;
  Draws draws(joint, plan, "truth steps");
  while (out.size() < ticks) {
    const double hold_s = draws.log_within(0.02, 0.2);
    const double reach = 0.15 * joint.electric->travel * 2.0 * moved_inertia(joint) / (hold_s * hold_s);
    const double level = draws.sign() * draws.within(0.1, 1.0) * std::min(0.33 * joint.push_limit, reach);
    out.insert(out.end(), static_cast<std::size_t>(std::max(1.0, std::round(hold_s / period_s))), level);
  }
  out.resize(ticks);
  return out;
}

// 8 lines of position, 0.3 to 8 Hz, and smooth steps held 0.2 to 0.8 s.
std::vector<double> positions(const robot::Joint& joint, const Plan& plan, double period_s, std::size_t ticks) {
  std::vector<double> out(ticks, 0.0);
  Draws draws(joint, plan, "truth positions");
  const double travel = joint.electric->travel;
  for (int i = 0; i < 8; ++i) {
    const double omega = kTwoPi * 0.3 * std::pow(8.0 / 0.3, (i + draws.within(-0.3, 0.3)) / 7.0);
    add_sine(out, period_s, omega, 0.06 * travel * draws.within(0.8, 1.2) / (1.0 + 0.05 * omega),
             draws.within(0.0, kTwoPi));
  }
  double level = 0.0, smooth = 0.0, smoother = 0.0;
  int left = 0;
  const double share = period_s / 0.03;
  for (double& position : out) {
    if (left-- <= 0) {
      left = static_cast<int>(draws.log_within(0.2, 0.8) / period_s);
      level = draws.within(-0.08, 0.08) * travel;
    }
    smooth += share * (level - smooth);
    smoother += share * (smooth - smoother);
    position += smoother;
  }
  return out;
}

}  // namespace

Driver::Driver(const robot::Joint& joint, double period_s, const Plan& plan, double scale)
    : middle_(0.5 * joint.electric->travel),
      constant_(joint.electric->gear_ratio * joint.electric->torque_constant_Nm_A),
      most_A_(0.8 * joint.actuator.valve_current_max_A),
      back_emf_(0.0),
      follows_(plan.excitation == Excitation::kForceTracking),
      inertia_(moved_inertia(joint)),
      period_s_(period_s) {
  const plant::ElectricParams& a = *joint.electric;
  if (!a.rigid) {
    back_emf_ = kCompensated * (a.damping + constant_ * constant_ / a.winding_resistance_Ohm);
  }
  const auto ticks = static_cast<std::size_t>(std::lround(plan.duration_s / period_s));
  if (follows_) {
    const double omega = kTwoPi * kFollows_Hz;
    stiffness_ = inertia_ * omega * omega;
    damping_ = 1.4 * inertia_ * omega;
    drive_ = positions(joint, plan, period_s, ticks);
  } else {
    stiffness_ = std::min(0.6 * joint.push_limit / a.travel, inertia_ * 400.0);
    damping_ = 0.4 * std::sqrt(stiffness_ * inertia_);
    drive_ = plan.excitation == Excitation::kMultisine ? torque_sines(joint, plan, stiffness_, period_s, ticks)
                                                       : torque_steps(joint, plan, period_s, ticks);
  }
  const std::vector<double> level = envelope(joint, plan, period_s, static_cast<int>(ticks));
  for (std::size_t k = 0; k < drive_.size(); ++k) {
    drive_[k] *= scale * level[k];
  }
}

Driver::Reference Driver::reference(int k) const {
  if (k < 1 || k + 1 >= static_cast<int>(drive_.size())) {
    return {0.0, 0.0, 0.0};
  }
  const auto i = static_cast<std::size_t>(k);
  if (!follows_) {
    return {0.0, 0.0, drive_[i]};
  }
  const double velocity = (drive_[i + 1] - drive_[i - 1]) / (2.0 * period_s_);
  return {drive_[i], velocity, 0.0};
}

double Driver::command_A(int k, double position, double velocity) const {
  const Reference wanted = reference(k);
  const double torque = wanted.torque + stiffness_ * (wanted.position - (position - middle_)) +
                        damping_ * (wanted.velocity - velocity) + back_emf_ * velocity;
  return std::clamp(torque / constant_, -most_A_, most_A_);
}

}  // namespace farrier::truth::electric
