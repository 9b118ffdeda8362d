// The laws of wiring_relations.hpp, each a least-squares fit within bounds that hold what effects do.

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

#include "diagnosis/wiring/wiring_motion.hpp"
#include "plant/oil.hpp"

namespace farrier::diagnosis {
namespace {

// Factors of the numbers of a joint that effects explain.
constexpr double kLeastFactor = 0.2;
constexpr double kMostFactor = 5.0;
constexpr double kDryShare = 0.3;    // of the force: dry friction
constexpr double kCalmShare = 0.1;   // of the motion's rms: slower motion has less dry friction
constexpr double kAreaError = 0.05;  // of the ratio of both areas

/// Values behind a first-order lag of that many samples.
std::vector<double> lagged(std::vector<double> values, double samples) {
  const double kept = (2.0 * samples - 1.0) / (2.0 * samples + 1.0), taken = 1.0 / (2.0 * samples + 1.0);
  double before = values.front(), at = values.front();
  for (double& value : values) {
    at = kept * at + taken * (value + before);
    before = std::exchange(value, at);
  }
  return values;
}

/// Adds points of a law to a regression.
auto into(BoxRegression& regression) {
  return [&regression](std::size_t, double y, const BoxRegression::Values& r) { regression.add(y, r); };
}

void add_delayed(std::vector<BoxRegression>& by_delay, const std::vector<int>& delays,
                 const std::vector<double>& current, const ChannelChange& change, std::size_t i,
                 const BoxRegression::Values& r) {
  for (std::size_t j = 0; j < delays.size(); ++j) {
    const std::size_t k = i + static_cast<std::size_t>(change.late) - static_cast<std::size_t>(delays[j]);
    by_delay[j].add(current[k] / change.factor, r);
  }
}

LawFit best_fit(const std::vector<BoxRegression>& by_delay, const std::vector<int>& delays,
                const std::array<BoxRegression::Bounds, BoxRegression::kMost>& bounds) {
  LawFit best{{.unexplained = std::numeric_limits<double>::infinity()}};
  for (std::size_t j = 0; j < delays.size(); ++j) {
    const BoxRegression::Result result = by_delay[j].solve(bounds);
    if (result.unexplained < best.regression.unexplained) {
      best = {result, delays[j]};
    }
  }
  return best;
}

/// Dry friction of unit size; smooth below the speed `calm`.
double friction_of(double speed, double calm) { return calm > 0.0 ? std::tanh(speed / calm) : 0.0; }

}  // namespace

template <class Add>
void WiringJudge::kinematics_points(const WiringHypothesis& h, std::size_t stride, Add&& add) const {
  const ChannelChange& v = h.of(WiredChannel::kVelocity);
  const Motion motion = by_position(h);
  const std::ptrdiff_t late = v.late;
  each(stride, [&](std::size_t i) {
    const double now = signals_.velocity[0][i + late] / v.factor;
    add(i, now, {motion.speed(i), -signals_.velocity[1][i + late] / v.factor});
  });
}

BoxRegression::Result WiringJudge::kinematics(const WiringHypothesis& h, double longest_lag_s) const {
  BoxRegression regression(2);
  kinematics_points(h, stride_, into(regression));
  return regression.solve({{{0.8, 1.25}, {0.0, longest_lag_s}}});
}

template <class Add>
void WiringJudge::load_points(const WiringHypothesis& h, const Motion& motion, double motion_lag_s, std::size_t stride,
                              Add&& add) const {
  const ChannelChange& f = h.of(WiredChannel::kForce);
  const bool quick = motion.x == &signals_.travel;
  // The lag of the motion's sensor, put on the force too: undone, it would raise the noise of the motion.
  const std::vector<double> lagged_force =
      motion_lag_s > 0.0 ? lagged(signals_.quick_force, motion_lag_s / period_s_) : std::vector<double>();
  const std::vector<double>& force = !quick               ? signals_.force[0]
                                     : motion_lag_s > 0.0 ? lagged_force
                                                          : signals_.quick_force;
  const auto late = static_cast<std::size_t>(f.late);
  const double calm = kCalmShare * std::abs(motion.factor) * standard(*motion.v);
  each(stride, [&](std::size_t i) {
    if (signals_.load_known[i] != 0) {
      const double v = motion.speed(i);
      add(i, force[i + late] / f.factor,
          {motion.acceleration(i), v, motion.position(i), friction_of(v, calm),
           -signals_.force[1][i + late] / f.factor});
    }
  });
}

BoxRegression::Result WiringJudge::load(const WiringHypothesis& h, const Motion& motion, double longest_lag_s,
                                        double motion_lag_s) const {
  BoxRegression regression(5);
  load_points(h, motion, motion_lag_s, stride_, into(regression));
  const ChannelChange& f = h.of(WiredChannel::kForce);
  const double force_rms = force_rms_ / std::abs(f.factor);
  const double scale = std::abs(motion.factor);
  const double dry = kDryShare * force_rms;
  const double spring = travel_rms_ > 0.0 ? force_rms / (scale * travel_rms_) : 0.0;
  // A weight pulls away from where it stands upright.
  return regression.solve(
      {{{kLeastFactor * load_.mass, kMostFactor * (load_.mass + rotor_.inertia)},
        {kLeastFactor * load_.damping,
         kMostFactor * (load_.damping + rotor_.damping) + (speed_rms_ > 0.0 ? dry / (scale * speed_rms_) : 0.0)},
        {electric_ ? -spring : kLeastFactor * load_.stiffness,
         kMostFactor * load_.stiffness + (load_.stiffness > 0.0 && !electric_ ? 0.0 : spring)},
        {0.0, electric_ ? dry + kMostFactor * rotor_.coulomb : 0.0},  // damping stands for it in oil
        {0.0, longest_lag_s}}});
}

template <class Add>
void WiringJudge::cell_points(const WiringHypothesis& h, std::size_t stride, Add&& add) const {
  const ChannelChange& f = h.of(WiredChannel::kForce);
  const ChannelChange& a = h.of(WiredChannel::kPressureA);
  const ChannelChange& b = h.of(WiredChannel::kPressureB);
  const std::vector<double>& in_a = h.pressures_exchanged ? signals_.pressure_b : signals_.pressure_a;
  const std::vector<double>& in_b = h.pressures_exchanged ? signals_.pressure_a : signals_.pressure_b;
  const Motion motion = by_position(h);
  const double calm = kCalmShare * std::abs(motion.factor) * speed_rms_;
  each(stride, [&](std::size_t i) {
    const std::size_t k = i + static_cast<std::size_t>(f.late);
    const double pressure_b_Pa = in_b[i + static_cast<std::size_t>(b.late)] / b.factor;
    const double oil =
        plant::hydraulic_force(actuator_, in_a[i + static_cast<std::size_t>(a.late)] / a.factor, pressure_b_Pa);
    const double v = motion.speed(i);
    add(i, signals_.force[0][k] / f.factor + actuator_.piston_mass * motion.acceleration(i),
        {oil, -actuator_.area_b * pressure_b_Pa, -v, -friction_of(v, calm), -signals_.force[1][k] / f.factor});
  });
}

BoxRegression::Result WiringJudge::cell(const WiringHypothesis& h, double longest_lag_s) const {
  BoxRegression regression(5);
  cell_points(h, stride_, into(regression));
  const ChannelChange& f = h.of(WiredChannel::kForce);
  const double dry_force = kDryShare * force_rms_ / std::abs(f.factor);
  const double dry = speed_rms_ > 0.0 ? dry_force / speed_rms_ : 0.0;
  return regression.solve({{{0.15, kMostFactor},
                            {-kAreaError, kAreaError},
                            {0.5 * actuator_.piston_damping, 2.0 * actuator_.piston_damping + dry},
                            {0.0, dry_force},
                            {0.0, longest_lag_s}}});
}

double WiringJudge::force_lag(const WiringHypothesis& h) const {
  if (!signals_.pressure_a.empty() && !signals_.pressure_b.empty()) {
    return cell(h, kLongestLag_s).coefficients[4];
  }
  return load_ever_known_ ? load(h, by_position(h), kLongestLag_s).coefficients[3] : 0.0;
}

std::vector<int> WiringJudge::input_delays(const ChannelChange& current) const {
  std::vector<int> delays{0};
  if (current.late == 0) {
    for (const double share : {0.03, 0.07, 0.1, 0.15, 0.2, 0.3, 0.4, 0.55, 0.7, 0.85, 1.0}) {
      const int delay = static_cast<int>(share * longest_delay_);
      if (delay > delays.back()) {
        delays.push_back(delay);
      }
    }
  }
  return delays;
}

const std::vector<double>& WiringJudge::current_of(const WiringHypothesis& h) const noexcept {
  return signals_.current[electric_ ? 2 : h.of(WiredChannel::kForce).factor < 0.0 ? 1 : 0];
}

template <class Add>
void WiringJudge::oil_points(const WiringHypothesis& h, const Motion& motion, std::size_t stride, Add&& add) const {
  const ChannelChange& f = h.of(WiredChannel::kForce);
  const auto volumes = plant::chamber_volumes(actuator_, 0.5 * actuator_.stroke);
  const double a = actuator_.area_a, b = actuator_.area_b, e = actuator_.bulk_modulus_Pa;
  const double held = e * (a * a / volumes.a_m3 + b * b / volumes.b_m3);
  const double driven =
      e * (a / volumes.a_m3 + b / volumes.b_m3) * actuator_.valve_gain * std::sqrt(0.5 * actuator_.supply_pressure_Pa);
  const double lag_s = force_lag(h);
  const double calm = kCalmShare * held * std::abs(motion.factor) * standard(*motion.v);
  each(stride, [&](std::size_t i) {
    const std::size_t k = i + static_cast<std::size_t>(f.late);
    const double flow = held * motion.speed(i) + actuator_.piston_damping * motion.acceleration(i) +
                        actuator_.piston_mass * motion.jolt(i);
    const double rise = (signals_.force[1][k] + lag_s * signals_.force[2][k]) / f.factor;
    add(i, {flow / driven, rise / driven, signals_.force[0][k] / f.factor, friction_of(flow, calm)});
  });
}

LawFit WiringJudge::oil(const WiringHypothesis& h, const Motion& motion) const {
  const ChannelChange& u = h.of(WiredChannel::kCurrent);
  const std::vector<int> delays = input_delays(u);
  std::vector<BoxRegression> by_delay(delays.size(), BoxRegression(4));
  oil_points(h, motion, stride_, [&](std::size_t i, const BoxRegression::Values& r) {
    add_delayed(by_delay, delays, current_of(h), u, i, r);
  });
  const double most_leakage = 0.3 * actuator_.valve_current_max_A /
                              (actuator_.supply_pressure_Pa * std::min(actuator_.area_a, actuator_.area_b));
  return best_fit(
      by_delay, delays,
      {{{0.3, 3.5}, {kLeastFactor, 8.0}, {0.0, most_leakage}, {0.0, 0.5 * current_rms_ / std::abs(u.factor)}}});
}

LawFit WiringJudge::actuator_law(const WiringHypothesis& h, const Motion& motion) const {
  return electric_ ? drive(h, motion) : oil(h, motion);
}

template <class Add>
void WiringJudge::drive_points(const WiringHypothesis& h, const Motion& motion, std::size_t stride, Add&& add) const {
  const ChannelChange& f = h.of(WiredChannel::kForce);
  const double constant = electric_->gear_ratio * electric_->torque_constant_Nm_A;
  const double calm = kCalmShare * std::abs(motion.factor) * standard(*motion.v);
  each(stride, [&](std::size_t i) {
    const std::size_t k = i + static_cast<std::size_t>(f.late);
    const double v = motion.speed(i);
    const double scale = 1.0 / (f.factor * constant);
    add(i, {signals_.force[0][k] * scale, v / constant, motion.acceleration(i) / constant, signals_.force[1][k] * scale,
            signals_.force[2][k] * scale, friction_of(v, calm)});
  });
}

LawFit WiringJudge::drive(const WiringHypothesis& h, const Motion& motion) const {
  const ChannelChange& u = h.of(WiredChannel::kCurrent);
  const plant::ElectricParams& e = *electric_;
  const double constant = e.gear_ratio * e.torque_constant_Nm_A;
  const std::vector<int> delays = input_delays(u);
  std::vector<BoxRegression> by_delay(delays.size(), BoxRegression(6));
  drive_points(h, motion, stride_, [&](std::size_t i, const BoxRegression::Values& r) {
    add_delayed(by_delay, delays, current_of(h), u, i, r);
  });
  constexpr BoxRegression::Bounds kAny{0.3, 3.5}, kNo{0.0, 0.0};
  const auto about = [](double value, double more = 0.0) {
    return BoxRegression::Bounds{kLeastFactor * value, kMostFactor * value + more};
  };
  if (e.rigid) {
    return best_fit(by_delay, delays, {{kAny, kNo, kNo, about(e.torque_time_constant_s, kLongestLag_s), kNo, kNo}});
  }
  const double k = e.spring_stiffness, rotor = plant::armature_kg_m2(e), damping = plant::rotor_damping(e);
  const double dry = 0.5 * current_rms_ / std::abs(u.factor) + kMostFactor * e.coulomb / constant;
  return best_fit(by_delay, delays,
                  {{kAny,
                    about(damping),
                    about(rotor),
                    about(damping / k, kLongestLag_s),
                    about(rotor / k, kLongestLag_s * damping / k),
                    {0.0, dry}}});
}

LawLine WiringJudge::line(WiringLaw of, const WiringHypothesis& h, const LawFit& fit) const {
  LawLine line;
  double apart = 0.0;
  const auto add = [&](std::size_t i, double y, const BoxRegression::Values& r) {
    line.at.push_back(i);
    line.left.push_back(y);
    line.right.push_back(std::inner_product(r.begin(), r.end(), fit.regression.coefficients.begin(), 0.0));
    apart += y - line.right.back();
  };
  const ChannelChange& u = h.of(WiredChannel::kCurrent);
  const auto add_current = [&](std::size_t i, const BoxRegression::Values& r) {
    add(i, current_of(h)[i + static_cast<std::size_t>(u.late) - static_cast<std::size_t>(fit.delay)] / u.factor, r);
  };
  const Motion motion = motion_of(of, h);
  switch (of) {
    case WiringLaw::kKinematics:
      kinematics_points(h, 1, add);
      break;
    case WiringLaw::kLoadByPosition:
    case WiringLaw::kLoadByVelocity:
      load_points(h, motion, of == WiringLaw::kLoadByVelocity ? velocity_lag_s(h) : 0.0, 1, add);
      break;
    case WiringLaw::kActuatorByPosition:
    case WiringLaw::kActuatorByVelocity:
      electric_ ? drive_points(h, motion, 1, add_current) : oil_points(h, motion, 1, add_current);
      break;
    case WiringLaw::kCell:
      cell_points(h, 1, add);
      break;
    case WiringLaw::kLevels:
      break;
  }
  // The laws hold about the mean.
  for (double& right : line.right) {
    right += apart / static_cast<double>(line.right.size());
  }
  return line;
}

}  // namespace farrier::diagnosis
