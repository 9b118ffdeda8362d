#pragma once

#include <array>
#include <optional>
#include <type_traits>

#include "diagnosis/model/constants.hpp"
#include "diagnosis/model/drive_simulation.hpp"
#include "diagnosis/model/load_simulation.hpp"
#include "diagnosis/model/rotor_and_load.hpp"
#include "diagnosis/model/sensed_force.hpp"

namespace farrier::diagnosis {

/// Simulates the load of an electric joint from a sample on, driven by the measured torque. The rotor of a rigid
/// drive moves with the load, or at the other end of a soft gear. A copy continues from the state of the original. The drive
/// that bends the torque is simulated with numbers D: double if no derivative is by a number that it depends on.
template <class T, class D = T>
class ElectricLoad {
 public:
  /// Starts in the measured motion. The references must outlive this.
  ElectricLoad(const JointData& data, const DriveNumbers<T>& numbers, const LoadNumbers<T>& load,
               const plant::TermSet<T>& terms, const DriveNumbers<D>& drive, const plant::TermSet<D>& drive_terms,
               std::size_t begin)
      : data_(&data), n_(&numbers), c_(&load), terms_(terms), torque_(data, terms, begin) {
    if (!data.current_A.empty()) {
      drive_.emplace(data, drive, drive_terms, begin);
    }
    settle(begin);
  }

  /// Sets the state to the measured motion of sample k.
  void settle(std::size_t k) {
    x_ = T(data_->position[k]);
    v_ = T(data_->velocity[k]);
    rotor_ = v_;
    bent_ = T(0.0);
    if (n_->elastic) {
      const T torque = motor_torque(torque_.now()) - n_->rotor * data_->acceleration[k];
      bent_ = torque / n_->stiffness;
      bent_ += !n_->plays ? T(0.0) : torque > 0.0 ? n_->half_play : T(-n_->half_play);
    }
  }

  /// Position at the current sample.
  const T& read() const { return x_; }

  /// Advances to sample k + 1, drawn to the measured motion by `pull` of the error. Call once per sample, in order.
  void advance(std::size_t k, double pull) {
    const double h = data_->load_step_s();
    const T speed_error = pull * (data_->velocity[k] - v_);
    x_ += pull * (data_->position[k] - x_);
    v_ += speed_error;
    rotor_ += speed_error;
    for (const T& torque : torques(k)) {
      plant::LoadMoment<T> load{x_ + 0.5 * h * v_,     v_,     c_->mass, c_->damping, c_->stiffness,
                                T(c_->slack_position), T(0.0), T(0.0),   T(0.0)};
      terms_.on_load(load);
      if (n_->hangs) {
        using std::sin;
        load.external_force -= n_->moment * sin(load.position - n_->hanging_rad);
      }
      if (!n_->rigid) {
        move(load, torque, h);
      } else if (!n_->elastic) {
        const GearStep<T> dry = dry_step(*n_, v_);
        load.mass += n_->rotor;
        load.damping += n_->damping + dry.slope;
        load.hold += dry.base;
        move(load, motor_torque(torque) + n_->cogging_torque(load.position), h);
      } else {
        move_apart(load, motor_torque(torque) + n_->cogging_torque(load.position + bent_), h);
      }
    }
  }

 private:
  static constexpr std::size_t kParts = SensedForce<T>::kParts;
  using Parts = typename SensedForce<T>::Parts;

  /// Torque of a rigid drive's motor for one that it believes to have.
  T motor_torque(const T& believed) const { return n_->constant / n_->reading_Nm_A * believed; }

  void move(const plant::LoadMoment<T>& load, const T& torque, double h) {
    const T mean = mean_speed(load, x_, v_, torque, h);
    terms_.after_load(mean);
    x_ += h * mean;
    v_ += 2.0 * (mean - v_);
  }

  /// Rotor and load, each at its end of the gear.
  void move_apart(const plant::LoadMoment<T>& load, const T& torque, double h) {
    const GearStep<T> dry = dry_step(*n_, rotor_);
    const GearStep<T> gear = gear_step(*n_, bent_, value_of(rotor_) - value_of(v_), h, gear_slope(*n_, h));
    const T mass = 2.0 / h * n_->rotor;
    const RotorStep<T> rotor{mass * rotor_ + torque - dry.base, mass + n_->damping + dry.slope};
    const auto [rotor_mean, mean] = mean_speeds(load, rotor, gear, x_, v_, h);
    terms_.after_load(mean);
    x_ += h * mean;
    v_ += 2.0 * (mean - v_);
    rotor_ += 2.0 * (rotor_mean - rotor_);
    bent_ += h * (rotor_mean - mean);
  }

  /// Mean torque over each substep from sample k on: its chord, bent as the drive bends it, or without a current as the
  /// samples about it.
  Parts torques(std::size_t k) { return torque_.advance(k, drive_ ? bend_by_drive(k) : bend_by_samples(k)); }

  Parts bend_by_drive(std::size_t k) {
    drive_->shift(of_drive(torque_.now()) - drive_->torque(k));
    const D from = drive_->torque(k);
    std::array<D, kParts> means;
    drive_->advance(k, means);
    const D to = drive_->torque(std::min(k + 1, data_->size() - 1));
    Parts bend;
    for (std::size_t j = 0; j < kParts; ++j) {
      bend[j] = T(means[j] - (from + (static_cast<double>(j) + 0.5) / kParts * (to - from)));
    }
    return bend;
  }

  static D of_drive(const T& number) {
    if constexpr (std::is_same_v<T, D>) {
      return number;
    } else {
      return D(value_of(number));
    }
  }

  /// The parabola of the mean second difference about the period.
  Parts bend_by_samples(std::size_t k) const {
    Parts bend{};
    if (k == 0 || k + 2 >= data_->size()) {
      return bend;
    }
    const std::vector<double>& f = data_->force;
    const double curved = 0.5 * (f[k - 1] - f[k] - f[k + 1] + f[k + 2]);
    for (std::size_t j = 0; j < kParts; ++j) {
      const double s = (static_cast<double>(j) + 0.5) / kParts;
      bend[j] = -0.5 * curved * s * (1.0 - s) / torque_.gain();
    }
    return bend;
  }

  const JointData* data_;
  const DriveNumbers<T>* n_;
  const LoadNumbers<T>* c_;
  plant::TermSet<T> terms_;
  std::optional<DriveSimulation<D>> drive_;
  T x_, v_;
  T rotor_, bent_;         ///< speed of the rotor, and its way ahead of the load
  SensedForce<T> torque_;  ///< at the sensor
};

}  // namespace farrier::diagnosis
