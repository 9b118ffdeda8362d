#include "diagnosis/data/joint_data.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include <Eigen/Core>
#include <Eigen/LU>

namespace farrier::diagnosis {
namespace {

using Vector3 = Eigen::Vector3d;
using Matrix3 = Eigen::Matrix3d;

/// Margin on the likeliest jerk: calm parts of a recording must not smooth away quick ones.
constexpr double kJerkMargin = 10.0;

struct Kinematics {
  Matrix3 transition;
  Matrix3 process;  // for a jerk density of 1
};

Kinematics kinematics(double h) {
  Kinematics k;
  k.transition << 1, h, h * h / 2, 0, 1, h, 0, 0, 1;
  // Integrated white jerk: Bar-Shalom, Li and Kirubarajan (2001), 6.2.3.
  k.process << std::pow(h, 5) / 20, std::pow(h, 4) / 8, h * h * h / 6,  //
      std::pow(h, 4) / 8, h * h * h / 3, h * h / 2,                     //
      h * h * h / 6, h * h / 2, h;
  return k;
}

/// Steady gain of the filter and its innovation's variance.
struct SteadyFilter {
  Vector3 gain;
  Matrix3 predicted, updated;
  double variance;
};

SteadyFilter steady_filter(const Kinematics& k, double density, double noise) {
  SteadyFilter f;
  f.predicted = Matrix3::Identity();
  for (int i = 0; i < 2000; ++i) {
    f.variance = f.predicted(0, 0) + noise * noise;
    f.gain = f.predicted.col(0) / f.variance;
    // Joseph's form: symmetric and positive with any rounding.
    const Matrix3 left = Matrix3::Identity() - f.gain * Eigen::RowVector3d(1.0, 0.0, 0.0);
    f.updated = left * f.predicted * left.transpose() + f.gain * (noise * noise) * f.gain.transpose();
    const Matrix3 next = k.transition * f.updated * k.transition.transpose() + density * k.process;
    const double change = (next - f.predicted).cwiseAbs().maxCoeff() / next.cwiseAbs().maxCoeff();
    f.predicted = 0.5 * (next + next.transpose());
    if (change < 1e-12) {
      break;
    }
  }
  return f;
}

double negative_log_likelihood(const Kinematics& k, double density, double noise, const std::vector<double>& y) {
  const SteadyFilter f = steady_filter(k, density, noise);
  Vector3 state(y[0], 0.0, 0.0);
  double sum = 0.0;
  for (std::size_t i = 1; i < y.size(); ++i) {
    state = k.transition * state;
    const double innovation = y[i] - state[0];
    state += f.gain * innovation;
    sum += i > 50 ? innovation * innovation / f.variance + std::log(f.variance) : 0.0;
  }
  return sum;
}

/// Jerk density that makes the positions likeliest, m^2/s^5.
double likeliest_density(const Kinematics& k, double noise, const std::vector<double>& y) {
  double best = 0.0;
  double lowest = std::numeric_limits<double>::infinity();
  for (double exponent = -6.0; exponent <= 12.0; exponent += 0.5) {
    const double density = noise * noise / 4e-12 * std::pow(10.0, exponent);
    const double value = negative_log_likelihood(k, density, noise, y);
    if (value < lowest) {
      lowest = value;
      best = density;
    }
  }
  return best;
}

/// Position, velocity and acceleration at the share s of a period, on the quintic through both ends' states.
std::array<double, 3> motion_at(const std::array<double, 3>& from, const std::array<double, 3>& to, double h,
                                double s) {
  const double gap = to[0] - from[0] - h * from[1] - 0.5 * h * h * from[2];
  const double speed_gap = h * (to[1] - from[1] - h * from[2]);
  const double rate_gap = h * h * (to[2] - from[2]);
  const double c3 = 10 * gap - 4 * speed_gap + 0.5 * rate_gap;
  const double c4 = -15 * gap + 7 * speed_gap - rate_gap;
  const double c5 = 6 * gap - 3 * speed_gap + 0.5 * rate_gap;
  return {from[0] + s * (h * from[1] + s * (0.5 * h * h * from[2] + s * (c3 + s * (c4 + s * c5)))),
          from[1] + s * (h * from[2] + s * (3 * c3 + s * (4 * c4 + s * 5 * c5)) / h),
          from[2] + s * (6 * c3 + s * (12 * c4 + s * 20 * c5)) / (h * h)};
}

/// Force that the motion takes from the load cell while the valve's flow is held, (2.10) to (2.13) with (2.22): the
/// oil's stiffness over the way that was made, d_p v and m_p a. Its zero is anywhere: only differences mean something.
double oil_pull(const plant::ActuatorParams& actuator, const std::array<double, 3>& motion) {
  const double v_a = actuator.line_volume_m3 + actuator.area_a * std::max(motion[0], 0.0);
  const double v_b = actuator.line_volume_m3 + actuator.area_b * std::max(actuator.stroke - motion[0], 0.0);
  const double compressed =
      actuator.bulk_modulus_Pa * (actuator.area_a * std::log(v_a) - actuator.area_b * std::log(v_b));
  return compressed + actuator.piston_damping * motion[1] + actuator.piston_mass * motion[2];
}

/// Samples at which the load is known and the smoothed motion is its own: a load that begins to swing changes its
/// acceleration at once, and the smoother smears that over some of its time.
std::vector<std::uint8_t> settled_swing(std::vector<std::uint8_t> swing, double period_s) {
  constexpr double kSmeared_s = 0.02;
  const auto smeared = static_cast<std::size_t>(kSmeared_s / period_s);
  for (std::size_t i = swing.size(); i-- > 1;) {
    for (std::size_t back = 1; swing[i] != 0 && back <= std::min(smeared, i); ++back) {
      swing[i] = swing[i - back] != 0 ? swing[i] : std::uint8_t{0};
    }
  }
  return swing;
}

}  // namespace

MotionSmoother::MotionSmoother(double period_s, double jerk_density, double position_noise) : period_s_(period_s) {
  const Kinematics k = kinematics(period_s);
  const SteadyFilter f = steady_filter(k, jerk_density, position_noise);
  const Matrix3 back = f.updated * k.transition.transpose() * f.predicted.inverse();
  for (Eigen::Index i = 0; i < 3; ++i) {
    gain_[static_cast<std::size_t>(i)] = f.gain[i];
    for (Eigen::Index j = 0; j < 3; ++j) {
      back_[static_cast<std::size_t>(i)][static_cast<std::size_t>(j)] = back(i, j);
    }
  }
}

namespace {

/// Fills all but the bend; `take(data, motion, motion of the next sample)` is called for each sample.
template <class Take>
JointData prepare_with(const Recording& recording, double position_noise, Take&& take) {
  const double h = recording.period_s;
  const std::vector<double>& x = recording.position;
  const double density = likeliest_density(kinematics(h), position_noise, x);
  JointData data{.period_s = h,
                 .current_A = recording.valve_current_A,
                 .current_integral = {0.0},
                 .position = {},
                 .velocity = {},
                 .acceleration = {},
                 .motion = {},
                 .middle_position = {},
                 .middle_velocity = {},
                 .measured_position = x,
                 .measured_velocity = recording.velocity,
                 .force = recording.force,
                 .bend = {},
                 .swing = settled_swing(recording.swing, h),
                 .smoother = MotionSmoother(h, density / kJerkMargin, position_noise)};
  for (const double current : data.current_A) {
    data.current_integral.push_back(data.current_integral.back() + current * h);
  }
  const std::size_t near = std::min<std::size_t>(10, x.size() - 1);
  const double first_speed = (x[near] - x[0]) / (static_cast<double>(near) * h);
  const MotionSmoother quick(h, kJerkMargin * density, position_noise);
  const auto motion = quick.smooth<double>(x, {x[0], first_speed, 0.0});
  for (std::size_t i = 0; i < motion.size(); ++i) {
    data.position.push_back(motion[i][0]);
    data.velocity.push_back(motion[i][1]);
    data.acceleration.push_back(motion[i][2]);
    data.motion.push_back(motion[i][1] + motion[i][0] / JointData::kMotionTime_s);
    const auto& next = motion[std::min(i + 1, motion.size() - 1)];
    const auto at = [&](std::size_t part, double middle, std::size_t parts) {
      return motion_at(motion[i], next, h, (static_cast<double>(part) + middle) / static_cast<double>(parts));
    };
    for (std::size_t j = 0; j < JointData::kSubsteps; ++j) {
      data.middle_position.push_back(at(j, 0.5, JointData::kSubsteps)[0]);
      data.middle_velocity.push_back((at(j, 1.0, JointData::kSubsteps)[0] - at(j, 0.0, JointData::kSubsteps)[0]) /
                                     data.step_s());
    }
    take(data, motion[i], next);
  }
  return data;
}

}  // namespace

JointData prepare(const Recording& recording, double position_noise) {
  return prepare_with(recording, position_noise, [](JointData&, const auto&, const auto&) {});
}

JointData prepare(const Recording& recording, const plant::ActuatorParams& actuator, double position_noise) {
  return prepare_with(recording, position_noise, [&](JointData& data, const auto& from, const auto& to) {
    const double here = oil_pull(actuator, from);
    const double there = oil_pull(actuator, to);
    for (std::size_t j = 0; j < JointData::kLoadSubsteps; ++j) {
      const double share = (static_cast<double>(j) + 0.5) / JointData::kLoadSubsteps;
      data.bend.push_back(here + share * (there - here) -
                          oil_pull(actuator, motion_at(from, to, data.period_s, share)));
    }
  });
}

}  // namespace farrier::diagnosis
