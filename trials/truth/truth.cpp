#include "trials/truth/truth.hpp"

#include <algorithm>
#include <cmath>
#include <set>

#include "trials/truth/driver.hpp"
#include "trials/truth/electric_truth.hpp"
#include "trials/truth/record.hpp"

namespace farrier::truth {
namespace {

constexpr double kScoutStep_s = 4e-5;     ///< of runs that only find the scale
constexpr double kStrokeUsed = 0.22;      ///< of the stroke to either side, without effect
constexpr double kStrokeAllowed = 0.4;    ///< with it
constexpr double kPushUsed = 0.55;        ///< of the smaller of full push and full pull
constexpr double kCurrentUsed = 0.6;      ///< of the largest
constexpr double kLowestPressure = 0.03;  ///< of the supply, in either chamber: no void

/// Excitation's scale with the run it gives, without effect.
struct Base {
  double scale;
  Went went;
};

// Largest share of its limits that a run used; above 1 it used too much.
double load_of(const Went& went, const Machine& m) {
  const double used =
      std::max({went.excursion / (kStrokeUsed * m.stroke), went.peak_current_A / (kCurrentUsed * m.current_max_A),
                went.peak_force / (kPushUsed * m.supply_Pa * std::min(m.area_a, m.area_b))});
  return went.lowest_Pa < kLowestPressure * m.supply_Pa ? std::max(used, 1.15) : used;
}

// The largest scale found in a few runs that uses no more than allowed.
Base find_scale(const robot::Joint& joint, double period_s, const Plan& plan, const Machine& machine) {
  constexpr int kRuns = 5, kMostRuns = 40;
  const int substeps = static_cast<int>(std::ceil(period_s / kScoutStep_s - 1e-9));
  Base best{0.0, {}};
  double scale = 1.0, refused = INFINITY;
  for (int i = 0; i < kMostRuns && (i < kRuns || best.scale == 0.0); ++i) {
    const Run run = record(joint, period_s, plan, machine, scale, substeps);
    const double used = run.went.finite ? load_of(run.went, machine) : 2.0;
    if (used <= 1.0) {
      best = {scale, run.went};
      if (used > 0.85 || scale > 0.93 * refused) break;
      scale = std::min(scale * std::min(1.6, 0.95 / used), std::sqrt(scale * std::min(refused, 4.0 * scale)));
    } else {
      refused = std::min(refused, scale);
      scale = best.scale > 0.0 ? std::sqrt(best.scale * scale) : scale * std::clamp(0.93 / used, 0.5, 0.93);
    }
  }
  return best;
}

Extents extents_of(const robot::Joint& joint, double period_s, const Plan& plan, const Went& went) {
  return {mechanics_of(joint).push,
          joint.actuator.stroke / 0.08,
          period_s,
          plan.duration_s,
          went.peak_current_A,
          went.peak_flow_m3_s,
          went.excursion,
          went.stretch,
          went.rms_force,
          went.rms_motion};
}

Result<Done> check(const robot::Joint& joint, double period_s, const Plan& plan) {
  if (!(period_s >= 2e-4 && period_s <= 5e-3)) {
    return Error{"truth: period_s must lie in [2e-4, 5e-3]"};
  }
  if (!(plan.duration_s >= 1.0 && plan.duration_s <= 600.0)) {
    return Error{"truth: duration_s must lie in [1, 600]"};
  }
  if (joint.electric) {
    return Done{};
  }
  const plant::ActuatorParams& a = joint.actuator;
  const plant::LoadParams& l = joint.swing_load;
  if (a.spool.on || a.valve_deadband_A > 0.0 || a.line.length_m > 0.0 || l.friction.coulomb > 0.0) {
    return Error{"truth: joint " + joint.name +
                 " has effects in its file; take a robot without spool, "
                 "deadband, friction and lines, such as fc1d or hyq"};
  }
  if (!(a.piston_mass > 0.0 && l.mass > 0.0)) {
    return Error{"truth: joint " + joint.name + " needs a piston mass and a load mass above 0"};
  }
  std::set<std::string> seen;
  for (const Hidden& hidden : plan.hidden) {
    if (find_entry(hidden.name) == nullptr) {
      return Error{"truth: no effect is called '" + hidden.name + "'; known_effects() and outside_effects() list them"};
    }
    if (hidden.magnitude < 0 || hidden.magnitude > 2) {
      return Error{"truth: magnitude of " + hidden.name + " must be 0, 1 or 2"};
    }
    if (!seen.insert(hidden.name).second) {
      return Error{"truth: " + hidden.name + " is hidden twice; name it once"};
    }
  }
  return Done{};
}

}  // namespace

Result<Trial> generate(const robot::Joint& joint, double period_s, const Plan& plan) {
  FARRIER_TRY(check(joint, period_s, plan));
  if (joint.electric) {
    return generate_electric(joint, period_s, plan);
  }
  Machine machine = machine_of(joint, plan.seed);
  const Base base = find_scale(joint, period_s, plan, machine);
  if (base.scale == 0.0) {
    return Error{"truth: no excitation keeps joint " + joint.name + " inside its stroke and above cavitation"};
  }

  Trial trial;
  const Extents extents = extents_of(joint, period_s, plan, base.went);
  for (const Hidden& hidden : plan.hidden) {
    const Entry& entry = *find_entry(hidden.name);
    const Chance chance(plan.seed, joint.name, hidden.name);
    trial.answers.push_back({hidden.name, entry.hide(machine, entry.sizes[hidden.magnitude], extents, chance)});
  }

  // An effect that drives the joint out of its range gets less excitation; its twin without effect keeps more.
  double scale = base.scale;
  for (int tries = 0; tries < 8; ++tries, scale *= 0.8) {
    Run run = record(joint, period_s, plan, machine, scale, step_count(machine, period_s));
    if (run.went.finite && run.went.excursion <= kStrokeAllowed * machine.stroke) {
      trial.samples = std::move(run.samples);
      return trial;
    }
  }
  return Error{"truth: with its effects joint " + joint.name + " leaves the stroke; hide fewer or smaller ones"};
}

std::vector<std::string> known_effects() { return names_of(false); }
std::vector<std::string> outside_effects() { return names_of(true); }

std::string headline(const std::string& effect) {
  const Entry* entry = find_entry(effect);
  return entry == nullptr ? "" : entry->headline;
}

}  // namespace farrier::truth
