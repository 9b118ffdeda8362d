#include "trials/truth/record.hpp"

#include <algorithm>
#include <cmath>

#include "trials/truth/driver.hpp"
#include "trials/truth/jitter.hpp"
#include "trials/truth/sensor_channel.hpp"

namespace farrier::truth {
namespace {

constexpr double kLead_s = 0.3;
constexpr double kStep_s = 2e-5;
constexpr double kContactStep_s = 1e-5;  ///< with bristles, play or stops in touch
constexpr double kPressureNoise_Pa = 2e3;
constexpr double kPressureStep_Pa = 500.0;

/// All sensors of a joint. A cylinder's digits are an encoder's micrometre, 0.1 mm/s and a quarter of a newton.
class SensorSet {
 public:
  SensorSet(const Plan& plan, const robot::Joint& joint)
      : SensorSet(plan, joint, joint.actuator.area_a == joint.actuator.area_b) {}

  Reading operator()(const Reading& truth, int tick) const {
    return {
        position_(truth.position, tick),        velocity_(truth.velocity, tick),        force_(truth.force, tick),
        pressure_a_(truth.pressure_a_Pa, tick), pressure_b_(truth.pressure_b_Pa, tick), supply_(truth.supply_Pa, tick)};
  }

 private:
  SensorSet(const Plan& plan, const robot::Joint& joint, bool rotary)
      : position_(plan, joint, "truth position", joint.noise.position, rotary ? joint.noise.position / 3.0 : 1e-6),
        velocity_(plan, joint, "truth velocity", joint.noise.velocity, rotary ? joint.noise.velocity / 3.0 : 1e-4),
        force_(plan, joint, "truth force", joint.noise.force, rotary ? joint.noise.force / 3.0 : 0.25),
        pressure_a_(plan, joint, "truth pressure a", kPressureNoise_Pa, kPressureStep_Pa),
        pressure_b_(plan, joint, "truth pressure b", kPressureNoise_Pa, kPressureStep_Pa),
        supply_(plan, joint, "truth supply", kPressureNoise_Pa, kPressureStep_Pa) {}

  Channel position_, velocity_, force_, pressure_a_, pressure_b_, supply_;
};

void note(Went& went, const Machine& m, const Simulator& simulator, double current_A) {
  const Vector& x = simulator.state();
  went.peak_current_A = std::max(went.peak_current_A, std::abs(current_A));
  went.peak_flow_m3_s = std::max(went.peak_flow_m3_s, simulator.supply_flow());
  went.excursion = std::max(went.excursion, std::abs(x[kX] - 0.5 * m.stroke));
  went.stretch = std::max(went.stretch, std::abs(x[kX] - m.spring_rest));
  went.peak_force = std::max(went.peak_force, std::abs(m.area_a * x[kPa] - m.area_b * x[kPb]));
  went.lowest_Pa = std::min({went.lowest_Pa, x[kPa], x[kPb]});
  went.finite = went.finite && std::all_of(x.begin(), x.end(), [](double value) { return std::isfinite(value); });
}

void append(Samples& out, const Reading& seen, double current_A) {
  out.valve_current_A.push_back(current_A);
  out.position.push_back(seen.position);
  out.velocity.push_back(seen.velocity);
  out.force.push_back(seen.force);
  out.pressure_a_Pa.push_back(seen.pressure_a_Pa);
  out.pressure_b_Pa.push_back(seen.pressure_b_Pa);
  out.supply_pressure_Pa.push_back(seen.supply_Pa);
}

}  // namespace

double rms_about_mean(const std::vector<double>& x) {
  double sum = 0.0, squares = 0.0;
  for (const double value : x) {
    sum += value - x.front();
    squares += (value - x.front()) * (value - x.front());
  }
  const double n = static_cast<double>(x.size());
  return std::sqrt(std::max(0.0, squares / n - sum / n * (sum / n)));
}

Machine machine_of(const robot::Joint& joint, std::uint64_t seed) {
  const plant::ActuatorParams& a = joint.actuator;
  const plant::LoadParams& l = joint.swing_load;
  Jitter off(seed, joint.name);
  Machine m{};
  m.area_a = off(a.area_a);
  m.area_b = off(a.area_b);
  if (a.area_a == a.area_b) m.area_b = m.area_a;  // both sides of one vane
  m.stroke = a.stroke;
  m.line_volume_m3 = off(a.line_volume_m3);
  m.bulk_modulus_Pa = off(a.bulk_modulus_Pa);
  m.valve_gain = off(a.valve_gain);
  m.current_max_A = a.valve_current_max_A;
  m.supply_Pa = off(a.supply_pressure_Pa);
  m.return_Pa = a.return_pressure_Pa;
  m.laminar_Pa = a.laminar_pressure_Pa;
  m.piston_mass = off(a.piston_mass);
  m.piston_damping = off(a.piston_damping);
  m.stop_stiffness = a.stop_stiffness;
  m.stop_damping = a.stop_damping;
  m.load_mass = off(l.mass);
  m.load_damping = off(l.damping);
  m.load_stiffness = off(l.stiffness);
  m.spring_rest = l.stiffness > 0.0 ? l.equilibrium_position : 0.5 * a.stroke;
  return m;
}

int step_count(const Machine& m, double period_s) {
  const bool rubbing = m.load_contact.coulomb > 0.0 || m.piston_contact.coulomb > 0.0;
  double step_s = rubbing || m.stop_inset > 0.0 ? kContactStep_s : kStep_s;
  if (m.play > 0.0) {
    step_s = std::min(kContactStep_s, 0.55 * m.piston_mass / contact_damping(m));  // a light piston on a flank
  }
  const double longest_s = Clock::kGrid * step_s;
  return Clock::kGrid * static_cast<int>(std::ceil(period_s / longest_s - 1e-9));
}

Run record(const robot::Joint& joint, double period_s, const Plan& plan, const Machine& machine, double scale,
           int substeps) {
  const Clock clock{period_s, static_cast<int>(std::lround(kLead_s / period_s)), substeps};
  const int ticks = static_cast<int>(std::lround(plan.duration_s / period_s));
  Simulator simulator(machine, clock, plan.seed, joint.name);
  Driver driver(joint, clock, plan, scale);
  const SensorSet sensors(plan, joint);

  Run run;
  run.samples.period_s = period_s;
  run.went.lowest_Pa = machine.supply_Pa;
  for (int k = -clock.lead_ticks; k < ticks; ++k) {
    const Reading seen = sensors(simulator.read(), k + clock.lead_ticks);
    const double current_A = driver.current(k, seen);
    if (k >= 0) {
      append(run.samples, seen, current_A);
    }
    simulator.tick(current_A);
    note(run.went, machine, simulator, current_A);
  }
  run.went.rms_force = rms_about_mean(run.samples.force);
  run.went.rms_motion = rms_about_mean(run.samples.position);
  return run;
}

}  // namespace farrier::truth
