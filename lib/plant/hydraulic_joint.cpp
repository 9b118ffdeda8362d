#include "plant/hydraulic_joint.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <sstream>
#include <string>

#include "plant/runge_kutta.hpp"

namespace farrier::plant {
namespace {

constexpr double kSafety = 0.9;
constexpr double kMostGrowth = 4.0;
constexpr double kMostShrink = 0.2;
/// Error estimates of substeps that stride over a bend count this much more: measured, see plant_integrator_test.
constexpr double kUnseenBendFactor = 30.0;
/// Keeps a remainder of exactly n substeps at n shares.
constexpr double kJustBelowOne = 1.0 - 1e-9;
/// Real stability interval of RK5(4)7M is 3.3; substeps at the bound must lie inside it.
constexpr double kStabilityInterval = 3.3;

/// Upper estimate of the fastest rate of the model, 1/s: a chamber filling through the laminar full-open valve,
/// and the piston on its stop with both oil columns, springs and dampers acting.
double fastest_rate(const ActuatorParams& actuator, const LoadParams& load) noexcept {
  const double oil = actuator.bulk_modulus_Pa / actuator.line_volume_m3;
  const double filling =
      oil * actuator.valve_gain * actuator.valve_current_max_A / std::sqrt(actuator.laminar_pressure_Pa);
  const double mass = load.mass + actuator.piston_mass;
  // Slope of an engaging stop: k (s + s' depth) <= 1.7 k, and d v s' <= 1.5 d v / ramp at the valve's full speed.
  const double stop =
      1.7 * actuator.stop_stiffness + 1500.0 * actuator.stop_damping * velocity_scale(actuator) / actuator.stroke;
  const double stiffness = load.stiffness + stop +
                           oil * (actuator.area_a * actuator.area_a + actuator.area_b * actuator.area_b);
  const double damping = load.damping + actuator.piston_damping + actuator.stop_damping;
  return std::max(filling, damping / mass + std::sqrt(stiffness / mass));
}

bool slow_enough(const ActuatorParams& actuator, const LoadParams& load) noexcept {
  return fastest_rate(actuator, load) * HydraulicJoint::kShortestSubstep_s <= kStabilityInterval;
}

bool not_negative(double value) noexcept { return std::isfinite(value) && value >= 0.0; }

/// Step-size factor kSafety r^(-1/5) for an error ratio r of a fifth-order step. The root is read off the exponent
/// bits (a piecewise linear logarithm, within 3 %): a step size needs no more, and no C library enters the trace.
double substep_factor(double ratio) noexcept {
  if (!(ratio > 1e-6)) {
    return ratio <= 1e-6 ? kMostGrowth : kMostShrink;  // not a number: the trial left the finite numbers
  }
  constexpr std::uint64_t kSixFifthsOfOne = std::bit_cast<std::uint64_t>(1.0) / 5 * 6;
  const double root = std::bit_cast<double>(kSixFifthsOfOne - std::bit_cast<std::uint64_t>(ratio) / 5);
  return std::clamp(kSafety * root, kMostShrink, kMostGrowth);
}

/// True when a chamber's pressure strides over a place where the right-hand side bends sharply, the start of a void or
/// the laminar range of its open port, so that a substep's few stages may miss it. The path between both ends lies
/// within the Bezier polygon of their values and rates.
bool strides_over_bend(double start, double start_rate, double end, double end_rate, double port, double laminar,
                       double h) noexcept {
  const double third = h * (1.0 / 3.0);
  const double after = start + third * start_rate;
  const double before = end - third * end_rate;
  const double low = std::min(std::min(start, end), std::min(after, before));
  const double high = std::max(std::max(start, end), std::max(after, before));
  const bool strides = high - low > 0.5 * laminar;
  const bool at_port = low < port + 5.0 * laminar && high > port - 5.0 * laminar;
  const bool at_void = low < laminar && high > 0.0;
  return strides && (at_port || at_void);
}

bool finite(const IntegrationState& s) noexcept {
  return std::isfinite(s.position) && std::isfinite(s.velocity) && std::isfinite(s.compression_a_Pa) &&
         std::isfinite(s.compression_b_Pa);
}

}  // namespace

Result<HydraulicJoint> HydraulicJoint::create(const ActuatorParams& actuator, const LoadParams& load,
                                              const State& initial, double tolerance) {
  std::string refusals;
  for (const auto& verdict : {validate(actuator), validate(load), validate(actuator, initial)}) {
    if (!verdict.ok()) {
      refusals += (refusals.empty() ? "" : "; ") + verdict.error().message;
    }
  }
  if (!(tolerance >= 1e-14 && tolerance <= 1e-2)) {
    refusals += (refusals.empty() ? "" : "; ") + std::string("tolerance must be within [1e-14, 1e-2]");
  }
  if (refusals.empty() && !(load.mass + actuator.piston_mass > 0.0)) {
    refusals = "load: mass and piston_mass must not both be 0";
  }
  if (refusals.empty() && !slow_enough(actuator, load)) {
    std::ostringstream text;
    text << "joint: fastest rate " << fastest_rate(actuator, load) << " 1/s exceeds "
         << kStabilityInterval / kShortestSubstep_s
         << " 1/s; lower stop_stiffness or stop_damping, or raise line_volume_m3, laminar_pressure_Pa or mass";
    refusals = text.str();
  }
  if (!refusals.empty()) {
    return Error{refusals};
  }
  return HydraulicJoint(JointEquations(actuator, load), initial, tolerance);
}

HydraulicJoint::HydraulicJoint(const JointEquations& equations, const State& initial, double tolerance) noexcept
    : equations_(equations),
      integrated_{initial.position, initial.velocity, initial.pressure_a_Pa, initial.pressure_b_Pa},
      input_(equations_.hold(0.0, 0.0)),
      derivative_(equations_.derivative(integrated_, input_)),
      state_(initial),
      external_force_limit_(10.0 * equations.actuator().supply_pressure_Pa *
                            std::max(equations.actuator().area_a, equations.actuator().area_b)),
      inverse_tolerance_position_(1.0 / (tolerance * equations.actuator().stroke)),
      inverse_tolerance_velocity_(1.0 / (tolerance * velocity_scale(equations.actuator()))),
      inverse_tolerance_pressure_(1.0 / (tolerance * equations.actuator().supply_pressure_Pa)) {}

bool HydraulicJoint::set_load(const LoadParams& load) noexcept {
  const bool physical = not_negative(load.mass) && not_negative(load.damping) && not_negative(load.stiffness) &&
                        std::isfinite(load.equilibrium_position) && load.mass + actuator().piston_mass > 0.0;
  if (!physical || !slow_enough(actuator(), load)) {
    return false;
  }
  equations_.set_load(load);
  derivative_ = equations_.derivative(integrated_, input_);
  return true;
}

HeldInput HydraulicJoint::admit(double valve_current_A, double external_force, StepReport& report) const noexcept {
  const double current_max = actuator().valve_current_max_A;
  const bool current_good = std::isfinite(valve_current_A);
  const bool force_good = std::abs(external_force) <= external_force_limit_;
  report.input_refused = !current_good || !force_good;
  const double current = current_good ? std::clamp(valve_current_A, -current_max, current_max) : 0.0;
  const double force = std::isfinite(external_force)
                           ? std::clamp(external_force, -external_force_limit_, external_force_limit_)
                           : 0.0;
  return equations_.hold(current, force);
}

double HydraulicJoint::error_ratio(const IntegrationState& error) const noexcept {
  const double position = std::abs(error.position) * inverse_tolerance_position_;
  const double velocity = std::abs(error.velocity) * inverse_tolerance_velocity_;
  const double pressure_a = std::abs(error.compression_a_Pa) * inverse_tolerance_pressure_;
  const double pressure_b = std::abs(error.compression_b_Pa) * inverse_tolerance_pressure_;
  return (position + velocity) + (pressure_a + pressure_b);
}

bool HydraulicJoint::meets_bend(const TrialStep& trial, double h) const noexcept {
  const double laminar = actuator().laminar_pressure_Pa;
  return strides_over_bend(integrated_.compression_a_Pa, derivative_.compression_a_Pa, trial.state.compression_a_Pa,
                           trial.end_derivative.compression_a_Pa, input_.port_a_Pa, laminar, h) ||
         strides_over_bend(integrated_.compression_b_Pa, derivative_.compression_b_Pa, trial.state.compression_b_Pa,
                           trial.end_derivative.compression_b_Pa, input_.port_b_Pa, laminar, h);
}

StepReport HydraulicJoint::step(double valve_current_A, double external_force, double period_s) noexcept {
  StepReport report;
  input_ = admit(valve_current_A, external_force, report);
  derivative_ = equations_.derivative(integrated_, input_);
  if (!(period_s > 0.0 && period_s <= kLongestPeriod_s)) {
    report.input_refused = true;
    return report;
  }

  double left_s = period_s;
  double relative_error = 0.0;
  while (left_s > 0.0) {
    const int shares = 1 + static_cast<int>(kJustBelowOne * left_s / substep_s_);
    const double h = left_s / shares;
    const bool shortest = substep_s_ <= kShortestSubstep_s;
    const TrialStep trial = dormand_prince_step(equations_, input_, integrated_, derivative_, h);
    const double ratio = error_ratio(trial.error) * (meets_bend(trial, h) ? kUnseenBendFactor : 1.0);
    const bool within = ratio <= 1.0;
    substep_s_ = std::clamp(h * substep_factor(ratio), kShortestSubstep_s, std::max(period_s, kShortestSubstep_s));
    if (!within && !shortest) {
      ++report.rejected;
      continue;
    }
    left_s = shares == 1 ? 0.0 : left_s - h;
    ++report.substeps;
    report.bound_hit |= !within;
    if (within || finite(trial.state)) {
      integrated_ = trial.state;
      derivative_ = trial.end_derivative;
      relative_error += ratio;
    }
    report.cavitated |= integrated_.compression_a_Pa < 0.0 || integrated_.compression_b_Pa < 0.0;
    report.at_stop |= integrated_.position < 0.0 || integrated_.position > actuator().stroke;
  }
  report.error_position = relative_error / inverse_tolerance_position_;
  report.error_velocity = relative_error / inverse_tolerance_velocity_;
  report.error_pressure_Pa = relative_error / inverse_tolerance_pressure_;
  publish_state();
  return report;
}

void HydraulicJoint::publish_state() noexcept {
  state_ = {integrated_.position, integrated_.velocity, std::max(0.0, integrated_.compression_a_Pa),
            std::max(0.0, integrated_.compression_b_Pa)};
}

double HydraulicJoint::load_cell_force() const noexcept {
  return hydraulic_force() + equations_.stop_force(integrated_) - actuator().piston_damping * integrated_.velocity -
         actuator().piston_mass * acceleration();
}

double HydraulicJoint::void_volume_a_m3() const noexcept {
  const double volume = actuator().line_volume_m3 + actuator().area_a * integrated_.position;
  return std::max(0.0, -integrated_.compression_a_Pa) * volume / actuator().bulk_modulus_Pa;
}

double HydraulicJoint::void_volume_b_m3() const noexcept {
  const double volume = actuator().line_volume_m3 + actuator().area_b * (actuator().stroke - integrated_.position);
  return std::max(0.0, -integrated_.compression_b_Pa) * volume / actuator().bulk_modulus_Pa;
}

}  // namespace farrier::plant
