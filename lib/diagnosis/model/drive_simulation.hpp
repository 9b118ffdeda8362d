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
    lagged_A_ = admitted(command_.mean(begin), data.velocity[begin]);
    current_A_ = (torque_ + numbers.damping * speed_) / numbers.constant;
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
    std::array<T, kParts> means;
    advance(k, means);
    shift(pull * error / sensor_gain_);
  }
  /// Advances to sample k + 1; `means` gets the mean torque over equal parts of the period.
  void advance(std::size_t k, std::array<T, kParts>& means) {
    constexpr std::size_t kEach = kSubsteps / kParts;
    for (std::size_t part = 0; part < kParts; ++part) {
      means[part] = T(0.0);
      for (std::size_t j = part * kEach; j < (part + 1) * kEach; ++j) {
        const auto [position, speed] = motion(k, j);
        const T now = command_.mean(k, j, kSubsteps);
        means[part] += (n_->rigid ? rigid_step(now, speed) : step(now, position, speed)) / static_cast<double>(kEach);
      }
    }
  }

 private:
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

  /// The command within the drive's limits, at a speed of the load.
  T admitted(const T& command_A, double speed) const {
    T most = n_->limit_A;
    T least = -n_->limit_A;
    if (n_->rigid) {
      // R u + N K v within +-V_max
      const double ohm = value_of(n_->resistance);
      const double back_V = value_of(n_->reading_Nm_A) * speed;
      const double high = std::clamp((n_->voltage_V - back_V) / ohm, -n_->most_A, n_->most_A);
      const double low = std::clamp((-n_->voltage_V - back_V) / ohm, -n_->most_A, n_->most_A);
      most = most < high ? most : T(high);
      least = least > low ? least : T(low);
    }
    return command_A > most ? most : command_A < least ? least : command_A;
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

  T rigid_step(const T& command_A, double speed) {
    const T wanted = n_->reading_Nm_A * admitted(command_A, speed);
    const T off = torque_ - wanted;
    torque_ = wanted + keep_ * off;
    return wanted + mean_keep_ * off;
  }

  T step(const T& command_A, double position, double load_speed) {
    const DriveNumbers<T>& n = *n_;
    const double h = step_of(*data_);
    const T u = lagged(admitted(command_A, load_speed));
    // Mean current i = alpha - beta w: (2 L / h) (i - i_0) = R (u - i) - N K w.
    const T inertia = 2.0 / h * n.inductance;
    const T per_volt = 1.0 / (inertia + n.resistance);
    const T alpha = (inertia * current_A_ + n.resistance * u) * per_volt;
    const T beta = n.constant * per_volt;
    const GearStep<T> gear = gear_step(n, bent_, T(speed_ - load_speed), h);
    GearStep<T> dry = dry_step(n, speed_);
    if (friction_) {
      plant::LoadMoment<T> contact{};
      contact.velocity = speed_;
      friction_->on_load(contact);
      dry.base += contact.hold;
      dry.slope += contact.slope;
    }
    // (2 J N^2 / h) (w - w_0) = N K i - d_r w - friction - cogging - T.
    const T mass = 2.0 / h * n.rotor;
    const T push = mass * speed_ + n.constant * alpha - dry.base + n.cogging_torque(bent_ + position) - gear.base +
                   gear.slope * load_speed;
    const T mean = push / (mass + n.constant * beta + n.damping + dry.slope + gear.slope);
    if (friction_) {
      friction_->after_load(mean);
    }
    current_A_ += 2.0 * (alpha - beta * mean - current_A_);
    speed_ += 2.0 * (mean - speed_);
    bent_ += h * (mean - load_speed);
    return gear.base + gear.slope * (mean - load_speed);
  }

  const JointData* data_;
  const DriveNumbers<T>* n_;
  plant::TermSet<T> terms_;
  std::optional<plant::LoadFriction<T>> friction_;
  DelayedCommand<T> command_;
  T sensor_gain_ = T(1.0);
  T keep_ = T(0.0), mean_keep_ = T(0.0);  ///< of the lag: after a substep, and on its mean
  T torque_ = T(0.0);                     ///< of a rigid drive
  T bent_ = T(0.0), speed_ = T(0.0), current_A_ = T(0.0), lagged_A_ = T(0.0);
};

}  // namespace farrier::diagnosis
