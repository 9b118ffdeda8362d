#include "trials/body/trot_cases.hpp"

#include <cmath>
#include <numbers>

#include "config/visitor.hpp"

namespace farrier::trials {
namespace {

using locomotion::MotionCommand;
using locomotion::Request;

constexpr double kTrot_s = locomotion::kWalk_s;
constexpr double kSettle_s = 4.0;
constexpr int kSeeds = 3;
constexpr int kWalkSeeds = 10;  // of walks on flat ground
// HyQ, whose masses, impulses and heights the trials have.
constexpr double kHyq_kg = 84.756;
constexpr double kHyqTrunk_m = 0.58;
constexpr double kSlope_rad = 10.0 * std::numbers::pi / 180.0;

// Rounded, so that names are short.
double rounded(double value, double per_unit) { return std::round(value * per_unit) / per_unit; }

double mass_share(const robot::Robot& robot) { return body::total_mass_kg(*robot.body) / kHyq_kg; }
double height_share(const robot::Robot& robot) { return robot.locomotion->reference.default_height_m / kHyqTrunk_m; }
std::string scaled_height_text(const robot::Robot& robot, double of_hyq_m) {
  return config::number_text(rounded(height_share(robot) * of_hyq_m, 1e3));
}

MotionCommand trot(double forward_m_s, double left_m_s = 0.0, double yaw_rate_rad_s = 0.0) {
  return {
      .request = Request::kTrot, .forward_m_s = forward_m_s, .left_m_s = left_m_s, .yaw_rate_rad_s = yaw_rate_rad_s};
}

// Lies, stands up and trots for `walk_s`.
TrotCase walk(const std::string& trial, const std::string& name, std::uint64_t seed, const MotionCommand& command,
              double walk_s) {
  return {.trial = trial,
          .name = name,
          .seed = seed,
          .scene = "friction: 0.8\n",
          .script = locomotion::walk_script(command),
          .trot_s = kTrot_s,
          .judged_from_s = kTrot_s + kSettle_s,
          .judged_until_s = kTrot_s + walk_s,
          .end_s = kTrot_s + walk_s};
}

std::string seed_text(int seed) { return "seed " + std::to_string(seed); }

void add_seeds(const std::string& trial, const MotionCommand& command, double walk_s, std::vector<TrotCase>& cases) {
  for (int seed = 1; seed <= kWalkSeeds; ++seed) {
    cases.push_back(walk(trial, seed_text(seed), static_cast<std::uint64_t>(seed), command, walk_s));
  }
}

void add_flat(const robot::Robot& robot, std::vector<TrotCase>& cases) {
  for (int seed = 1; seed <= kWalkSeeds; ++seed) {
    for (const double share : {0.865, 1.0, 1.136}) {  // by how much HyQ's trunk is uncertain
      const double mass_kg = rounded(share * robot.body->trunk.mass_kg, 1.0);
      cases.push_back(walk("flat", seed_text(seed) + ", trunk " + config::number_text(mass_kg) + " kg",
                           static_cast<std::uint64_t>(seed), trot(0.4), 60.0));
      cases.back().trunk_mass_kg = mass_kg;
    }
  }
}

void add_modes(std::vector<TrotCase>& cases) {
  constexpr double kStop_s = 18.0, kLie_s = 24.0, kUp_s = 31.0, kAgain_s = 38.0;
  for (int seed = 1; seed <= kWalkSeeds; ++seed) {
    TrotCase one = walk("modes", seed_text(seed), static_cast<std::uint64_t>(seed), trot(0.5), 36.0);
    one.script.push_back({kStop_s, {.request = Request::kStand}});
    one.script.push_back({kLie_s, {.request = Request::kLie}});
    one.script.push_back({kUp_s, {.request = Request::kStand}});
    one.script.push_back({kAgain_s, trot(0.5)});
    one.judged_until_s = kStop_s;
    cases.push_back(one);
  }
}

void add_pushes(const robot::Robot& robot, std::vector<TrotCase>& cases) {
  for (const PushSide& side : kPushSides) {
    for (int phase = 0; phase < kPushPhases; ++phase) {
      cases.push_back(push_case(robot, "pushes", side, scaled_impulse_Ns(robot, 80.0), phase));
    }
  }
}

void add_slopes(std::vector<TrotCase>& cases) {
  struct Slope {
    const char* name;
    double roll_rad, pitch_rad;
  };
  for (const Slope& slope : {Slope{"up", 0, -kSlope_rad},
                             {"down", 0, kSlope_rad},
                             {"left side up", kSlope_rad, 0},
                             {"right side up", -kSlope_rad, 0}}) {
    for (int seed = 1; seed <= kSeeds; ++seed) {
      TrotCase one = walk("slopes", std::string(slope.name) + ", " + seed_text(seed), static_cast<std::uint64_t>(seed),
                          trot(0.3), 20.0);
      one.scene += "ground: {roll_rad: " + config::number_text(slope.roll_rad) +
                   ", pitch_rad: " + config::number_text(slope.pitch_rad) + "}\n";
      cases.push_back(one);
    }
  }
}

void add_obstacles(const robot::Robot& robot, std::vector<TrotCase>& cases) {
  constexpr int kFields = 20;
  for (int seed = 1; seed <= kFields; ++seed) {
    TrotCase one = walk("blocks", seed_text(seed), static_cast<std::uint64_t>(seed), trot(0.3), 20.0);
    one.scene += "blocks: {field: {x_m: 0.8, y_m: -1.5, length_m: 5.1, width_m: 3, size_m: 0.3, height_m: " +
                 scaled_height_text(robot, 0.08) + ", seed: " + std::to_string(seed) + "}}\n";
    cases.push_back(one);
  }
  for (int seed = 1; seed <= kFields; ++seed) {
    TrotCase one = walk("step", seed_text(seed), static_cast<std::uint64_t>(seed), trot(0.3), 14.0);
    // The edge is between 1.01 m and 1.25 m ahead, so that feet meet it at all phases.
    one.scene += "boxes: {step: {x_m: " + config::number_text(4.0 + 0.0125 * seed) +
                 ", length_m: 6, width_m: 8, height_m: " + scaled_height_text(robot, 0.1) + "}}\n";
    cases.push_back(one);
  }
}

void add_lags(std::vector<TrotCase>& cases) {
  for (const int lag : {0, 5, 10, 20}) {
    for (int seed = 1; seed <= kSeeds; ++seed) {
      cases.push_back(walk(lag > 10 ? "long_lag" : "lag", std::to_string(lag) + " ticks, " + seed_text(seed),
                           static_cast<std::uint64_t>(seed), trot(0.4), 20.0));
      cases.back().lag_ticks = lag;
    }
  }
}

void add_payloads(const robot::Robot& robot, std::vector<TrotCase>& cases) {
  constexpr double kLoad_s = kTrot_s + 6.0;
  for (int seed = 1; seed <= kSeeds; ++seed) {
    TrotCase one = walk("payload", seed_text(seed), static_cast<std::uint64_t>(seed), trot(0.4), 20.0);
    one.scene += "payloads: {load: {start_s: " + config::number_text(kLoad_s) +
                 ", mass_kg: " + config::number_text(rounded(mass_share(robot) * 20.0, 1.0)) +
                 ", z_m: " + scaled_height_text(robot, 0.15) + "}}\n";
    one.load_s = kLoad_s;
    one.judged_from_s = kLoad_s + kSettle_s;
    cases.push_back(one);
  }
}

// Flows and volumes are shares of the robot's own.
TrotCase supply_case(const robot::Robot& robot, const std::string& trial, int seed, double pump_share,
                     double accumulator_share) {
  constexpr double kFault_s = kTrot_s + 1.0;
  TrotCase one = walk(trial, seed_text(seed), static_cast<std::uint64_t>(seed), trot(0.4), 20.0);
  const std::string start = "{start_s: " + config::number_text(kFault_s);
  one.scene += "supply:\n  pump: " + start +
               ", pump_flow_m3_s: " + config::number_text(pump_share * robot.supply->pump_flow_m3_s) + "}\n";
  if (accumulator_share < 1.0) {
    one.scene += "  accumulator: " + start + ", accumulator_volume_m3: " +
                 config::number_text(accumulator_share * robot.supply->accumulator_volume_m3) + "}\n";
  }
  one.fault_s = kFault_s;
  return one;
}

// The valve of this joint stays at this share of its full current, from a phase of the stride on.
TrotCase stuck_case(const robot::Robot& robot, const std::string& trial, const robot::Joint& joint, double share,
                    int phase) {
  const double stride_s = 1.0 / robot.plan.gait.frequency_Hz;
  const double fault_s = kTrot_s + 6.0 + phase * stride_s / kPushPhases;
  const std::string sign = share > 0.0 ? "out, " : (share < 0.0 ? "in, " : "");
  TrotCase one = walk(trial, sign + "phase " + std::to_string(phase) + " of 8", 1, trot(0.4), 12.0);
  one.scene += "actuators: {dead: {joint: " + joint.name + ", start_s: " + config::number_text(fault_s) +
               ", stuck_A: " + config::number_text(share * joint.actuator.valve_current_max_A) + "}}\n";
  one.fault_s = fault_s;
  one.may_sink = true;
  return one;
}

void add_dead_joints(const robot::Robot& robot, std::vector<TrotCase>& cases) {
  const auto add = [&](const char* trial, std::size_t joint_of_leg, double share) {
    const robot::Joint& joint = robot.joints[joint_of_leg];
    for (int phase = 0; phase < kPushPhases && !joint.electric; ++phase) {
      cases.push_back(stuck_case(robot, trial, joint, share, phase));
    }
  };
  constexpr std::size_t kHaa = 0, kHfe = 1, kKnee = 2;
  add("dead_joint", kKnee, 0.0);
  add("dead_hip", kHfe, 0.0);
  add("dead_abduction", kHaa, 0.0);
  add("open_valve", kKnee, 0.5);
  add("open_valve", kKnee, -0.5);
}

void add_supply_trials(const robot::Robot& robot, std::vector<TrotCase>& cases) {
  if (!robot.supply) {
    return;
  }
  for (int seed = 1; seed <= kWalkSeeds; ++seed) {
    cases.push_back(supply_case(robot, "supply", seed, 7.0 / 12.0, 0.2));
  }
  for (int seed = 1; seed <= kWalkSeeds; ++seed) {
    cases.push_back(supply_case(robot, "low_supply", seed, 0.5, 1.0));
  }
  for (int seed = 1; seed <= kSeeds; ++seed) {
    cases.push_back(supply_case(robot, "pump_stops", seed, 0.0, 1.0));
    cases.back().may_sink = true;
  }
  add_dead_joints(robot, cases);
  for (int seed = 1; seed <= kWalkSeeds; ++seed) {
    for (const int finer : {1, 2}) {
      cases.push_back(walk("energy", seed_text(seed) + (finer > 1 ? ", half the step" : ""),
                           static_cast<std::uint64_t>(seed), trot(0.4), kSettle_s + 10.0));
      cases.back().finer = finer;
    }
  }
}

}  // namespace

const MotionCommand& TrotCase::judged_command() const noexcept {
  const locomotion::TimedCommand* last = &script.front();
  for (const locomotion::TimedCommand& timed : script) {
    if (timed.from_s <= judged_from_s) {
      last = &timed;
    }
  }
  return last->command;
}

TrotCase push_case(const robot::Robot& robot, const std::string& trial, const PushSide& side, double impulse_Ns,
                   int phase) {
  constexpr double kPush_s = kTrot_s + 6.0;
  const double stride_s = 1.0 / robot.plan.gait.frequency_Hz;
  TrotCase one =
      walk(trial, std::string("from ") + side.name + ", phase " + std::to_string(phase) + " of 8", 1, trot(0.4), 12.0);
  one.scene += "pushes: {push: {start_s: " + config::number_text(kPush_s + phase * stride_s / kPushPhases) +
               ", impulse_x_Ns: " + config::number_text(side.x * impulse_Ns) +
               ", impulse_y_Ns: " + config::number_text(side.y * impulse_Ns) + "}}\n";
  return one;
}

double scaled_impulse_Ns(const robot::Robot& robot, double of_hyq_Ns) {
  return rounded(mass_share(robot) * of_hyq_Ns, 10.0);
}

std::vector<TrotCase> trot_cases(const robot::Robot& robot) {
  std::vector<TrotCase> cases;
  add_flat(robot, cases);
  add_seeds("speed", trot(0.8), 20.0, cases);
  add_seeds("sideways", trot(0.0, 0.3), 20.0, cases);
  add_seeds("turning", trot(0.0, 0.0, 0.5), 20.0, cases);
  add_modes(cases);
  add_pushes(robot, cases);
  add_slopes(cases);
  add_obstacles(robot, cases);
  add_lags(cases);
  add_payloads(robot, cases);
  add_supply_trials(robot, cases);
  return cases;
}

std::vector<TrotCase> first_of_each_trial(const std::vector<TrotCase>& cases) {
  std::vector<TrotCase> first;
  for (const TrotCase& one : cases) {
    if (first.empty() || first.back().trial != one.trial) {
      first.push_back(one);
    }
  }
  return first;
}

}  // namespace farrier::trials
