#include "diagnosis/wiring/wiring_relations.hpp"

#include <algorithm>
#include <cmath>

#include "diagnosis/data/sample_statistics.hpp"
#include "diagnosis/wiring/wiring_motion.hpp"
#include "plant/oil.hpp"

namespace farrier::diagnosis {
namespace {

constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
constexpr double kLongestDelay_s = 0.03;  // of an input
constexpr std::size_t kPoints = 1500;     // that a law is judged by

}  // namespace

WiringJudge::WiringJudge(const Recording& recording, const robot::Joint& joint)
    : signals_(recording, joint),
      actuator_(joint.actuator),
      load_(joint.swing_load),
      electric_(joint.electric),
      period_s_(recording.period_s),
      most_late_(std::min(kMostLate, static_cast<int>(recording.position.size() / 20))),
      longest_delay_(static_cast<int>(kLongestDelay_s / recording.period_s)) {
  if (electric_ && electric_->rigid) {
    rotor_ = {plant::armature_kg_m2(*electric_), electric_->damping, electric_->coulomb};
  }
  margin_ = signals_.width + static_cast<std::size_t>(std::max(most_late_, longest_delay_)) + 2;
  const std::size_t inner = signals_.size() > 2 * margin_ ? signals_.size() - 2 * margin_ : 0;
  stride_ = inner / kPoints + 1;
  std::size_t known = 0, all = 0;
  each(stride_, [&](std::size_t i) {
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

double WiringJudge::velocity_lag_s(const WiringHypothesis& h) const {
  return kinematics(h, kLongestLag_s).coefficients[1];
}

WiringJudge::Motion WiringJudge::motion_of(WiringLaw law, const WiringHypothesis& h) const {
  return law == WiringLaw::kLoadByVelocity       ? by_velocity(h, 0.0, true)
         : law == WiringLaw::kActuatorByVelocity ? by_velocity(h, velocity_lag_s(h), false)
                                                 : by_position(h);
}

LawFit WiringJudge::fit(WiringLaw of, const WiringHypothesis& h) const {
  switch (of) {
    case WiringLaw::kKinematics:
      return {kinematics(h, kLongestLag_s)};
    case WiringLaw::kLoadByPosition:
      return {load(h, motion_of(of, h), kLongestLag_s)};
    case WiringLaw::kLoadByVelocity:
      return {load(h, motion_of(of, h), kLongestLag_s, velocity_lag_s(h))};
    case WiringLaw::kActuatorByPosition:
    case WiringLaw::kActuatorByVelocity:
      return actuator_law(h, motion_of(of, h));
    case WiringLaw::kCell:
      return {cell(h, kLongestLag_s)};
    case WiringLaw::kLevels:
      break;
  }
  return {};
}

double WiringJudge::law(WiringLaw of, const WiringHypothesis& h) const {
  const bool velocity = !signals_.velocity[0].empty();
  const bool current = !signals_.current[0].empty();
  const bool pressures = !signals_.pressure_a.empty() && !signals_.pressure_b.empty();
  const std::array<bool, kWiringLaws> recorded{velocity, load_ever_known_,    velocity && load_known_throughout_,
                                               current,  current && velocity, pressures,
                                               pressures};
  return !recorded[static_cast<std::size_t>(of)] ? kNone
         : of == WiringLaw::kLevels              ? levels(h)
                                                 : fit(of, h).regression.unexplained;
}

double WiringJudge::misfit_of_lag(WiredChannel channel, const WiringHypothesis& h) const {
  using enum WiredChannel;
  const bool pressures = !signals_.pressure_a.empty() && !signals_.pressure_b.empty();
  std::vector<double> unexplained;
  if (!signals_.velocity[0].empty() && (channel == kPosition || channel == kVelocity)) {
    unexplained.push_back(kinematics(h, 0.0).unexplained);
  }
  if (load_ever_known_ && (channel == kPosition || channel == kForce)) {
    unexplained.push_back(load(h, by_position(h), 0.0).unexplained);
  }
  if (pressures && (channel == kForce || channel == kPressureA)) {
    unexplained.push_back(cell(h, 0.0).unexplained);
  }
  if (unexplained.empty() && !signals_.current[0].empty()) {
    unexplained.push_back(actuator_law(h, by_position(h)).regression.unexplained);
  }
  double sum = 0.0;
  for (const double one : unexplained) {
    sum += std::log(std::max(one, 1e-9));
  }
  return sum;
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
      // The largest of the parts: their phase is not known.
      double of_load = load_known_throughout_ ? std::max(load_.damping * speed, load_.stiffness * travel_rms_) : 0.0;
      if (load_known_throughout_ && !signals_.velocity[0].empty()) {
        // Noise moves each of them alone.
        const double acceleration = std::min(standard(signals_.position[2]), standard(signals_.velocity[1]));
        of_load = std::max(of_load, load_.mass * acceleration);
      }
      std::vector<double> of_oil;
      for (std::size_t i = 0; i < std::min(signals_.pressure_a.size(), signals_.pressure_b.size()); ++i) {
        of_oil.push_back(plant::hydraulic_force(actuator_, signals_.pressure_a[i], signals_.pressure_b[i]));
      }
      return std::max(of_load, standard(of_oil) - actuator_.piston_damping * speed);
    }
    case WiredChannel::kCurrent:
      if (electric_) {
        // A motor without a current loop needs a voltage for its speed.
        const double of_speed = electric_->rigid ? 0.0 : plant::rotor_damping(*electric_) * speed;
        return std::max(force_rms_, of_speed) / (electric_->gear_ratio * electric_->torque_constant_Nm_A);
      }
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
