#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "diagnosis/data/recording.hpp"
#include "plant/actuator.hpp"

namespace farrier::diagnosis {

/// The motion that fits measured positions best under a white jerk, with the steady gains of Rauch, Tung and Striebel
/// (1965): position, velocity and acceleration that belong together. Linear: the result for a difference of positions
/// is the difference of the results.
class MotionSmoother {
 public:
  /// `jerk_density` m^2/s^5 (or rad), `position_noise` standard deviation of a position.
  MotionSmoother(double period_s, double jerk_density, double position_noise);

  /// Position, velocity, acceleration at each sample. T is double, or a number with derivatives.
  template <class T>
  std::vector<std::array<T, 3>> smooth(const std::vector<T>& positions, const std::array<T, 3>& first) const;

 private:
  std::array<std::array<double, 3>, 3> back_;
  std::array<double, 3> gain_;
  double period_s_;
};

/// A recording made ready for simulations of its two sides.
struct JointData {
  /// Substeps of one period in the simulation of valve and oil, and in that of the load. The load's trapezoidal rule
  /// and the force between samples must reproduce a resonance at a seventh of the sampling rate to half a per cent.
  static constexpr std::size_t kSubsteps = 2;
  static constexpr std::size_t kLoadSubsteps = 4;
  /// Time constant of the compared motion signal, velocity plus position over this time: the velocity shows quick
  /// changes, the position lasting ones.
  static constexpr double kMotionTime_s = 0.05;

  double period_s = 0.0;
  std::vector<double> current_A;                         ///< empty: not recorded
  std::vector<double> current_integral;                  ///< A s up to a sample; one more than samples
  std::vector<double> position, velocity, acceleration;  ///< smoothed
  std::vector<double> motion;                            ///< smoothed velocity + position / kMotionTime_s
  std::vector<double> middle_position;                   ///< of each substep
  std::vector<double> middle_velocity;                   ///< mean over each substep
  std::vector<double> measured_position, measured_velocity;
  std::vector<double> force;
  std::vector<double> bend;         ///< of the force beyond its chord, mean over each of the load's substeps
  std::vector<std::uint8_t> swing;  ///< 1 where the load is the one in the model; empty: everywhere
  MotionSmoother smoother;

  double step_s() const noexcept { return period_s / kSubsteps; }
  double load_step_s() const noexcept { return period_s / kLoadSubsteps; }
  std::size_t size() const noexcept { return force.size(); }
};

template <class T>
std::vector<std::array<T, 3>> MotionSmoother::smooth(const std::vector<T>& positions,
                                                     const std::array<T, 3>& first) const {
  const double h = period_s_;
  const auto ahead = [h](const std::array<T, 3>& s) -> std::array<T, 3> {
    return {s[0] + h * s[1] + 0.5 * h * h * s[2], s[1] + h * s[2], s[2]};
  };
  std::vector<std::array<T, 3>> states(positions.size(), first);
  for (std::size_t i = 1; i < positions.size(); ++i) {
    states[i] = ahead(states[i - 1]);
    const T innovation = positions[i] - states[i][0];
    for (std::size_t j = 0; j < 3; ++j) {
      states[i][j] += gain_[j] * innovation;
    }
  }
  for (std::size_t i = positions.size() - 1; i-- > 0;) {
    std::array<T, 3> news = ahead(states[i]);
    for (std::size_t j = 0; j < 3; ++j) {
      news[j] = states[i + 1][j] - news[j];
    }
    for (std::size_t j = 0; j < 3; ++j) {
      states[i][j] += back_[j][0] * news[0] + back_[j][1] * news[1] + back_[j][2] * news[2];
    }
  }
  return states;
}

/// `position_noise` is the standard deviation of a measured position, m or rad, > 0. Leaves JointData::bend empty.
JointData prepare(const Recording& recording, double position_noise);

/// The same of a hydraulic joint. Between samples the force follows
/// the motion as the oil of `actuator` makes it: the valve's flow changes little within a period, and the force rings.
JointData prepare(const Recording& recording, const plant::ActuatorParams& actuator, double position_noise);

}  // namespace farrier::diagnosis
