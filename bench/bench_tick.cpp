#include "bench/bench_tick.hpp"

#include <algorithm>
#include <chrono>
#include <limits>

#include "estimator_service/estimator_service.hpp"
#include "gait/reference.hpp"
#include "gait/schedule.hpp"
#include "joint_node/joint_node.hpp"
#include "sim_bridge/sim_world.hpp"
#include "supervisor/supervisor.hpp"
#include "wire_gains/wire_gains.hpp"

namespace farrier::bench {
namespace {

constexpr std::uint64_t kTickSeed = 1;
constexpr std::uint64_t kTickSession = 1;
constexpr double kNever = std::numeric_limits<double>::infinity();

/// Every core that has a part in a tick.
struct Cores {
  std::vector<joint_node::JointNode> nodes;
  estimator_service::EstimatorService service;
  supervisor::Supervisor supervisor;
};

struct TickInputs {
  Tick tick;
  std::vector<signals::GaitPhase> phases;  // announced in this tick
  std::vector<joint_node::JointNode::Inputs> joints;
  std::vector<signals::JointMeasurement> measurements;  // what the nodes make of them
  std::vector<signals::JointModelEstimate> estimates;   // and the estimators of that
};

struct Recording {
  std::vector<int> legs;  // by joint
  Cores before;           // as they were when it began
  std::vector<TickInputs> ticks;
};

// An estimate in every tick, and none far enough from the design to pay.
robot::Robot without_redesign(robot::Robot robot) {
  robot.estimate_period_ticks = 1;
  robot.update_logic.pole_distance_min = kNever;
  robot.update_logic.gain_ratio_min = kNever;
  return robot;
}

Result<Cores> make_cores(const robot::Robot& robot) {
  auto service = FARRIER_TRY(estimator_service::EstimatorService::create(robot, robot.loop_delay_lockstep));
  auto supervisor =
      supervisor::Supervisor::create(robot, supervisor::Design::kAdaptive, robot.loop_delay_lockstep, kTickSession);
  if (!supervisor) {
    return supervisor.error();
  }
  Cores cores{{}, std::move(service), std::move(supervisor).value()};
  for (const robot::Joint& joint : robot.joints) {
    cores.nodes.emplace_back(joint, robot.safety, robot.period_s, robot.loop_delay_lockstep, kTickSession);
  }
  const supervisor::Supervisor::Outputs& first = cores.supervisor.step(0);
  for (const signals::JointControllerGains& gains : first.gains) {
    cores.nodes[gains.joint].store_gains(gains, wire_gains::unpack_gains(gains));
  }
  for (joint_node::JointNode& node : cores.nodes) {
    node.set_mode(first.modes.at(0));
  }
  return cores;
}

void announce(std::vector<joint_node::JointNode>& nodes, const std::vector<int>& legs,
              const std::vector<signals::GaitPhase>& phases) noexcept {
  for (const signals::GaitPhase& phase : phases) {
    for (std::size_t i = 0; i < nodes.size(); ++i) {
      if (legs[i] == phase.leg) {
        nodes[i].announce_phase(phase);
      }
    }
  }
}

/// One tick of everything. Returns how many decisions came of it.
std::size_t whole_tick(Cores& cores, const std::vector<int>& legs, const TickInputs& inputs) noexcept {
  announce(cores.nodes, legs, inputs.phases);
  for (std::size_t i = 0; i < cores.nodes.size(); ++i) {
    cores.service.take(cores.nodes[i].step(inputs.joints[i]).measurement);
    cores.supervisor.take(cores.service.estimate(static_cast<std::uint16_t>(i), inputs.tick), inputs.tick);
  }
  return cores.supervisor.step(inputs.tick).decisions.size();
}

/// Steps the cores and the world by one tick; returns the cores' inputs.
TickInputs record_tick(const robot::Robot& robot, const gait::Schedule& schedule, const gait::Reference& reference,
                       const std::vector<int>& legs, sim_bridge::SimWorld& world, Cores& cores) {
  TickInputs inputs{world.tick(), {}, {}, {}, {}};
  for (std::size_t leg = 0; leg < robot.plan.legs.size(); ++leg) {
    if (const auto planned = schedule.announcement(static_cast<int>(leg), inputs.tick)) {
      inputs.phases.push_back(
          {static_cast<std::uint16_t>(leg), planned->count, inputs.tick, planned->tick, planned->phase});
    }
  }
  announce(cores.nodes, legs, inputs.phases);
  std::vector<double> valve_current_A;
  for (const robot::Joint& joint : robot.joints) {
    const gait::JointReference wanted = reference.at(joint.leg, joint.index_in_leg, inputs.tick);
    joint_node::JointNode::Inputs of_joint;
    of_joint.tick = inputs.tick;
    of_joint.sensors = world.sample(joint.number);
    of_joint.command.joint = joint.number;
    of_joint.command.tick = inputs.tick;
    of_joint.command.position_rad = wanted.position_rad;
    of_joint.command.velocity_rad_s = wanted.velocity_rad_s;
    of_joint.command.torque_ff_Nm = wanted.torque_ff_Nm;
    of_joint.command.stiffness_Nm_rad = joint.stiffness_Nm_rad;
    of_joint.command.damping_Nms_rad = joint.damping_Nms_rad;
    inputs.joints.push_back(of_joint);
    const joint_node::JointNode::Outputs outputs = cores.nodes[joint.number].step(of_joint);
    valve_current_A.push_back(outputs.valve.valve_current_A);
    inputs.measurements.push_back(outputs.measurement);
    cores.service.take(outputs.measurement);
    inputs.estimates.push_back(cores.service.estimate(joint.number, inputs.tick));
    cores.supervisor.take(inputs.estimates.back(), inputs.tick);
  }
  cores.supervisor.step(inputs.tick);
  world.advance(valve_current_A);
  return inputs;
}

Result<Recording> record(const robot::Robot& robot) {
  auto world = FARRIER_TRY(sim_bridge::SimWorld::create(robot, kTickSeed));
  auto cores = FARRIER_TRY(make_cores(robot));
  std::vector<int> legs;
  for (const robot::Joint& joint : robot.joints) {
    legs.push_back(joint.leg);
  }
  const gait::Schedule schedule(robot.plan, kTickSeed);
  const gait::Reference reference(robot.plan);
  const Tick begin = schedule.lead_in_ticks() + 2 * schedule.stride_ticks();
  while (world.tick() < begin) {
    record_tick(robot, schedule, reference, legs, world, cores);
  }
  Recording recording{legs, cores, {}};
  while (world.tick() < begin + schedule.stride_ticks()) {
    recording.ticks.push_back(record_tick(robot, schedule, reference, legs, world, cores));
  }
  return recording;
}

/// Runs `tick(cores, inputs)` over the recording and keeps the least mean time of a tick.
template <class Work>
void time_round(const Recording& recording, double& best_s, std::int64_t (*allocations_so_far)(),
                std::int64_t& allocations, const Work& tick) {
  using Clock = std::chrono::steady_clock;
  Cores cores = recording.before;
  const std::int64_t before = allocations_so_far != nullptr ? allocations_so_far() : 0;
  const auto start = Clock::now();
  for (const TickInputs& inputs : recording.ticks) {
    tick(cores, inputs);
  }
  const std::chrono::duration<double> spent = Clock::now() - start;
  allocations += allocations_so_far != nullptr ? allocations_so_far() - before : 0;
  best_s = std::min(best_s, spent.count() / static_cast<double>(recording.ticks.size()));
}

}  // namespace

Result<TickBench> bench_tick(const robot::Robot& robot, int rounds, std::int64_t (*allocations_so_far)()) {
  const auto recorded = FARRIER_TRY(record(without_redesign(robot)));
  const Recording& recording = recorded;
  TickBench bench{kNever, kNever, kNever, kNever, 0};
  std::size_t decisions = 0;
  volatile double sink = 0.0;
  const auto time = [&](double& best_s, const auto& tick) {
    time_round(recording, best_s, allocations_so_far, bench.allocations, tick);
  };
  for (int round = 0; round < std::max(rounds, 1); ++round) {
    time(bench.tick_s,
         [&](Cores& cores, const TickInputs& inputs) { decisions += whole_tick(cores, recording.legs, inputs); });
    time(bench.control_s, [&](Cores& cores, const TickInputs& inputs) {
      announce(cores.nodes, recording.legs, inputs.phases);
      for (std::size_t i = 0; i < cores.nodes.size(); ++i) {
        sink = cores.nodes[i].step(inputs.joints[i]).valve.valve_current_A;
      }
    });
    time(bench.estimation_s, [&](Cores& cores, const TickInputs& inputs) {
      for (const signals::JointMeasurement& measurement : inputs.measurements) {
        cores.service.take(measurement);
        sink = cores.service.estimate(measurement.joint, inputs.tick).validity;
      }
    });
    time(bench.update_logic_s, [&](Cores& cores, const TickInputs& inputs) {
      for (const signals::JointModelEstimate& estimate : inputs.estimates) {
        cores.supervisor.take(estimate, inputs.tick);
      }
      decisions += cores.supervisor.step(inputs.tick).decisions.size();
    });
  }
  static_cast<void>(sink);
  if (decisions > 0) {
    return Error{"a redesign fell into the timed ticks: " + std::to_string(decisions) + " decisions"};
  }
  if (allocations_so_far == nullptr) {
    bench.allocations = -1;
  }
  return bench;
}

}  // namespace farrier::bench
