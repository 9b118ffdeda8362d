#include "trials/body/body_contenders.hpp"

#include <algorithm>

#include "plant/terms/active_effect.hpp"

namespace farrier::trials {
namespace {

using control::Kind;

constexpr double kBlocked = 100.0;  ///< factor on the mass in stance, of a piston that hardly moves

void remove_effect(robot::Robot& robot, plant::EffectId id) {
  for (robot::Joint& joint : robot.joints) {
    std::erase_if(joint.effects, [id](const plant::ActiveEffect& effect) { return effect.id == id; });
  }
}

void remove_valve_dynamics(robot::Robot& robot) { remove_effect(robot, plant::effect_id<plant::ValveDynamics>()); }
void remove_overlap(robot::Robot& robot) { remove_effect(robot, plant::effect_id<plant::ValveDeadband>()); }
void remove_friction(robot::Robot& robot) { remove_effect(robot, plant::effect_id<plant::PistonFriction>()); }
void remove_noise(robot::Robot& robot) {
  for (robot::Joint& joint : robot.joints) {
    joint.noise = {};
    joint.sensors.position_step = 0.0;
  }
}
void remove_delay(robot::Robot& robot) { robot.loop_delay_lockstep = 0; }
void hold_supply(robot::Robot& robot) { robot.supply.reset(); }
void compensate_fully(robot::Robot& robot) {
  for (robot::Joint& joint : robot.joints) {
    joint.feedback_linearisation.velocity_compensation = 1.0;
    joint.feedback_linearisation.velocity_lead_s = 0.0;
  }
}

/// The robot with a controller of another kind, and the gains of the bench.
BodyContender with_controller(const robot::Robot& on_ground, const robot::Robot& on_bench, const char* name,
                              const char* description, Kind kind, control::Form form = control::Form::kCompliant) {
  BodyContender contender{name, description, on_ground};
  for (std::size_t i = 0; i < contender.robot.joints.size(); ++i) {
    robot::Joint& joint = contender.robot.joints[i];
    const robot::Joint& bench = on_bench.joints[i];
    joint.kind = kind;
    joint.form = form;
    joint.feedback_linearisation = bench.feedback_linearisation;
    joint.pid = bench.pid;
    joint.flow_inversion = bench.flow_inversion;
    joint.design = bench.design;
  }
  return contender;
}

}  // namespace

robot::Robot with_ideal_valves(robot::Robot robot) {
  remove_valve_dynamics(robot);
  remove_overlap(robot);
  return robot;
}

std::vector<BodyContender> force_controllers(const robot::Robot& on_ground, const robot::Robot& on_bench) {
  std::vector<BodyContender> all{{kFileDesign, "as in the robot file", on_ground}};
  const auto add = [&](const char* name, const char* description, Kind kind,
                       control::Form form = control::Form::kCompliant) -> std::vector<robot::Joint>& {
    return all.emplace_back(with_controller(on_ground, on_bench, name, description, kind, form)).robot.joints;
  };
  add("feedback_linearisation", "gains of the bench", Kind::kFeedbackLinearisation);
  add("lqr", "compliant, loads of the mass matrix", Kind::kLqr);
  add("lqr_full", "full state, the same loads", Kind::kLqr, control::Form::kFullState);
  for (robot::Joint& joint : add("lqr_bench", "compliant, loads of the bench", Kind::kLqr)) {
    joint.swing_load = on_bench.joints[joint.number].swing_load;
    joint.stance_load = on_bench.joints[joint.number].stance_load;
  }
  for (robot::Joint& joint : add("lqr_blocked", "compliant, a blocked piston", Kind::kLqr)) {
    joint.swing_load.mass = joint.stance_load.mass = kBlocked * joint.stance_load.mass;
  }
  add("flow_inversion", "loads of the mass matrix", Kind::kFlowInversion);
  add("pid", "gains of the bench", Kind::kPid);
  return all;
}

std::vector<BodyContender> limits_of_force(const robot::Robot& on_ground) {
  using Removal = void (*)(robot::Robot&);
  std::vector<BodyContender> all;
  const auto without = [&all](const robot::Robot& robot, const char* name, const char* description,
                              std::initializer_list<Removal> removals) {
    all.push_back({name, description, robot});
    for (const Removal removal : removals) {
      removal(all.back().robot);
    }
  };
  robot::Robot perfect = on_ground;
  for (const Removal removal : {hold_supply, remove_friction, remove_overlap}) {
    removal(perfect);
  }
  without(perfect, kPerfectKnowledge, "constant supply, no friction, no overlap: its law is exact", {});
  without(perfect, "perfect_no_noise", "the same, sensors without noise", {remove_noise});
  without(perfect, "perfect_no_delay", "and without the tick of delay", {remove_noise, remove_delay});
  without(perfect, "perfect_no_valve_lag", "and with a spool that follows at once",
          {remove_noise, remove_delay, remove_valve_dynamics});
  without(perfect, "perfect_compensation", "and with all of the velocity compensated",
          {remove_noise, remove_delay, remove_valve_dynamics, compensate_fully});
  without(on_ground, "no_noise", "the file's robot, sensors without noise", {remove_noise});
  without(on_ground, "no_delay", "the file's robot without the tick of delay", {remove_delay});
  without(on_ground, "no_valve_lag", "the file's robot, a spool that follows at once", {remove_valve_dynamics});
  without(on_ground, "constant_supply", "the file's robot, a supply that holds its pressure", {hold_supply});
  without(on_ground, "no_friction", "the file's robot, seals without friction", {remove_friction});
  without(on_ground, "no_overlap", "the file's robot, a valve without overlap and leakage", {remove_overlap});
  return all;
}

std::vector<ContenderResult> compare_on_body(std::span<const BodyContender> contenders, int seeds,
                                             const std::function<bool()>& done) {
  std::vector<ContenderResult> results;
  for (const BodyContender& contender : contenders) {
    auto runs = compare_runs(contender.robot, seeds, false, done);
    if (!runs) {
      break;
    }
    results.push_back({contender.name, contender.description, std::move(*runs)});
  }
  return results;
}

}  // namespace farrier::trials
