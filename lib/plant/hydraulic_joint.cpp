#include "plant/hydraulic_joint.hpp"

#include <algorithm>
#include <cmath>
#include <sstream>
#include <string>

#include "plant/effects/bends.hpp"
#include "plant/fastest_rate.hpp"

namespace farrier::plant {
namespace {

/// Error estimates of substeps that stride over a bend count this much more: measured, see plant_integrator_test.
constexpr double kUnseenBendFactor = 30.0;

DelayLine delay_of(std::span<const ActiveEffect> effects) {
  const ActiveEffect* delay = find(effects, effect_id<InputDelay>());
  return DelayLine(delay != nullptr ? *parameter_value(*delay, "delay_s") : 0.0);
}

}  // namespace

Result<HydraulicJoint> HydraulicJoint::create(const ActuatorParams& nominal, const LoadParams& nominal_load,
                                              const State& initial, double tolerance,
                                              std::span<const ActiveEffect> effects) {
  std::string refusals;
  const auto refuse = [&](const std::string& why) { refusals += (refusals.empty() ? "" : "; ") + why; };
  if (const auto verdict = validate(effects); !verdict.ok()) {
    return verdict.error();  // before they are put into the parameters
  }
  const ActuatorParams actuator = plant::with_effects(nominal, effects);
  const LoadParams load = plant::with_effects(nominal_load, nominal, effects);
  for (const auto& verdict : {validate(actuator), validate(load), validate(actuator, initial)}) {
    if (!verdict.ok()) {
      refuse(verdict.error().message);
    }
  }
  if (!(tolerance >= 1e-14 && tolerance <= 1e-2)) {
    refuse("tolerance must be within [1e-14, 1e-2]");
  }
  if (refusals.empty() && !(load.mass + actuator.piston_mass > 0.0)) {
    refuse("load: mass and piston_mass must not both be 0");
  }
  if (!refusals.empty()) {
    return Error{refusals};
  }
  HydraulicJoint joint(actuator, load, initial, tolerance, effects);
  if (const double fastest = fastest_rate(actuator, load, joint.effects_); !stable_substep(fastest)) {
    std::ostringstream text;
    text << "joint: fastest rate " << fastest << " 1/s exceeds " << kStabilityInterval / kShortestSubstep_s
         << " 1/s; lower stop_stiffness or stop_damping, or raise line_volume_m3, laminar_pressure_Pa, mass or the "
            "friction's presliding";
    return Error{text.str()};
  }
  return joint;
}

HydraulicJoint::HydraulicJoint(const ActuatorParams& actuator, const LoadParams& load, const State& initial,
                               double tolerance, std::span<const ActiveEffect> effects)
    : tolerance_(tolerance),
      actuator_(actuator),
      equations_(without_lines(actuator), load),
      effects_(actuator, load, effects, tolerance),
      has_effects_(effects_.active()),
      delay_(delay_of(effects)),
      hysteresis_(hysteresis_of(effects, Scales(actuator, load))),
      integrated_{{initial.position, initial.velocity, initial.pressure_a_Pa, initial.pressure_b_Pa},
                  effects_.rest({initial.pressure_a_Pa, initial.pressure_b_Pa, initial.velocity})},
      state_(initial),
      external_force_limit_(10.0 * actuator.supply_pressure_Pa * std::max(actuator.area_a, actuator.area_b)),
      inverse_tolerance_position_(1.0 / (tolerance * actuator.stroke)),
      inverse_tolerance_velocity_(1.0 / (tolerance * velocity_scale(actuator))),
      inverse_tolerance_pressure_(1.0 / (tolerance * actuator.supply_pressure_Pa)),
      inverse_tolerance_effects_(effects_.scale()) {
  if (find(effects, effect_id<LoadFriction>()) != nullptr) {
    guide_ = load.friction;
  }
  if (find(effects, effect_id<FlexibleLoad>()) != nullptr) {
    part_ = load.flexible;
  }
  for (double& inverse : inverse_tolerance_effects_) {
    inverse = 1.0 / (tolerance * inverse);
  }
  find_lean();
  hold({0.0, 0.0});
  differentiate();
}

void HydraulicJoint::find_lean() noexcept {
  lean_ = lean(effects_);
  sliding_.reset();
  if (lean_) {
    sliding_.emplace(lean_->get<SupplyLine>(), SlidingSeal(lean_->get<SealFriction>().contact()),
                     lean_->get<LandLeaks>());
  }
}

void HydraulicJoint::hold(const CommandInput& input) noexcept {
  command_ = input;
  input_ = equations_.hold(input.command_A, input.external_force);
  (input.command_A > 0.0 ? input_.port_a_Pa : input_.port_b_Pa) -= input.supply_fall_Pa;
  if (lean_) {
    const ValveMoment<double> valve = effects_.get<StatelessTerms>().opening(input.command_A);
    lean_input_ = {equations_.hold(valve.opening_A, input.external_force), input.command_A, valve.opening_A,
                   input.supply_fall_Pa};
    lean_input_.flow_gain *= valve.flow_factor;
  }
}

void HydraulicJoint::differentiate() noexcept {
  if (lean_) {
    take(with_lean_effects().derivative(lean_state(integrated_), lean_input_), derivative_);
  } else if (has_effects_) {
    derivative_ = with_effects().derivative(integrated_, command_);
  } else {
    static_cast<IntegrationState&>(derivative_) = equations_.derivative(integrated_, input_);
  }
}

CommandInput HydraulicJoint::admit(double valve_current_A, double external_force, StepReport& report) const noexcept {
  const double current_max = actuator().valve_current_max_A;
  const bool current_good = std::isfinite(valve_current_A);
  const bool force_good = std::abs(external_force) <= external_force_limit_;
  report.input_refused = !current_good || !force_good;
  const double current = current_good ? std::clamp(valve_current_A, -current_max, current_max) : 0.0;
  const double force =
      std::isfinite(external_force) ? std::clamp(external_force, -external_force_limit_, external_force_limit_) : 0.0;
  return {current, force};
}

double HydraulicJoint::error_ratio(const IntegrationState& error) const noexcept {
  const double position = std::abs(error.position) * inverse_tolerance_position_;
  const double velocity = std::abs(error.velocity) * inverse_tolerance_velocity_;
  const double pressure_a = std::abs(error.compression_a_Pa) * inverse_tolerance_pressure_;
  const double pressure_b = std::abs(error.compression_b_Pa) * inverse_tolerance_pressure_;
  return (position + velocity) + (pressure_a + pressure_b);
}

template <class Set>
double HydraulicJoint::error_ratio(const EffectState<Set>& error) const noexcept {
  const auto inverse_tolerance = inverse_tolerance_of(error);
  double sum = error_ratio(static_cast<const IntegrationState&>(error));
  for (std::size_t i = 0; i < error.x.size(); ++i) {
    sum += std::abs(error.x[i]) * inverse_tolerance[i];
  }
  return sum;
}

double HydraulicJoint::through_hysteresis(double current_A) noexcept {
  ValveMoment<double> valve{current_A, 1.0};
  if (hysteresis_) {
    hysteresis_->on_valve(valve);
  }
  return valve.opening_A;
}

CommandInput HydraulicJoint::at_spool(CommandInput input) noexcept {
  if (!delay_.active()) {
    input.command_A = through_hysteresis(input.command_A);
  }
  return input;
}

template <class Equations, class EquationState>
double HydraulicJoint::integrate(const Equations& equations, const typename Equations::Input& input,
                                 EquationState& state, EquationState& derivative, double period_s, StepReport& report,
                                 OilAccount* account) noexcept {
  std::optional<OilMeter<Equations, EquationState>> meter;
  if (account != nullptr) {
    meter.emplace(equations, input, state, *account);
  }
  double substep_s = 0.0;
  return advance_adaptively(
      equations, input, state, derivative, period_s, substep_s_, report,
      [&](const TrialStep<EquationState>& trial, double h) noexcept {
        substep_s = h;
        const bool unseen = meets_bend(equations, input, state, derivative, trial, actuator().laminar_pressure_Pa, h);
        return error_ratio(trial.error) * (unseen ? kUnseenBendFactor : 1.0);
      },
      [&]() noexcept {
        if constexpr (requires { equations.effects(); }) {
          equations.effects().settle(state.velocity, state.x, derivative.x);
        }
        report.cavitated |= state.compression_a_Pa < 0.0 || state.compression_b_Pa < 0.0;
        report.at_stop |= state.position < 0.0 || state.position > actuator().stroke;
        if (meter) {
          meter->book(state, substep_s);
        }
      });
}

double HydraulicJoint::advance(double period_s, StepReport& report, OilAccount* account) noexcept {
  if (!has_effects_) {
    return integrate<JointEquations, IntegrationState>(equations_, input_, integrated_, derivative_, period_s, report,
                                                       account);
  }
  if (!lean_) {
    return integrate(with_effects(), command_, integrated_, derivative_, period_s, report, account);
  }
  LeanState state = lean_state(integrated_);
  LeanState derivative = lean_state(derivative_);
  const double relative_error = integrate(LeanEquations(equations_, *lean_, *sliding_), lean_input_, state, derivative,
                                          period_s, report, account);
  take(state, integrated_);
  take(derivative, derivative_);
  return relative_error;
}

double HydraulicJoint::advance_delayed(double period_s, StepReport& report, OilAccount* account) noexcept {
  const CommandInput given = command_;
  delay_.push(given.command_A, period_s);
  double relative_error = 0.0;
  for (double left_s = period_s; left_s > DelayLine::kNoTime_s;) {
    const DelayLine::Stretch stretch = delay_.take(left_s);
    hold({through_hysteresis(stretch.current_A), given.external_force, given.supply_fall_Pa});
    differentiate();
    relative_error += advance(stretch.length_s, report, account);
    left_s -= stretch.length_s;
  }
  return relative_error;
}

StepReport HydraulicJoint::step(double valve_current_A, double external_force, double period_s) noexcept {
  StepReport report;
  const CommandInput input = admit(valve_current_A, external_force, report);
  const bool moves = period_s > 0.0 && period_s <= kLongestPeriod_s;
  hold(moves ? at_spool(input) : input);
  differentiate();
  if (!moves) {
    report.input_refused = true;
    return report;
  }
  const double relative_error = delay_.active() ? advance_delayed(period_s, report) : advance(period_s, report);
  report_errors(relative_error, report);
  publish_state();
  return report;
}

void HydraulicJoint::report_errors(double relative_error, StepReport& report) const noexcept {
  report.error_position = relative_error / inverse_tolerance_position_;
  report.error_velocity = relative_error / inverse_tolerance_velocity_;
  report.error_pressure_Pa = relative_error / inverse_tolerance_pressure_;
}

void HydraulicJoint::publish_state() noexcept {
  state_ = {integrated_.position, integrated_.velocity, std::max(0.0, integrated_.compression_a_Pa),
            std::max(0.0, integrated_.compression_b_Pa)};
}

double HydraulicJoint::effects_piston_force() const noexcept {
  return lean_ ? with_lean_effects().piston_force(lean_state(integrated_), lean_input_)
               : with_effects().piston_force(integrated_, command_);
}

double HydraulicJoint::load_cell_force() const noexcept {
  const double read = hydraulic_force() + equations_.stop_force(integrated_) -
                      actuator().piston_damping * integrated_.velocity - actuator().piston_mass * acceleration();
  return has_effects_ ? read + effects_piston_force() : read;
}

double HydraulicJoint::void_volume_a_m3() const noexcept {
  const double volume = chamber_volumes(equations_.actuator(), integrated_.position).a_m3;
  return std::max(0.0, -integrated_.compression_a_Pa) * volume / actuator().bulk_modulus_Pa +
         effects_.lines().void_volume_m3(integrated_.x[Effects::at<Lines>()]);
}

double HydraulicJoint::void_volume_b_m3() const noexcept {
  const double volume = chamber_volumes(equations_.actuator(), integrated_.position).b_m3;
  return std::max(0.0, -integrated_.compression_b_Pa) * volume / actuator().bulk_modulus_Pa +
         effects_.lines().void_volume_m3(integrated_.x[Effects::at<Lines>() + 1]);
}

EffectReadings HydraulicJoint::effects() const noexcept {
  constexpr std::size_t line = Effects::at<Lines>();
  const bool lines = effects_.lines().active();
  return {.opening_A = with_effects().opening_A(integrated_, command_),
          .line_pressure_a_Pa = lines ? pressure_of(integrated_.x[line]) : state_.pressure_a_Pa,
          .line_pressure_b_Pa = lines ? pressure_of(integrated_.x[line + 1]) : state_.pressure_b_Pa,
          .line_flow_a_m3_s = integrated_.x[line + 2],
          .line_flow_b_m3_s = integrated_.x[line + 3],
          .friction = integrated_.x[Effects::at<Friction>()] + integrated_.x[Effects::at<WavyFriction>()],
          .piston_force = has_effects_ ? effects_piston_force() : 0.0};
}

}  // namespace farrier::plant
