#pragma once

#include <array>
#include <cmath>

#include "diagnosis/data/joint_data.hpp"
#include "diagnosis/model/delayed_command.hpp"
#include "diagnosis/model/drive_numbers.hpp"
#include "plant/terms/terms.hpp"

namespace farrier::diagnosis {

/// Simulates motor and gear of an electric joint from a sample on: current and motion to the torque at its sensor. The
/// equations are those of plant/electric_actuator.hpp, rotor and load joined by a spring as in Spong (1987), (4) and
/// (5), by the midpoint rule. A copy continues from the state of the original.
template <class T>
class DriveSimulation {
 public:
  /// Substeps of a period. The winding's time constant of 0.2 ms is then followed to 3 %.
  static constexpr std::size_t kSubsteps = 8;
  static constexpr std::size_t kParts = JointData::kLoadSubsteps;
  static double step_of(const JointData& data) noexcept { return data.period_s / kSubsteps; }

  /// Starts with the measured torque and motion. `data` and `numbers` must outlive this. `terms` has the effects of the
  /// input and of the force sensor.
  DriveSimulation(const JointData& data, const DriveNumbers<T>& numbers, const plant::TermSet<T>& terms,
                  std::size_t begin)
      : data_(&data),
        n_(&numbers),
        terms_(terms),
        friction_(numbers.gear_friction),
        command_({data.current_A, data.current_integral, data.period_s}, terms) {
    if (const auto* gain = terms_.template find<plant::ForceSensorGain>()) {
      sensor_gain_ = gain->gain();
    }
    T offset(0.0);
    if (const auto* term = terms_.template find<plant::ForceSensorOffset>()) {
      offset = term->offset();
    }
    const double h = step_of(data);
    if (value_of(numbers.lag_s) > 0.0) {
      using std::exp;
      const T share = h / numbers.lag_s;
      keep_ = exp(-share);
      mean_keep_ = (1.0 - keep_) / share;
    }
    torque_ = (data.force[begin] - offset) / sensor_gain_;
    bent_ = numbers.rigid ? T(0.0) : T(torque_ / numbers.stiffness);
    if (numbers.plays && !numbers.rigid) {
      bent_ += torque_ > 0.0 ? numbers.half_play : T(-numbers.half_play);
    }
    speed_ = T(data.velocity[begin]);
    lagged_A_ = admitted(numbers, command_.mean(begin), data.velocity[begin]);
    current_A_ = (torque_ + numbers.damping * speed_) / numbers.constant;
    const T inertia = 2.0 / h * numbers.inductance;
    const T per_volt = 1.0 / (inertia + numbers.resistance);
    of_current_ = inertia * per_volt;
    of_command_ = numbers.resistance * per_volt;
    beta_ = numbers.constant * per_volt;
    mass_ = 2.0 / h * numbers.rotor;
    resists_ = mass_ + numbers.constant * beta_ + numbers.damping;
    gear_slope_ = gear_slope(numbers, h);
  }

  /// Torque at the sensor, at sample k, the current one.
  T torque(std::size_t k) const {
    if (n_->rigid) {
      return torque_;
    }
    const T apart = speed_ - data_->velocity[k];
    return spring_torque(*n_, bent_) + (touches(*n_, bent_) ? T(n_->relaxation * apart) : T(0.0));
  }
  /// Reading of the torque sensor at sample k, the current one. Call once per sample.
  T read(std::size_t k) {
    plant::ForceMoment<T> sensor{torque(k)};
    terms_.on_force(sensor);
    return sensor.force;
  }

  /// Moves the torque at the sensor by `change`.
  void shift(const T& change) {
    if (n_->rigid) {
      torque_ += change;
    } else {
      bent_ += change / n_->stiffness;
    }
  }

  /// Advances to sample k + 1, the torque drawn by `pull` of its error, the measured less the read.
  void advance(std::size_t k, const T& error, double pull) {
    for (std::size_t j = 0; j < kSubsteps; ++j) {
      substep(k, j, nullptr);
    }
    shift(pull * error / sensor_gain_);
  }
  /// Advances to sample k + 1; `means` gets the mean torque over equal parts of the period.
  void advance(std::size_t k, std::array<T, kParts>& means) {
    constexpr std::size_t kEach = kSubsteps / kParts;
    for (std::size_t part = 0; part < kParts; ++part) {
      means[part] = T(0.0);
      for (std::size_t j = part * kEach; j < (part + 1) * kEach; ++j) {
        T mean;
        substep(k, j, &mean);
        means[part] += mean / static_cast<double>(kEach);
      }
    }
  }

 private:
  /// Part j of the period from sample k on. `mean_torque`, if any, gets the mean torque over it.
  void substep(std::size_t k, std::size_t j, T* mean_torque) {
    const auto [position, speed] = motion(k, j);
    const T now = command_.mean(k, j, kSubsteps);
    if (n_->rigid) {
      rigid_step(now, speed, mean_torque);
    } else {
      step(now, position, speed, mean_torque);
    }
  }

  /// Load's position amid a substep and its mean speed over it: the cubic through both samples' motion (Hermite).
  std::array<double, 2> motion(std::size_t k, std::size_t part) const {
    const JointData& data = *data_;
    const std::size_t next = std::min(k + 1, data.size() - 1);
    const double h = data.period_s;
    const double gap = data.position[next] - data.position[k];
    const double from = h * data.velocity[k];
    const double to = h * data.velocity[next];
    const auto along = [&](double s) {
      return s * (from + s * ((3.0 * gap - 2.0 * from - to) + s * (from + to - 2.0 * gap)));
    };
    const double s = static_cast<double>(part) / kSubsteps;
    constexpr double kStep = 1.0 / kSubsteps;
    return {data.position[k] + along(s + 0.5 * kStep), (along(s + kStep) - along(s)) / (h * kStep)};
  }

  /// Mean of the lagged command over a substep.
  T lagged(const T& command_A) {
    if (value_of(n_->lag_s) <= 0.0) {
      return command_A;
    }
    const T off = lagged_A_ - command_A;
    lagged_A_ = command_A + keep_ * off;
    return command_A + mean_keep_ * off;
  }

  void rigid_step(const T& command_A, double speed, T* mean_torque) {
    const T wanted = n_->reading_Nm_A * admitted(*n_, command_A, speed);
    const T off = torque_ - wanted;
    torque_ = wanted + keep_ * off;
    if (mean_torque != nullptr) {
      *mean_torque = wanted + mean_keep_ * off;
    }
  }

  void step(const T& command_A, double position, double load_speed, T* mean_torque) {
    const DriveNumbers<T>& n = *n_;
    const double h = step_of(*data_);
    // Mean current i = alpha - beta w: (2 L / h) (i - i_0) = R (u - i) - N K w.
    const T alpha = of_current_ * current_A_ + of_command_ * lagged(admitted(n, command_A, load_speed));
    const GearStep<T> gear = gear_step(n, bent_, value_of(speed_) - load_speed, h, gear_slope_);
    // (2 J N^2 / h) (w - w_0) = N K i - d_r w - friction - cogging - T.
    T push = mass_ * speed_ + n.constant * alpha - gear.base + gear.slope * load_speed;
    T resists = resists_ + gear.slope;
    if (n.coulomb != 0.0) {
      const GearStep<T> dry = dry_step(n, speed_);
      push -= dry.base;
      resists += dry.slope;
    }
    if (n.cogs) {
      push += n.cogging_torque(bent_ + position);
    }
    if (friction_) {
      plant::LoadMoment<T> contact{};
      contact.velocity = speed_;
      friction_->on_load(contact);
      push -= contact.hold;
      resists += contact.slope;
    }
    const T mean = push / resists;
    if (friction_) {
      friction_->after_load(mean);
    }
    const T apart = mean - load_speed;
    current_A_ = 2.0 * (alpha - beta_ * mean) - current_A_;
    speed_ = 2.0 * mean - speed_;
    bent_ += h * apart;
    if (mean_torque != nullptr) {
      *mean_torque = gear.base + gear.slope * apart;
    }
  }

  const JointData* data_;
  const DriveNumbers<T>* n_;
  plant::TermSet<T> terms_;
  std::optional<plant::LoadFriction<T>> friction_;
  DelayedCommand<T> command_;
  T sensor_gain_ = T(1.0);
  T keep_ = T(0.0), mean_keep_ = T(0.0);  ///< of the lag: after a substep, and on its mean
  T of_current_, of_command_, beta_;      ///< mean current of a substep: shares of both, and the loss per speed
  T mass_, resists_, gear_slope_;  ///< mean speed of a substep: of the rotor, all but friction and gear, and of these
  T torque_ = T(0.0);              ///< of a rigid drive
  T bent_ = T(0.0), speed_ = T(0.0), current_A_ = T(0.0), lagged_A_ = T(0.0);
};

}  // namespace farrier::diagnosis
