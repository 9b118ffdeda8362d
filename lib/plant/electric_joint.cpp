#include "plant/electric_joint.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <sstream>

#include "plant/fastest_rate.hpp"

namespace farrier::plant {
namespace {

// Slope of an engaging stop: k (s + s' depth) <= 1.7 k, and d v s' <= 1.5 d v / ramp at the no-load speed.
double stop_slope(const ElectricParams& a) noexcept {
  return 1.7 * a.stop_stiffness + 1500.0 * a.stop_damping * no_load_speed(a) / a.travel;
}

double fastest_rigid_rate(const ElectricParams& a, const LoadParams& load) noexcept {
  const double mass = load.mass + armature_kg_m2(a);
  const double limit = a.gear_ratio * a.torque_constant_Nm_A / a.winding_resistance_Ohm;  // of the voltage, A s/rad
  const double damping = a.damping + a.coulomb / a.slip_velocity + load.damping + a.stop_damping;
  const double stiffness =
      load.stiffness + stop_slope(a) + a.gear_ratio * a.torque_constant_Nm_A * limit / a.torque_time_constant_s;
  return std::max(1.0 / a.torque_time_constant_s, damping / mass + std::sqrt(stiffness / mass));
}

// Winding, rotor and load each by themselves: their dampers, and the stiffness of all that holds them.
double fastest_rate(const ElectricParams& a, const LoadParams& load) noexcept {
  if (a.rigid) {
    return fastest_rigid_rate(a, load);
  }
  const double output_constant = a.gear_ratio * a.torque_constant_Nm_A;
  const double inertia = armature_kg_m2(a);
  const double winding = a.winding_resistance_Ohm / a.winding_inductance_H;
  const double rotor_stiffness = a.spring_stiffness + output_constant * output_constant / a.winding_inductance_H;
  const double rotor =
      (a.damping + a.coulomb / a.slip_velocity + a.spring_damping) / inertia + std::sqrt(rotor_stiffness / inertia);
  const double moved = (load.damping + a.spring_damping + a.stop_damping) / load.mass +
                       std::sqrt((load.stiffness + a.spring_stiffness + stop_slope(a)) / load.mass);
  return std::max({winding, rotor, moved});
}

bool carries(const LoadParams& load) noexcept {
  return is_physical(load, 0.0) && load.friction.coulomb == 0.0 && load.friction.breakaway == 0.0;
}

}  // namespace

Result<ElectricJoint> ElectricJoint::create(const ElectricParams& actuator, const LoadParams& load,
                                            const ElectricState& initial, double tolerance) {
  std::string refusals;
  const auto refuse = [&](const std::string& why) { refusals += (refusals.empty() ? "" : "; ") + why; };
  for (const auto& verdict : {validate(actuator), validate(load), validate(actuator, initial)}) {
    if (!verdict.ok()) {
      refuse(verdict.error().message);
    }
  }
  if (!(tolerance >= 1e-14 && tolerance <= 1e-2)) {
    refuse("tolerance must be within [1e-14, 1e-2]");
  }
  if (refusals.empty() && !carries(load)) {
    refuse("load: an electric joint takes one with a mass above 0 and without dry friction");
  }
  if (!refusals.empty()) {
    return Error{refusals};
  }
  if (const double fastest = fastest_rate(actuator, load); !stable_substep(fastest)) {
    std::ostringstream text;
    text << "joint: fastest rate " << fastest << " 1/s exceeds " << kStabilityInterval / kShortestSubstep_s
         << " 1/s; lower stop_stiffness, stop_damping or spring_stiffness, or raise winding_inductance_H, "
            "rotor_inertia_kg_m2, slip_velocity or the load's mass";
    return Error{text.str()};
  }
  return ElectricJoint(actuator, load, initial, tolerance);
}

ElectricJoint::ElectricJoint(const ElectricParams& actuator, const LoadParams& load, const ElectricState& initial,
                             double tolerance)
    : equations_(actuator, load),
      state_(initial),
      command_limit_A_(current_max_A(actuator)),
      external_force_limit_(10.0 * stall_torque(actuator)),
      inverse_tolerance_{
          .position = 1.0 / (tolerance * actuator.travel),
          .velocity = 1.0 / (tolerance * no_load_speed(actuator)),
          .deflection = actuator.rigid ? 0.0 : actuator.spring_stiffness / (tolerance * stall_torque(actuator)),
          .rotor = 1.0 / (tolerance * no_load_speed(actuator)),
          .current_A = 1.0 / (tolerance * command_limit_A_)} {}

bool ElectricJoint::set_load(const LoadParams& load) noexcept {
  if (!carries(load) || !stable_substep(fastest_rate(actuator(), load))) {
    return false;
  }
  equations_.set_load(load);
  return true;
}

double ElectricJoint::error_ratio(const ElectricState& error) const noexcept {
  return std::abs(error.position) * inverse_tolerance_.position +
         std::abs(error.velocity) * inverse_tolerance_.velocity +
         std::abs(error.deflection) * inverse_tolerance_.deflection + std::abs(error.rotor) * inverse_tolerance_.rotor +
         std::abs(error.current_A) * inverse_tolerance_.current_A;
}

double ElectricJoint::admit(double command_A, StepReport& report) const noexcept {
  const bool good = std::isfinite(command_A);
  report.input_refused |= !good;
  return good ? std::clamp(command_A, -command_limit_A_, command_limit_A_) : 0.0;
}

double ElectricJoint::advance(const ElectricEquations::Input& input, double period_s, StepReport& report,
                              ElectricAccount* account) noexcept {
  ElectricState derivative = equations_.derivative(state_, input);
  ElectricState before = state_;
  double substep_s = 0.0;
  return advance_adaptively(
      equations_, input, state_, derivative, period_s, substep_s_, report,
      [&](const TrialStep<ElectricState>& trial, double h) noexcept {
        substep_s = h;
        return error_ratio(trial.error);
      },
      [&]() noexcept {
        report.at_stop |= state_.position < 0.0 || state_.position > actuator().travel;
        if (account != nullptr) {
          const double force = equations_.mechanism_torque(before) + equations_.mechanism_torque(state_);
          account->drawn_J += 0.5 * substep_s *
                              (equations_.voltage_V(before, input.command_A) * before.current_A +
                               equations_.voltage_V(state_, input.command_A) * state_.current_A);
          account->work_J += 0.5 * substep_s * state_.velocity * force;
          before = state_;
        }
      });
}

StepReport ElectricJoint::step(double command_A, double external_force, double period_s) noexcept {
  StepReport report;
  const bool period_good = period_s > 0.0 && period_s <= kLongestPeriod_s;
  report.input_refused = !(std::abs(external_force) <= external_force_limit_) || !period_good;
  const double command = admit(command_A, report);
  if (!period_good) {
    return report;
  }
  const double force =
      std::isfinite(external_force) ? std::clamp(external_force, -external_force_limit_, external_force_limit_) : 0.0;
  const double relative_error = advance({command, force}, period_s, report);
  report.error_position = relative_error / inverse_tolerance_.position;
  report.error_velocity = relative_error / inverse_tolerance_.velocity;
  return report;
}

// A load of infinite mass keeps the velocity that it is given.
StepReport ElectricJoint::follow(double command_A, const Motion& end, double period_s,
                                 ElectricAccount& account) noexcept {
  StepReport report;
  const double command = admit(command_A, report);
  if (!(period_s > 0.0 && period_s <= kLongestPeriod_s) || !std::isfinite(end.position) ||
      !std::isfinite(end.velocity)) {
    report.input_refused = true;
    return report;
  }
  equations_.set_load({.mass = std::numeric_limits<double>::infinity()});
  state_.velocity = (end.position - state_.position) / period_s;
  const double relative_error = advance({command, 0.0}, period_s, report, &account);
  state_.position = end.position;
  state_.velocity = end.velocity;
  report.error_position = relative_error / inverse_tolerance_.position;
  report.error_velocity = relative_error / inverse_tolerance_.velocity;
  return report;
}

}  // namespace farrier::plant
