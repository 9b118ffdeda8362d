#pragma once

#include <cmath>

#include "diagnosis/model/constants.hpp"
#include "diagnosis/model/delayed_command.hpp"
#include "diagnosis/model/sensed_force.hpp"
#include "diagnosis/data/joint_data.hpp"
#include "plant/oil.hpp"
#include "plant/terms/terms.hpp"

namespace farrier::diagnosis {

/// Mean speed w of a load over a step of `h` s from position x and speed v, under a mean force. It is (2.24) in w:
///
///   m (2 w - 2 v) / h = F - d w - C (x + h w / 2 - x_eq) - hold - slope w
template <class T>
T mean_speed(const plant::LoadMoment<T>& load, const T& x, const T& v, const T& force, double h) {
  const T along = load.damping + load.slope + 0.5 * h * load.stiffness;
  const T push = force + load.external_force - load.stiffness * (x - load.slack_position) - load.hold;
  const T mass = 2.0 / h * load.mass;
  return (mass * v + push) / (mass + along);
}

/// Simulates the load from a sample on, driven by the measured force. A copy continues from the state of the original.
template <class T>
class LoadSimulation {
 public:
  /// Starts in the measured motion. `data` and `constants` must outlive this.
  LoadSimulation(const JointData& data, const Constants<T>& constants, const plant::TermSet<T>& terms,
                 std::size_t begin)
      : data_(&data),
        c_(&constants),
        terms_(terms),
        current_({data.current_A, data.current_integral, data.period_s}, terms),
        force_(data, terms, begin) {
    valve_moves_ =
        !data.current_A.empty() && (current_.delayed() || terms_.template find<plant::ValveDynamics>() != nullptr);
    if (terms_.template find<plant::FlexibleLoad>() != nullptr) {
      // Where a part on a spring swings hangs on all motion before.
      for (std::size_t k = 0; k < begin; ++k) {
        const T mean(0.5 * (data.velocity[k] + data.velocity[k + 1]));
        for (std::size_t part = 0; part < JointData::kLoadSubsteps; ++part) {
          terms_.follow_load(mean);
        }
      }
    }
    settle(begin);
  }

  /// Sets the state to the measured motion of sample k.
  void settle(std::size_t k) {
    x_ = T(data_->position[k]);
    v_ = T(data_->velocity[k]);
  }

  /// Position at the current sample.
  const T& read() const { return x_; }

  /// Advances to sample k + 1, drawn to the measured motion by `pull` of the error. Call once per sample, in order.
  void advance(std::size_t k, double pull) {
    const JointData& data = *data_;
    const double h = data.load_step_s();
    x_ += pull * (data.position[k] - x_);
    v_ += pull * (data.velocity[k] - v_);
    for (const T& force : forces(k)) {
      plant::LoadMoment<T> load{x_ + 0.5 * h * v_,     v_,     c_->mass, c_->damping, c_->stiffness,
                                T(c_->slack_position), T(0.0), T(0.0),   T(0.0)};
      terms_.on_load(load);
      const T mean = mean_speed(load, x_, v_, force, h);
      terms_.after_load(mean);
      x_ += h * mean;
      v_ += 2.0 * (mean - v_);
    }
  }

 private:
  static constexpr std::size_t kParts = SensedForce<T>::kParts;
  using Parts = typename SensedForce<T>::Parts;

  /// Mean force over each substep from sample k on: its chord, bent as the oil bends it.
  Parts forces(std::size_t k) {
    Parts bend{};
    if (valve_moves_) {
      bend = bend_by_valve(k);
    }
    for (std::size_t j = 0; j < kParts; ++j) {
      bend[j] += data_->bend[k * kParts + j];
    }
    return force_.advance(k, bend);
  }

  /// Bend of the force within a period, about its chord, by a valve that opens differently over it: from the flow at half
  /// the supply across each land, (2.10) to (2.15). A current that changes its sign from sample to sample leaves the
  /// chambers' pressures unknown.
  Parts bend_by_valve(std::size_t k) {
    const Constants<T>& c = *c_;
    const auto [v_a, v_b] = plant::chamber_volumes(c, data_->position[k]);
    const T flow_per_A = c.valve_gain * std::sqrt(0.5 * value_of(c.supply_pressure_Pa));
    const T rise_per_A = data_->load_step_s() * flow_per_A * c.bulk_modulus_Pa * (c.area_a / v_a + c.area_b / v_b);
    Parts bend;
    T whole(0.0);
    for (std::size_t j = 0; j < kParts; ++j) {
      plant::ValveMoment<T> valve{current_.mean(k, j, kParts), T(1.0)};
      terms_.on_valve(valve);
      const T rise = rise_per_A * valve.flow_factor * valve.opening_A;
      bend[j] = whole + 0.5 * rise;
      whole += rise;
    }
    for (std::size_t j = 0; j < kParts; ++j) {
      bend[j] -= (static_cast<double>(j) + 0.5) / kParts * whole;
    }
    return bend;
  }

  const JointData* data_;
  const Constants<T>* c_;
  plant::TermSet<T> terms_;
  DelayedCommand<T> current_;
  bool valve_moves_ = false;
  T x_, v_;
  SensedForce<T> force_;  ///< on the load
};

}  // namespace farrier::diagnosis
