#pragma once

// A joint's two halves, split at the load cell, each driven by the other's measurement:
//
//   current, motion ──▶ valve and oil ──▶ force        force ──▶ load ──▶ motion        position ──▶ velocity sensor
//
// T is double, or a number with derivatives.

#include <algorithm>
#include <cmath>

#include "diagnosis/model/delayed_command.hpp"
#include "diagnosis/data/joint_data.hpp"
#include "diagnosis/model/load_simulation.hpp"
#include "diagnosis/model/model.hpp"
#include "diagnosis/model/side_runs.hpp"
#include "plant/oil.hpp"
#include "plant/terms/terms.hpp"

namespace farrier::diagnosis {

/// (1 - e^-x) / x: share of its way that a decaying state covers in a step.
inline double decaying_share(double x) noexcept { return x > 1e-6 ? (1.0 - std::exp(-x)) / x : 1.0 - 0.5 * x; }

/// Simulates valve and oil from a sample on. A copy continues from the state of the original.
template <class T>
class OilSimulation {
 public:
  /// Starts with the pressures at rest for the measured force. `data` and `constants` must outlive this.
  OilSimulation(const JointData& data, const Constants<T>& constants, const plant::TermSet<T>& terms, std::size_t begin)
      : data_(&data),
        c_(&constants),
        terms_(terms),
        current_({data.current_A, data.current_integral, data.period_s}, terms) {
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
    if (terms_.template find<plant::ValveHysteresis>() != nullptr) {
      // Where a spool stands hangs on all commands before.
      for (std::size_t k = 0; k < begin; ++k) {
        for (std::size_t part = 0; part < JointData::kSubsteps; ++part) {
          open_valve(k, part);
        }
      }
    }
  }

  /// Reading of the load cell at sample k, the current one. Call once per sample.
  T read(std::size_t k) {
    plant::PistonMoment<T> piston{data_->position[k], data_->velocity[k], data_->period_s, T(0.0)};
    terms_.on_piston(piston);
    plant::ForceMoment<T> cell{plant::hydraulic_force(*c_, p_a_, p_b_) - c_->piston_damping * data_->velocity[k] -
                               c_->piston_mass * data_->acceleration[k] + piston.force};
    terms_.on_force(cell);
    return cell.force;
  }

  /// Advances to sample k + 1, the pressures drawn along the force by `pull` of its error, the measured force less the
  /// read.
  void advance(std::size_t k, const T& error, double pull) {
    const T areas = c_->area_a * c_->area_a + c_->area_b * c_->area_b;
    const T drawn = error / sensor_gain_ / areas * (pull / JointData::kSubsteps);
    for (std::size_t j = 0; j < JointData::kSubsteps; ++j) {
      substep(k, j);
      p_a_ += drawn * c_->area_a;
      p_b_ -= drawn * c_->area_b;
      p_a_ = p_a_ > 0.0 ? p_a_ : T(0.0);
      p_b_ = p_b_ > 0.0 ? p_b_ : T(0.0);
    }
  }

 private:
  plant::ValveMoment<T> open_valve(std::size_t k, std::size_t part) {
    plant::ValveMoment<T> valve{current_.mean(k, part, JointData::kSubsteps), T(1.0)};
    terms_.on_valve(valve);
    return valve;
  }

  void substep(std::size_t k, std::size_t part) {
    using std::abs;
    const JointData& data = *data_;
    const std::size_t sub = k * JointData::kSubsteps + part;
    const Constants<T>& c = *c_;
    const double h = data.step_s();
    const double speed = data.middle_velocity[sub];
    const plant::ValveMoment<T> valve = open_valve(k, part);
    const bool extends = valve.opening_A > 0.0;
    const T conductance = c.valve_gain * valve.flow_factor * abs(valve.opening_A);

    plant::OilMoment<T> oil{p_a_,
                            p_b_,
                            supply_flow_,
                            value_of(c.area_a) * value_of(p_a_) - value_of(c.area_b) * value_of(p_b_),
                            value_of(c.bulk_modulus_Pa),
                            c.supply_pressure_Pa,
                            T(0.0),
                            T(0.0),
                            T(0.0),
                            T(0.0),
                            value_of(c.return_pressure_Pa)};
    terms_.on_oil(oil);
    const auto ports = plant::port_pressures(extends, oil.supply_pressure_Pa, T(c.return_pressure_Pa));
    const auto a = port_flow(conductance, T(ports.a_Pa - p_a_), c.laminar_pressure_Pa);
    const auto b = port_flow(conductance, T(ports.b_Pa - p_b_), c.laminar_pressure_Pa);
    supply_flow_ = extends ? a.flow : b.flow;
    supply_flow_ = supply_flow_ > 0.0 ? supply_flow_ : T(0.0);

    const auto [v_a, v_b] = plant::at_least(plant::kSmallestVolumeShare * value_of(c.line_volume_m3),
                                            plant::chamber_volumes(c, data.middle_position[sub]));
    const T stiff_a = c.bulk_modulus_Pa / ((1.0 + c.bulk_modulus_Pa * oil.softness_a) * v_a);
    const T stiff_b = c.bulk_modulus_Pa / ((1.0 + c.bulk_modulus_Pa * oil.softness_b) * v_b);
    const T piston_speed =
        terms_.template find<plant::Backlash>() != nullptr ? speed_with_play(k, speed, stiff_a, stiff_b) : T(speed);
    const T rate_a =
        plant::pressure_rate<T>(stiff_a, a.flow + oil.into_a_m3_s - oil.leakage_m3_s, c.area_a * piston_speed);
    const T rate_b =
        plant::pressure_rate<T>(stiff_b, b.flow + oil.into_b_m3_s + oil.leakage_m3_s, -c.area_b * piston_speed);
    // Exponential Euler of Rosenbrock's kind (Hochbruck, Ostermann 2010, (1.1)): exact for a linear port.
    p_a_ += h * decaying_share(h * value_of(stiff_a) * a.slope) * rate_a;
    p_b_ += h * decaying_share(h * value_of(stiff_b) * b.slope) * rate_b;
  }

  /// Flow of a port and its slope; no derivative of the slope is needed.
  struct Port {
    T flow;
    double slope;
  };
  static Port port_flow(const T& gain, const T& drop_Pa, double laminar_pressure_Pa) {
    const double drop = value_of(drop_Pa);
    const auto port = plant::port_flow<double>(value_of(gain), drop, laminar_pressure_Pa);
    const double per_gain = plant::orifice_root(drop, laminar_pressure_Pa);
    return {chained(port.flow, per_gain, gain, port.slope, drop_Pa), port.slope};
  }

  /// Mean speed of the piston over a substep, at `speed` of the load.
  T speed_with_play(std::size_t k, double speed, const T& stiff_a, const T& stiff_b) {
    const Constants<T>& c = *c_;
    const double h = data_->step_s();
    plant::PlayMoment<T> play{
        plant::hydraulic_force(c, p_a_, p_b_) - c.piston_damping * speed - c.piston_mass * data_->acceleration[k],
        c.piston_damping, c.area_a * c.area_a * stiff_a + c.area_b * c.area_b * stiff_b, h, T(0.0)};
    terms_.on_play(play);
    return speed + play.moved / h;
  }

  const JointData* data_;
  const Constants<T>* c_;
  plant::TermSet<T> terms_;
  DelayedCommand<T> current_;
  T sensor_gain_ = T(1.0);
  T p_a_, p_b_;
  T supply_flow_ = T(0.0);
};

}  // namespace farrier::diagnosis
