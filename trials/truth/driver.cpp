#include "trials/truth/driver.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <numbers>

#include "trials/truth/excitation.hpp"

namespace farrier::truth {
namespace {

constexpr double kTwoPi = 2.0 * std::numbers::pi;
constexpr double kCentring_s = 0.3;      ///< time constant of the way back to where the joint should be
constexpr double kLargestCurrent = 0.8;  ///< of the valve's largest
constexpr double kMeasuredShare = 0.5;   ///< of the velocity feed-forward that comes from the sensor
constexpr double kResetTime_s = 0.12;    ///< of the force controller's integral

// Impedance of the load, F = Z v, and velocity per current with the oil's spring between valve and masses.
std::complex<double> impedance(const Mechanics& m, double omega, double extra_stiffness) {
  return {m.load_damping, m.load_mass * omega - (m.load_stiffness + extra_stiffness) / omega};
}
std::complex<double> velocity_per_A(const Mechanics& m, double omega) {
  const std::complex<double> oil{0.0, -m.oil_stiffness / omega};
  const std::complex<double> piston{m.piston_damping, (m.mass - m.load_mass) * omega};
  return m.speed_per_A * oil / (oil + piston + impedance(m, omega, 0.0));
}

// 12 lines of current, 0.5 to 80 Hz. Each moves the joint by at most 6 % of its stroke and asks at most 5 % of its
// push.
std::vector<double> current_sines(const robot::Joint& joint, const Plan& plan, const Mechanics& m, double period_s,
                                  int ticks) {
  std::vector<double> out(static_cast<std::size_t>(ticks), 0.0);
  Draws draws(joint, plan, "truth multisine");
  const double fastest = std::min(80.0, 0.25 / period_s);
  for (int i = 0; i < 12; ++i) {
    const double f = 0.5 * std::pow(fastest / 0.5, (i + draws.within(-0.3, 0.3)) / 11.0), omega = kTwoPi * f;
    const std::complex<double> v = velocity_per_A(m, omega);
    const double amplitude =
        std::min({0.11 * m.current_max_A * std::pow(f / 0.5, -0.3), 0.06 * m.stroke * omega / std::abs(v),
                  0.05 * m.push / std::abs(v * impedance(m, omega, 0.0))});
    add_sine(out, period_s, omega, amplitude * draws.within(0.8, 1.2), draws.within(0.0, kTwoPi));
  }
  return out;
}

double resonance(const Mechanics& m) { return std::sqrt(m.oil_stiffness / m.mass); }

// Share of a step of current that has to be smoothed for the joint not to ring: all but 3 % below a damping ratio of
// 0.12, nothing above 0.22.
double smoothed_share(const Mechanics& m) {
  const double ratio = (m.load_damping + m.piston_damping) / (2.0 * m.mass * resonance(m));
  return 0.97 * std::clamp((0.22 - ratio) / 0.1, 0.0, 1.0);
}

// Mean over one period of the oil's resonance takes its ringing out of steps.
void calm_ringing(std::vector<double>& steps, const Mechanics& m, double period_s) {
  const double share = smoothed_share(m);
  const auto width = static_cast<std::size_t>(std::max(1.0, std::round(kTwoPi / resonance(m) / period_s)));
  const std::vector<double> raw = steps;
  double sum = 0.0;
  for (std::size_t k = 0; k < raw.size(); ++k) {
    sum += raw[k] - (k >= width ? raw[k - width] : 0.0);
    steps[k] = (1.0 - share) * raw[k] + share * sum / static_cast<double>(width);
  }
}

// Levels up to half the largest current, held 10 to 150 ms; longer ones lower, to stay within 12 % of the stroke, and
// all where smoothed steps would still ask more than half the push.
std::vector<double> current_steps(const robot::Joint& joint, const Plan& plan, const Mechanics& m, double period_s,
                                  int ticks) {
  std::vector<double> out;
  Draws draws(joint, plan, "truth steps");
  const double ramp_s = kTwoPi / resonance(m);
  const double by_force = smoothed_share(m) > 0.0 ? 0.5 * m.push * ramp_s / (m.mass * m.speed_per_A) : m.current_max_A;
  while (out.size() < static_cast<std::size_t>(ticks)) {
    const double hold_s = draws.log_within(0.010, 0.150);
    const double most = std::min({0.5 * m.current_max_A, 0.12 * m.stroke / (hold_s * m.speed_per_A), by_force});
    const double level = draws.sign() * draws.within(0.1, 1.0) * most;
    out.insert(out.end(), static_cast<std::size_t>(std::max(1.0, std::round(hold_s / period_s))), level);
  }
  out.resize(static_cast<std::size_t>(ticks));
  calm_ringing(out, m, period_s);
  return out;
}

// 8 lines of force, 1 to 15 Hz, and steps held 80 to 400 ms, behind a first-order lag of 8 ms and no faster than a
// spring follows at a quarter of full speed.
std::vector<double> force_reference(const robot::Joint& joint, const Plan& plan, const Mechanics& m, double period_s,
                                    int ticks, double centring) {
  std::vector<double> out(static_cast<std::size_t>(ticks), 0.0);
  Draws draws(joint, plan, "truth reference");
  for (int i = 0; i < 8; ++i) {
    const double omega = kTwoPi * std::pow(15.0, (i + draws.within(-0.3, 0.3)) / 7.0);
    const double z = std::abs(impedance(m, omega, centring));
    const double amplitude =
        std::min({0.07 * m.push, 0.06 * m.stroke * omega * z, 0.08 * m.current_max_A * m.speed_per_A * z});
    add_sine(out, period_s, omega, amplitude * draws.within(0.8, 1.2), draws.within(0.0, kTwoPi));
  }
  const double step = std::min(0.2 * m.push, 0.12 * m.stroke * kTwoPi * std::abs(impedance(m, kTwoPi, centring)));
  const double fastest = 0.25 * m.current_max_A * m.speed_per_A * (m.load_stiffness + centring) * period_s;
  double level = 0.0, smooth = 0.0;
  int left = 0;
  for (double& force : out) {
    if (left-- <= 0) {
      left = static_cast<int>(draws.log_within(0.08, 0.4) / period_s);
      level = draws.within(-step, step);
    }
    smooth += std::clamp((level - smooth) * std::min(1.0, period_s / 0.008), -fastest, fastest);
    force += smooth;
  }
  return out;
}

}  // namespace

Mechanics mechanics_of(const robot::Joint& joint) {
  const plant::ActuatorParams& a = joint.actuator;
  const double half = 0.5 * a.stroke;
  Mechanics m;
  m.speed_per_A =
      a.valve_gain * std::sqrt(0.5 * (a.supply_pressure_Pa - a.return_pressure_Pa)) / (0.5 * (a.area_a + a.area_b));
  m.oil_stiffness = a.bulk_modulus_Pa * (a.area_a * a.area_a / (a.line_volume_m3 + a.area_a * half) +
                                         a.area_b * a.area_b / (a.line_volume_m3 + a.area_b * half));
  m.load_mass = joint.swing_load.mass;
  m.mass = a.piston_mass + m.load_mass;
  m.load_damping = joint.swing_load.damping;
  m.load_stiffness = joint.swing_load.stiffness;
  m.piston_damping = a.piston_damping;
  m.push = 0.5 * a.area_a * a.supply_pressure_Pa;
  m.stroke = a.stroke;
  m.current_max_A = a.valve_current_max_A;
  return m;
}

Driver::Driver(const robot::Joint& joint, const Clock& clock, const Plan& plan, double scale)
    : mechanics_(mechanics_of(joint)),
      period_s_(clock.period_s),
      closed_loop_(plan.excitation == Excitation::kForceTracking),
      // A load without spring drifts under force control; what the reference adds takes 80 % of the push at the ends.
      centring_stiffness_(std::max(0.0, 0.8 * mechanics_.push / mechanics_.stroke - mechanics_.load_stiffness)) {
  const int ticks = static_cast<int>(std::lround(plan.duration_s / period_s_));
  if (closed_loop_) {
    drive_ = force_reference(joint, plan, mechanics_, period_s_, ticks, centring_stiffness_);
  } else if (plan.excitation == Excitation::kMultisine) {
    drive_ = current_sines(joint, plan, mechanics_, period_s_, ticks);
  } else {
    drive_ = current_steps(joint, plan, mechanics_, period_s_, ticks);
  }
  const std::vector<double> level = envelope(joint, plan, period_s_, ticks);
  for (std::size_t k = 0; k < drive_.size(); ++k) {
    drive_[k] *= scale * level[k];
  }
}

double Driver::bring_back(double off_middle, const Reading& measured) const {
  return (0.5 * mechanics_.stroke + off_middle - measured.position) / (kCentring_s * mechanics_.speed_per_A);
}

//   u = (eta v + (1 - eta) v_model + (x_model - x) / T_c) / (speed per A) + k_p (e + integral of e / T_i)
//   e = F_ref - k_c (x - x_mid) - F
// The model's load follows the reference. A valve gives flow: without T_c a bias of it would walk to the end of the
// stroke before k_p, bounded by the oil's resonance, does anything.
double Driver::track(double reference, const Reading& measured) {
  const Mechanics& m = mechanics_;
  const double stiffness = m.load_stiffness + centring_stiffness_;
  const double acceleration = (reference - m.load_damping * model_v_ - stiffness * model_x_) / m.load_mass;
  model_v_ += period_s_ * acceleration;
  model_x_ += period_s_ * model_v_;

  const double wanted = reference - centring_stiffness_ * (measured.position - 0.5 * m.stroke);
  const double bandwidth_rad_s = std::clamp(0.35 * (m.load_damping + m.piston_damping) / m.mass, 50.0, 150.0);
  const double gain = bandwidth_rad_s / (m.oil_stiffness * m.speed_per_A);
  const double error = wanted - measured.force;
  const double feed_forward = (kMeasuredShare * measured.velocity + (1.0 - kMeasuredShare) * model_v_) / m.speed_per_A;
  integral_A_ =
      std::clamp(integral_A_ + gain * error * period_s_ / kResetTime_s, -0.1 * m.current_max_A, 0.1 * m.current_max_A);
  return feed_forward + bring_back(model_x_, measured) + gain * error + integral_A_;
}

double Driver::current(int k, const Reading& measured) {
  const double drive = k < 0 ? 0.0 : drive_[static_cast<std::size_t>(k)];
  const double wanted = closed_loop_ ? track(drive, measured) : drive + bring_back(0.0, measured);
  const double most = kLargestCurrent * mechanics_.current_max_A;
  return std::clamp(wanted, -most, most);
}

}  // namespace farrier::truth
