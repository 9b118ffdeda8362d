#pragma once

// The two halves of a joint, as the load cell splits it, each simulated with what was measured at the other's end:
//
//   current, motion ──▶ valve and oil ──▶ force        force ──▶ load ──▶ motion        position ──▶ velocity sensor
//
// T is double, or a number with derivatives.

#include <algorithm>
#include <cmath>

#include "diagnosis/joint_data.hpp"
#include "diagnosis/model.hpp"
#include "plant/terms/terms.hpp"

namespace farrier::diagnosis {

/// Constants of a joint that a fit may move within 3 %; SI, actuator coordinates, as in plant::ActuatorParams.
template <class T>
struct Constants {
  T area_a, area_b, line_volume_m3, bulk_modulus_Pa, valve_gain, supply_pressure_Pa, piston_mass, piston_damping;
  T mass, damping, stiffness;
  double slack_position, stroke, return_pressure_Pa, laminar_pressure_Pa, current_max_A;
};

/// Flow through one port and how it falls with the pressure behind it.
template <class T>
struct PortFlow {
  T flow, slope;
};

/// q = K_v y drop / (drop^2 + delta^2)^(1/4), (2.14), (2.15) with plant::orifice_root's laminar range.
template <class T>
PortFlow<T> port_flow(const T& conductance, const T& drop_Pa, double laminar_Pa) {
  using std::sqrt;
  const T square = drop_Pa * drop_Pa + laminar_Pa * laminar_Pa;
  const T by_root = conductance / sqrt(sqrt(square));
  return {by_root * drop_Pa, by_root * (1.0 - 0.5 * drop_Pa * drop_Pa / square)};
}

template <class T>
double value_of(const T& number) noexcept {
  if constexpr (requires { number.a; }) {
    return number.a;
  } else {
    return number;
  }
}

/// (1 - e^-x) / x: how far a decaying state goes in a step.
inline double decaying_share(double x) noexcept { return x > 1e-6 ? (1.0 - std::exp(-x)) / x : 1.0 - 0.5 * x; }

/// Valve and oil, from a sample on. A copy goes on from where the original stands.
template <class T>
class OilSimulation {
 public:
  /// At rest's pressures for the force that is measured there. `data` and `constants` outlive this.
  OilSimulation(const JointData& data, const Constants<T>& constants, const plant::TermSet<T>& terms,
                std::size_t begin)
      : data_(&data), c_(&constants), terms_(terms), begin_(begin) {
    if (const auto* gain = terms_.template find<plant::ForceSensorGain>()) {
      sensor_gain_ = gain->gain();
    }
    T offset(0.0);
    if (const auto* term = terms_.template find<plant::ForceSensorOffset>()) {
      offset = term->offset();
    }
    // (3.19), (3.20) for no speed: the pressures add to the supply.
    const T force = (data.force[begin] - offset) / sensor_gain_;
    const T& supply = constants.supply_pressure_Pa;
    p_a_ = (force + constants.area_b * supply) / (constants.area_a + constants.area_b);
    p_a_ = p_a_ < constants.return_pressure_Pa ? T(constants.return_pressure_Pa) : p_a_ > supply ? supply : p_a_;
    p_b_ = supply - p_a_;
  }

  /// What the load cell reads at sample k, where this stands. Once per sample.
  T read(std::size_t k) {
    plant::PistonMoment<T> piston{data_->position[k], data_->velocity[k], data_->period_s, T(0.0)};
    terms_.on_piston(piston);
    plant::ForceMoment<T> cell{c_->area_a * p_a_ - c_->area_b * p_b_ - c_->piston_damping * data_->velocity[k] -
                               c_->piston_mass * data_->acceleration[k] + piston.force};
    terms_.on_force(cell);
    return cell.force;
  }

  /// On to sample k + 1, the pressures drawn along the force by `pull` of its error, the measured force less the read.
  void advance(std::size_t k, const T& error, double pull) {
    const T areas = c_->area_a * c_->area_a + c_->area_b * c_->area_b;
    const T drawn = error / sensor_gain_ / areas * (pull / JointData::kSubsteps);
    for (std::size_t j = 0; j < JointData::kSubsteps; ++j) {
      substep(k, k * JointData::kSubsteps + j);
      p_a_ += drawn * c_->area_a;
      p_b_ -= drawn * c_->area_b;
      p_a_ = p_a_ > 0.0 ? p_a_ : T(0.0);
      p_b_ = p_b_ > 0.0 ? p_b_ : T(0.0);
    }
  }

 private:
  /// Mean current over substep `sub`, late by the delay.
  T current(std::size_t k, std::size_t sub) const {
    const auto* delay = terms_.template find<plant::InputDelay>();
    if (delay == nullptr) {
      return T(data_->current_A[k]);
    }
    const double h = data_->step_s();
    const T from = static_cast<double>(sub) * h - delay->delay_s();
    return (charge(from + h) - charge(from)) / h;
  }

  /// Integral of the current; before the first sample it was what it is there.
  T charge(const T& at_s) const {
    const double place = value_of(at_s) / data_->period_s;
    const std::size_t i = place <= static_cast<double>(begin_)
                              ? begin_
                              : std::min(static_cast<std::size_t>(place), data_->size() - 1);
    return data_->current_integral[i] + (at_s - static_cast<double>(i) * data_->period_s) * data_->current_A[i];
  }

  void substep(std::size_t k, std::size_t sub) {
    using std::abs;
    const JointData& data = *data_;
    const Constants<T>& c = *c_;
    const double h = data.step_s();
    const double speed = data.middle_velocity[sub];
    plant::ValveMoment<T> valve{current(k, sub), T(1.0)};
    terms_.on_valve(valve);
    const bool extends = valve.opening_A > 0.0;
    const T conductance = c.valve_gain * valve.flow_factor * abs(valve.opening_A);

    const T hydraulic = c.area_a * p_a_ - c.area_b * p_b_;
    plant::OilMoment<T> oil{p_a_, p_b_, supply_flow_, value_of(hydraulic), value_of(c.bulk_modulus_Pa),
                            c.supply_pressure_Pa, T(0.0), T(0.0), T(0.0), T(0.0)};
    terms_.on_oil(oil);
    const T at_return(c.return_pressure_Pa);
    const PortFlow<T> a =
        port_flow<T>(conductance, (extends ? oil.supply_pressure_Pa : at_return) - p_a_, c.laminar_pressure_Pa);
    const PortFlow<T> b =
        port_flow<T>(conductance, (extends ? at_return : oil.supply_pressure_Pa) - p_b_, c.laminar_pressure_Pa);
    supply_flow_ = extends ? a.flow : b.flow;
    supply_flow_ = supply_flow_ > 0.0 ? supply_flow_ : T(0.0);

    // (2.10), (2.11) with the volumes (2.12), (2.13)
    const double smallest = 0.25 * value_of(c.line_volume_m3);
    T v_a = c.line_volume_m3 + c.area_a * data.middle_position[sub];
    T v_b = c.line_volume_m3 + c.area_b * (c.stroke - data.middle_position[sub]);
    v_a = v_a > smallest ? v_a : T(smallest);
    v_b = v_b > smallest ? v_b : T(smallest);
    const T stiff_a = c.bulk_modulus_Pa / ((1.0 + c.bulk_modulus_Pa * oil.softness_a) * v_a);
    const T stiff_b = c.bulk_modulus_Pa / ((1.0 + c.bulk_modulus_Pa * oil.softness_b) * v_b);
    plant::PlayMoment<T> play{hydraulic - c.piston_damping * speed - c.piston_mass * data.acceleration[k],
                              c.piston_damping, c.area_a * c.area_a * stiff_a + c.area_b * c.area_b * stiff_b, h,
                              T(0.0)};
    terms_.on_play(play);
    const T piston_speed = speed + play.moved / h;
    const T rate_a = stiff_a * (a.flow - oil.leakage_m3_s - c.area_a * piston_speed);
    const T rate_b = stiff_b * (b.flow + oil.leakage_m3_s + c.area_b * piston_speed);
    // Exponential Euler of Rosenbrock's kind (Hochbruck, Ostermann 2010, (1.1)): exact for a linear port.
    p_a_ += h * decaying_share(h * value_of(stiff_a * a.slope)) * rate_a;
    p_b_ += h * decaying_share(h * value_of(stiff_b * b.slope)) * rate_b;
  }

  const JointData* data_;
  const Constants<T>* c_;
  plant::TermSet<T> terms_;
  std::size_t begin_;
  T sensor_gain_ = T(1.0);
  T p_a_, p_b_;
  T supply_flow_ = T(0.0);
};

/// The load, from a sample on. A copy goes on from where the original stands.
template <class T>
class LoadSimulation {
 public:
  /// In the measured motion. `data` and `constants` outlive this.
  LoadSimulation(const JointData& data, const Constants<T>& constants, const plant::TermSet<T>& terms,
                 std::size_t begin)
      : data_(&data), c_(&constants), terms_(terms) {
    if (const auto* gain = terms_.template find<plant::ForceSensorGain>()) {
      sensor_gain_ = gain->gain();
    }
    if (const auto* offset = terms_.template find<plant::ForceSensorOffset>()) {
      sensor_offset_ = offset->offset();
    }
    if (const auto* lag = terms_.template find<plant::ForceSensorLag>()) {
      lag_s_ = lag->lag_s();
    }
    settle(begin);
  }

  /// The measured motion of sample k.
  void settle(std::size_t k) {
    x_ = T(data_->position[k]);
    v_ = T(data_->velocity[k]);
  }

  /// Position at the sample where this stands: what a lagging cell reads drives the load early by its lag.
  T read() const { return x_ + lag_s_ * v_; }

  /// On to sample k + 1, drawn to the measured motion by `pull` of the error.
  void advance(std::size_t k, double pull) {
    const JointData& data = *data_;
    const double h = data.load_step_s();
    x_ += pull * (data.position[k] - x_);
    v_ += pull * (data.velocity[k] - v_);
    for (std::size_t j = 0; j < JointData::kLoadSubsteps; ++j) {
      const T force = (data.middle_force[k * JointData::kLoadSubsteps + j] - sensor_offset_) / sensor_gain_;
      plant::LoadMoment<T> load{x_ + 0.5 * h * v_, v_,      c_->mass, c_->damping, c_->stiffness,
                                T(c_->slack_position), T(0.0), T(0.0), T(0.0)};
      terms_.on_load(load);
      // (2.24) over a step in its mean velocity w:
      // m (2 w - 2 v) / h = F - d w - C (x + h w / 2 - x_eq) - hold - slope w
      const T along = load.damping + load.slope + 0.5 * h * load.stiffness;
      const T push = force + load.external_force - load.stiffness * (x_ - load.slack_position) - load.hold;
      const T mean = (2.0 / h * load.mass * v_ + push) / (2.0 / h * load.mass + along);
      terms_.after_load(mean);
      x_ += h * mean;
      v_ += 2.0 * (mean - v_);
    }
  }

 private:
  const JointData* data_;
  const Constants<T>* c_;
  plant::TermSet<T> terms_;
  T x_, v_;
  T sensor_gain_ = T(1.0);
  T sensor_offset_ = T(0.0);
  T lag_s_ = T(0.0);
};

/// Share of an error that a period takes away from a simulation drawn with this time constant.
inline double pull_of(double period_s, double time_constant_s) noexcept {
  return 1.0 - std::exp(-period_s / time_constant_s);
}

/// Whether the load is the one its model knows at a sample.
inline bool knows_load(const JointData& data, std::size_t k) noexcept {
  return data.swing.empty() || data.swing[k] != 0;
}

/// Valve and oil over a span: gives the force each sample's load cell should read to `take(index, force)`.
template <class T, class Take>
void simulate_oil(const JointData& data, Span span, const Constants<T>& c, const plant::TermSet<T>& terms,
                  double observer_s, Take&& take) {
  OilSimulation<T> oil(data, c, terms, span.begin);
  const double pull = pull_of(data.period_s, observer_s);
  for (std::size_t k = span.begin; k < span.end; ++k) {
    const T force = oil.read(k);
    take(k, force);
    oil.advance(k, data.force[k] - force, pull);
  }
}

/// The load over a span: gives its position to `take(index, position)`. Where it is not the load its model knows, the
/// simulation stays at what was measured.
template <class T, class Take>
void simulate_load(const JointData& data, Span span, const Constants<T>& c, const plant::TermSet<T>& terms,
                   double observer_s, Take&& take) {
  LoadSimulation<T> load(data, c, terms, span.begin);
  const double pull = pull_of(data.period_s, observer_s);
  for (std::size_t k = span.begin; k < span.end; ++k) {
    if (!knows_load(data, k)) {
      load.settle(k);
    }
    take(k, load.read());
    load.advance(k, pull);
  }
}

}  // namespace farrier::diagnosis
