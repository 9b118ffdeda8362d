#include "diagnosis/wiring/wiring_relations.hpp"

#include <algorithm>
#include <cmath>

#include "diagnosis/data/sample_statistics.hpp"
#include "plant/oil.hpp"

namespace farrier::diagnosis {
namespace {

constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
// Factors of the numbers of a joint that effects explain.
constexpr double kLeastFactor = 0.2;
constexpr double kMostFactor = 5.0;
constexpr double kLongestLag_s = 0.05;    // of a load cell or a filter of the velocity
constexpr double kLongestDelay_s = 0.03;  // of an input
constexpr double kDryShare = 0.3;         // of the force: friction that damping does not stand for
constexpr std::size_t kPoints = 1500;     // that a law is judged by

double standard(const std::vector<double>& values) { return values.empty() ? 0.0 : standard_deviation(values); }

}  // namespace

/// Where the motion of a law comes from: true value at i is factor * lines[...][i + late].
struct WiringJudge::Motion {
  const std::vector<double>*x, *v, *a, *jerk;
  double factor;
  int late;
  double lag_s = 0.0;  ///< of the velocity; undone with the next derivative

  double at(const std::vector<double>& of, const std::vector<double>* next, std::size_t i) const {
    const std::size_t k = i + static_cast<std::size_t>(late);
    return factor * (of[k] + (lag_s > 0.0 && next != nullptr ? lag_s * (*next)[k] : 0.0));
  }
  double position(std::size_t i) const { return at(*x, lag_s > 0.0 ? v : nullptr, i); }
  double speed(std::size_t i) const { return at(*v, a, i); }
  double acceleration(std::size_t i) const { return at(*a, jerk, i); }
  double jolt(std::size_t i) const { return jerk == nullptr ? 0.0 : at(*jerk, nullptr, i); }
};

WiringJudge::WiringJudge(const Recording& recording, const robot::Joint& joint)
    : signals_(recording, joint),
      actuator_(joint.actuator),
      load_(joint.swing_load),
      period_s_(recording.period_s),
      most_late_(std::min(kMostLate, static_cast<int>(recording.position.size() / 20))),
      longest_delay_(static_cast<int>(kLongestDelay_s / recording.period_s)) {
  margin_ = signals_.width + static_cast<std::size_t>(std::max(most_late_, longest_delay_)) + 2;
  const std::size_t inner = signals_.size() > 2 * margin_ ? signals_.size() - 2 * margin_ : 0;
  stride_ = inner / kPoints + 1;
  std::size_t known = 0, all = 0;
  each([&](std::size_t i) {
    ++all;
    known += signals_.load_known[i] != 0 ? 1 : 0;
  });
  load_known_throughout_ = known == all;
  load_ever_known_ = known >= 200;
  force_rms_ = standard(signals_.force[0]);
  speed_rms_ = standard(signals_.position[1]);
  travel_rms_ = standard(signals_.position[0]);
  current_rms_ = standard(signals_.current[2]);
  const auto level = [&](const std::vector<double>& pressure) {
    return pressure.empty() ? 0.0 : quantile(pressure, 0.5) / actuator_.supply_pressure_Pa;
  };
  level_a_ = level(signals_.pressure_a);
  level_b_ = level(signals_.pressure_b);
  const WiringHypothesis none;
  for (std::size_t i = 0; i < kWiringLaws; ++i) {
    none_[i] = law(static_cast<WiringLaw>(i), none);
  }
}

WiringJudge::Motion WiringJudge::by_position(const WiringHypothesis& h) const {
  const ChannelChange& change = h.of(WiredChannel::kPosition);
  return {&signals_.position[0], &signals_.position[1], &signals_.position[2],
          &signals_.position[3], 1.0 / change.factor,   change.late};
}

WiringJudge::Motion WiringJudge::by_velocity(const WiringHypothesis& h, double lag_s, bool quick) const {
  const ChannelChange& change = h.of(WiredChannel::kVelocity);
  return {&signals_.travel,
          quick ? &signals_.quick_velocity[0] : &signals_.velocity[0],
          quick ? &signals_.quick_velocity[1] : &signals_.velocity[1],
          quick ? &signals_.quick_velocity[2] : &signals_.velocity[2],
          1.0 / change.factor,
          change.late,
          lag_s};
}

Unexplained WiringJudge::judge(const WiringHypothesis& h) const {
  const auto changed = [&](WiredChannel channel) { return h.of(channel) != ChannelChange{}; };
  const bool x = changed(WiredChannel::kPosition), v = changed(WiredChannel::kVelocity);
  const bool f = changed(WiredChannel::kForce), u = changed(WiredChannel::kCurrent);
  const bool p = changed(WiredChannel::kPressureA) || changed(WiredChannel::kPressureB) || h.pressures_exchanged;
  const std::array<bool, kWiringLaws> judged{x || v, x || f, x || v || f, x || f || u || p, true, x || f || p, p};
  Unexplained all = none_;
  for (std::size_t i = 0; i < kWiringLaws; ++i) {
    all[i] = judged[i] && !std::isnan(none_[i]) ? law(static_cast<WiringLaw>(i), h) : none_[i];
  }
  return all;
}

double WiringJudge::law(WiringLaw of, const WiringHypothesis& h) const {
  const bool measured_velocity = !signals_.velocity[0].empty();
  const bool current = !signals_.current[0].empty();
  switch (of) {
    case WiringLaw::kKinematics:
      return measured_velocity ? kinematics(h).unexplained : kNone;
    case WiringLaw::kLoadByPosition:
      return load_ever_known_ ? load(h, by_position(h)).unexplained : kNone;
    case WiringLaw::kLoadByVelocity:
      return measured_velocity && load_known_throughout_
                 ? load(h, by_velocity(h, kinematics(h).coefficients[1], true)).unexplained
                 : kNone;
    case WiringLaw::kOilByPosition:
      return current ? oil(h, by_position(h)) : kNone;
    case WiringLaw::kOilByVelocity:
      return current && measured_velocity ? oil(h, by_velocity(h, kinematics(h).coefficients[1], false)) : kNone;
    case WiringLaw::kCell:
      return signals_.pressure_a.empty() || signals_.pressure_b.empty() ? kNone : cell(h).unexplained;
    case WiringLaw::kLevels:
      return signals_.pressure_a.empty() || signals_.pressure_b.empty() ? kNone : levels(h);
  }
  return kNone;
}

BoxRegression::Result WiringJudge::kinematics(const WiringHypothesis& h) const {
  BoxRegression regression(2);
  const ChannelChange& v = h.of(WiredChannel::kVelocity);
  const Motion motion = by_position(h);
  const std::ptrdiff_t late = v.late;
  each([&](std::size_t i) {
    const double now = signals_.velocity[0][i + late] / v.factor;
    regression.add(now, {motion.speed(i), -signals_.velocity[1][i + late] / v.factor});
  });
  return regression.solve({{{0.8, 1.25}, {0.0, kLongestLag_s}}});
}

BoxRegression::Result WiringJudge::load(const WiringHypothesis& h, const Motion& motion) const {
  BoxRegression regression(4);
  const ChannelChange& f = h.of(WiredChannel::kForce);
  const bool quick = motion.x == &signals_.travel;
  const std::vector<double>& force = quick ? signals_.quick_force : signals_.force[0];
  const auto late = static_cast<std::size_t>(f.late);
  each([&](std::size_t i) {
    if (signals_.load_known[i] != 0) {
      regression.add(force[i + late] / f.factor, {motion.acceleration(i), motion.speed(i), motion.position(i),
                                                  -signals_.force[1][i + late] / f.factor});
    }
  });
  const double force_rms = force_rms_ / std::abs(f.factor);
  const double scale = std::abs(motion.factor);
  const double dry = speed_rms_ > 0.0 ? kDryShare * force_rms / (scale * speed_rms_) : 0.0;
  const double spring = travel_rms_ > 0.0 ? force_rms / (scale * travel_rms_) : 0.0;
  return regression.solve(
      {{{kLeastFactor * load_.mass, kMostFactor * load_.mass},
        {kLeastFactor * load_.damping, kMostFactor * load_.damping + std::min(dry, 1e9)},
        {kLeastFactor * load_.stiffness, kMostFactor * load_.stiffness + (load_.stiffness > 0.0 ? 0.0 : spring)},
        {0.0, kLongestLag_s}}});
}

BoxRegression::Result WiringJudge::cell(const WiringHypothesis& h) const {
  BoxRegression regression(4);
  const ChannelChange& f = h.of(WiredChannel::kForce);
  const ChannelChange& a = h.of(WiredChannel::kPressureA);
  const ChannelChange& b = h.of(WiredChannel::kPressureB);
  const std::vector<double>& in_a = h.pressures_exchanged ? signals_.pressure_b : signals_.pressure_a;
  const std::vector<double>& in_b = h.pressures_exchanged ? signals_.pressure_a : signals_.pressure_b;
  const Motion motion = by_position(h);
  each([&](std::size_t i) {
    const std::size_t k = i + static_cast<std::size_t>(f.late);
    const double oil = plant::hydraulic_force(actuator_, in_a[i + static_cast<std::size_t>(a.late)] / a.factor,
                                              in_b[i + static_cast<std::size_t>(b.late)] / b.factor);
    const double v = motion.speed(i);
    regression.add(signals_.force[0][k] / f.factor,
                   {oil, -actuator_.piston_damping * v - actuator_.piston_mass * motion.acceleration(i), -v,
                    -signals_.force[1][k] / f.factor});
  });
  const double dry = speed_rms_ > 0.0 ? kDryShare * force_rms_ / (std::abs(f.factor) * speed_rms_) : 0.0;
  return regression.solve({{{0.15, kMostFactor}, {0.5, 2.0}, {0.0, dry}, {0.0, kLongestLag_s}}});
}

double WiringJudge::force_lag(const WiringHypothesis& h) const {
  if (!signals_.pressure_a.empty() && !signals_.pressure_b.empty()) {
    return cell(h).coefficients[3];
  }
  return load_ever_known_ ? load(h, by_position(h)).coefficients[3] : 0.0;
}

double WiringJudge::oil(const WiringHypothesis& h, const Motion& motion) const {
  const ChannelChange& f = h.of(WiredChannel::kForce);
  const ChannelChange& u = h.of(WiredChannel::kCurrent);
  const auto volumes = plant::chamber_volumes(actuator_, 0.5 * actuator_.stroke);
  const double a = actuator_.area_a, b = actuator_.area_b, e = actuator_.bulk_modulus_Pa;
  const double held = e * (a * a / volumes.a_m3 + b * b / volumes.b_m3);
  const double driven =
      e * (a / volumes.a_m3 + b / volumes.b_m3) * actuator_.valve_gain * std::sqrt(0.5 * actuator_.supply_pressure_Pa);
  const double lag_s = force_lag(h);
  // An input's delay: the current of an earlier sample acts now.
  std::vector<int> delays{0};
  if (u.late == 0) {
    for (const double share : {0.03, 0.07, 0.1, 0.15, 0.2, 0.3, 0.4, 0.55, 0.7, 0.85, 1.0}) {
      const int delay = static_cast<int>(share * longest_delay_);
      if (delay > delays.back()) {
        delays.push_back(delay);
      }
    }
  }
  const std::vector<double>& current = signals_.current[f.factor < 0.0 ? 1 : 0];
  const double calm = 0.1 * held * std::abs(motion.factor) * standard(*motion.v);
  std::vector<BoxRegression> by_delay(delays.size(), BoxRegression(4));
  each([&](std::size_t i) {
    const std::size_t k = i + static_cast<std::size_t>(f.late);
    const double flow = held * motion.speed(i) + actuator_.piston_damping * motion.acceleration(i) +
                        actuator_.piston_mass * motion.jolt(i);
    const double rise = (signals_.force[1][k] + lag_s * signals_.force[2][k]) / f.factor;
    const BoxRegression::Values r{flow / driven, rise / driven, signals_.force[0][k] / f.factor,
                                  calm > 0.0 ? std::tanh(flow / calm) : 0.0};
    for (std::size_t j = 0; j < delays.size(); ++j) {
      by_delay[j].add(current[i + static_cast<std::size_t>(u.late) - static_cast<std::size_t>(delays[j])] / u.factor,
                      r);
    }
  });
  const double most_leakage = 0.3 * actuator_.valve_current_max_A / (actuator_.supply_pressure_Pa * std::min(a, b));
  double least = std::numeric_limits<double>::infinity();
  for (const BoxRegression& regression : by_delay) {
    least = std::min(least, regression
                                .solve({{{0.3, 3.5},
                                         {kLeastFactor, 8.0},
                                         {0.0, most_leakage},
                                         {0.0, 0.5 * current_rms_ / std::abs(u.factor)}}})
                                .unexplained);
  }
  return least;
}

double WiringJudge::levels(const WiringHypothesis& h) const {
  const double a = level_a_ / h.of(WiredChannel::kPressureA).factor;
  const double b = level_b_ / h.of(WiredChannel::kPressureB).factor;
  const bool plausible = a + b > 0.6 && a + b < 1.6;
  return plausible ? 0.0 : 1.0;
}

double WiringJudge::seen(WiredChannel channel) const noexcept {
  switch (channel) {
    case WiredChannel::kPosition:
      return speed_rms_;
    case WiredChannel::kVelocity:
      return standard(signals_.velocity[0]);
    case WiredChannel::kForce:
      return force_rms_;
    case WiredChannel::kCurrent:
      return current_rms_;
    case WiredChannel::kPressureA:
      return standard(signals_.pressure_a);
    case WiredChannel::kPressureB:
      return standard(signals_.pressure_b);
    case WiredChannel::kSupply:
      return kNone;
  }
  return kNone;
}

double WiringJudge::expected(WiredChannel channel) const {
  const double speed = std::max(speed_rms_, standard(signals_.velocity[0]));
  switch (channel) {
    case WiredChannel::kPosition:
      return standard(signals_.velocity[0]);
    case WiredChannel::kVelocity:
      return speed_rms_;
    case WiredChannel::kForce: {
      // The larger of both parts: their phase is not known.
      const double of_load =
          load_known_throughout_ ? std::max(load_.damping * speed, load_.stiffness * travel_rms_) : 0.0;
      std::vector<double> of_oil;
      for (std::size_t i = 0; i < std::min(signals_.pressure_a.size(), signals_.pressure_b.size()); ++i) {
        of_oil.push_back(plant::hydraulic_force(actuator_, signals_.pressure_a[i], signals_.pressure_b[i]));
      }
      return std::max(of_load, standard(of_oil) - actuator_.piston_damping * speed);
    }
    case WiredChannel::kCurrent:
      return 0.5 * (actuator_.area_a + actuator_.area_b) * speed /
             (actuator_.valve_gain * std::sqrt(0.5 * actuator_.supply_pressure_Pa));
    case WiredChannel::kPressureA:
    case WiredChannel::kPressureB:
      return force_rms_ / (actuator_.area_a + actuator_.area_b);
    case WiredChannel::kSupply:
      return kNone;
  }
  return kNone;
}

}  // namespace farrier::diagnosis
