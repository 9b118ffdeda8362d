#include "trials/truth/electric_truth.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <set>

#include "trials/truth/electric_driver.hpp"
#include "trials/truth/electric_hide.hpp"
#include "trials/truth/jitter.hpp"
#include "trials/truth/sensor_channel.hpp"

namespace farrier::truth {
namespace electric {
namespace {

constexpr double kLead_s = 0.3;
constexpr double kTravelUsed = 0.22;    ///< to either side, without effect
constexpr double kTravelAllowed = 0.4;  ///< with it
constexpr double kTorqueUsed = 0.8;     ///< of the rating
constexpr double kCurrentUsed = 0.6;    ///< of the largest
constexpr double kSpeedUsed = 0.5;      ///< of that at no load
constexpr int kGrid = 50;               ///< steps of a tick: a delay is a whole number of them
constexpr int kScoutGrid = 25;

/// Every number of the file but the ends of the travel is off by 1 to 2 %.
ElectricMachine machine_of(const robot::Joint& joint, std::uint64_t seed) {
  const plant::ElectricParams& a = *joint.electric;
  const plant::LoadParams& l = joint.swing_load;
  Jitter off(seed, joint.name);
  ElectricMachine m{};
  m.rigid = a.rigid;
  m.gear_ratio = a.gear_ratio;
  m.motor_constant_Nm_A = off(a.torque_constant_Nm_A);
  m.resistance_Ohm = off(a.winding_resistance_Ohm);
  m.inductance_H = off(a.winding_inductance_H);
  m.rotor = off(a.rotor_inertia_kg_m2 * a.gear_ratio * a.gear_ratio);
  m.damping = off(a.damping);
  m.coulomb = off(a.coulomb);
  m.spring = off(a.spring_stiffness);
  m.spring_damping = off(a.spring_damping);
  m.current_time_s = off(a.torque_time_constant_s);
  m.load = off(l.mass);
  m.load_damping = off(l.damping);
  m.load_spring = off(l.stiffness);
  m.slip_speed = a.slip_velocity;
  m.voltage_V = a.supply_voltage_V;
  m.current_max_A = joint.actuator.valve_current_max_A;
  m.travel = a.travel;
  m.spring_rest = l.stiffness > 0.0 ? l.equilibrium_position : 0.5 * a.travel;
  m.assumed_constant_Nm_A = a.gear_ratio * a.torque_constant_Nm_A;
  return m;
}

struct Run {
  Samples samples;
  double excursion = 0.0, peak_A = 0.0, peak_torque = 0.0, peak_speed = 0.0;
  bool finite = true;
};

/// A machine from mid-travel, a period at a time, behind the delay of its input.
class Simulation {
 public:
  Simulation(const robot::Joint& joint, const ElectricMachine& machine, double period_s, int substeps, const Plan& plan)
      : machine_(machine),
        period_s_(period_s),
        substeps_(substeps),
        torque_noise_(plan.seed, joint.name, "truth random force"),
        dropout_noise_(plan.seed, joint.name, "truth dropout") {
    state_[kX] = state_[kBranchX] = 0.5 * machine.travel;
    Vector ignored;
    sensed_ = differentiate(machine_, -kLead_s, state_, acting_, ignored);
  }

  const Vector& state() const { return state_; }
  double velocity() const { return machine_.velocity_lag_s > 0.0 ? state_[kVelocityLag] : state_[kV]; }
  double torque() const {
    const double read = machine_.sensor_lag_s > 0.0 ? state_[kSensorLag] : machine_.sensor_gain * sensed_;
    return read + machine_.sensor_offset;
  }

  void tick(double command_A, double start_s) {
    draw_torque();
    commands_.push_back(taken(command_A));
    const long now = static_cast<long>(commands_.size()) - 1;
    const long late = std::lround(machine_.delay_s * substeps_ / period_s_);
    const double h = period_s_ / substeps_;
    for (int j = 0; j < substeps_; ++j) {
      const long asked = now * substeps_ + j - late;
      acting_.command_A = asked < 0 ? 0.0 : commands_[static_cast<std::size_t>(asked / substeps_)];
      advance(machine_, start_s + j * h, h, acting_, state_);
    }
    Vector ignored;
    sensed_ = differentiate(machine_, start_s + period_s_, state_, acting_, ignored);
  }

 private:
  double taken(double command_A) const {
    const auto tick = static_cast<Tick>(commands_.size());
    const Tick block = std::max<Tick>(1, std::llround(0.015 / period_s_));
    const bool lost = machine_.dropout > 0.0 && dropout_noise_.uniform(tick / block) < machine_.dropout;
    return lost && !commands_.empty() ? commands_.back() : command_A;
  }
  // Ornstein and Uhlenbeck, exact from tick to tick.
  void draw_torque() {
    if (machine_.random_Nm > 0.0) {
      const double kept = std::exp(-period_s_ / machine_.random_time_s);
      acting_.random_Nm = kept * acting_.random_Nm + std::sqrt(1.0 - kept * kept) * machine_.random_Nm *
                                                         torque_noise_.normal(static_cast<Tick>(commands_.size()));
    }
  }

  ElectricMachine machine_;
  double period_s_;
  int substeps_;
  NoiseStream torque_noise_, dropout_noise_;
  std::vector<double> commands_;
  Vector state_{};
  Acting acting_{};
  double sensed_ = 0.0;
};

Run record(const robot::Joint& joint, double period_s, const Plan& plan, const ElectricMachine& machine, int substeps,
           const Command& command) {
  const int lead = static_cast<int>(std::lround(kLead_s / period_s));
  const int ticks = static_cast<int>(std::lround(plan.duration_s / period_s));
  Simulation simulation(joint, machine, period_s, substeps, plan);
  const auto sensor = [&](const char* name, double noise) { return Channel(plan, joint, name, noise, noise / 3.0); };
  const Channel position = sensor("truth position", joint.noise.position);
  const Channel velocity = sensor("truth velocity", joint.noise.velocity);
  const Channel torque = sensor("truth force", joint.noise.force);
  Run run;
  run.samples.period_s = period_s;
  for (int k = -lead; k < ticks; ++k) {
    const double x = position(simulation.state()[kX], k + lead);
    const double v = velocity(simulation.velocity(), k + lead);
    const double t = torque(simulation.torque(), k + lead);
    const double command_A = command(k * period_s, x, v);
    if (k >= 0) {
      run.samples.valve_current_A.push_back(command_A);
      run.samples.position.push_back(x);
      run.samples.velocity.push_back(v);
      run.samples.force.push_back(t);
    }
    simulation.tick(command_A, k * period_s);
    run.excursion = std::max(run.excursion, std::abs(simulation.state()[kX] - 0.5 * machine.travel));
    run.peak_A = std::max(run.peak_A, std::abs(command_A));
    run.peak_torque = std::max(run.peak_torque, std::abs(t));
    run.peak_speed = std::max(run.peak_speed, std::abs(simulation.state()[kV]));
    run.finite = run.finite && std::isfinite(simulation.state()[kX]);
  }
  return run;
}

/// The plan's excitation.
Command excitation(const robot::Joint& joint, double period_s, const Plan& plan, double scale) {
  return [driver = Driver(joint, period_s, plan, scale), period_s](double time_s, double position, double velocity) {
    return driver.command_A(static_cast<int>(std::lround(time_s / period_s)), position, velocity);
  };
}

/// Excitation's scale with the run that it gives, without effect: the largest of a few that uses no more than allowed.
struct Base {
  double scale = 0.0;
  Run run;
};
Base find_scale(const robot::Joint& joint, double period_s, const Plan& plan, const ElectricMachine& machine) {
  const plant::ElectricParams& a = *joint.electric;
  const double no_load = a.supply_voltage_V / (a.gear_ratio * a.torque_constant_Nm_A);
  Base best;
  double scale = 1.0;
  for (int tries = 0; tries < 12 && (tries < 5 || best.scale == 0.0); ++tries) {
    Run run = record(joint, period_s, plan, machine, kScoutGrid, excitation(joint, period_s, plan, scale));
    const double used =
        std::max({run.excursion / (kTravelUsed * a.travel), run.peak_A / (kCurrentUsed * machine.current_max_A),
                  run.peak_torque / (kTorqueUsed * joint.push_limit), run.peak_speed / (kSpeedUsed * no_load)});
    const bool finite = run.finite;
    if (finite && used <= 1.0 && scale > best.scale) {
      best = {scale, std::move(run)};
      if (used > 0.9) {
        break;
      }
    }
    scale *= finite ? std::clamp(0.95 / used, 0.4, 2.0) : 0.4;
  }
  return best;
}

Result<Done> check(const robot::Joint& joint, const Plan& plan) {
  std::set<std::string> seen;
  for (const Hidden& hidden : plan.hidden) {
    const Entry* const entry = find_entry(hidden.name);
    if (entry == nullptr || !(joint.electric->rigid ? entry->of_rigid : entry->of_spring)) {
      return Error{"truth: an electric joint such as " + joint.name + " has no effect '" + hidden.name + "'"};
    }
    if (hidden.magnitude < 0 || hidden.magnitude > 2 || !seen.insert(hidden.name).second) {
      return Error{"truth: " + hidden.name + " must be hidden once, with magnitude 0, 1 or 2"};
    }
  }
  return Done{};
}

}  // namespace
}  // namespace electric

Result<Trial> generate_electric(const robot::Joint& joint, double period_s, const Plan& plan, const Command& command) {
  using namespace electric;
  FARRIER_TRY(electric::check(joint, plan));
  ElectricMachine machine = electric::machine_of(joint, plan.seed);
  const electric::Base base = electric::find_scale(joint, period_s, plan, machine);
  if (base.scale == 0.0) {
    return Error{"truth: no excitation keeps joint " + joint.name + " within its limits"};
  }
  const electric::Extents extents{joint.push_limit,
                                  period_s,
                                  plan.duration_s,
                                  base.run.peak_A,
                                  base.run.excursion,
                                  rms_about_mean(base.run.samples.force),
                                  rms_about_mean(base.run.samples.position)};
  Trial trial;
  for (const Hidden& hidden : plan.hidden) {
    const electric::Entry& entry = *electric::find_entry(hidden.name);
    const Chance chance(plan.seed, joint.name, hidden.name);
    trial.answers.push_back({hidden.name, entry.hide(machine, entry.sizes[hidden.magnitude], extents, chance)});
  }
  double scale = base.scale;
  for (int tries = 0; tries < (command ? 1 : 8); ++tries, scale *= 0.8) {
    electric::Run run = electric::record(joint, period_s, plan, machine, kGrid,
                                         command ? command : excitation(joint, period_s, plan, scale));
    if (run.finite && run.excursion <= kTravelAllowed * machine.travel) {
      trial.samples = std::move(run.samples);
      return trial;
    }
  }
  return Error{"truth: with its effects joint " + joint.name + " leaves the travel; hide fewer or smaller ones"};
}

std::vector<std::string> known_electric_effects(const robot::Joint& joint) {
  return electric::names_of(false, joint.electric->rigid);
}
std::vector<std::string> outside_electric_effects() { return electric::names_of(true, true); }

}  // namespace farrier::truth
