#include "sim_bridge/sim_world.hpp"

#include <algorithm>

#include "robot/joint_plant.hpp"

namespace farrier::sim_bridge {

SimWorld::SimWorld(const robot::Robot& robot, std::uint64_t seed)
    : plan_(robot.plan), schedule_(robot.plan, seed), reference_(robot.plan) {}

Result<SimWorld> SimWorld::create(const robot::Robot& robot, std::uint64_t seed,
                                  std::vector<robot::LoadChange> load_changes) {
  SimWorld world(robot, seed);
  for (const robot::Joint& joint : robot.joints) {
    auto plant = robot::make_plant(joint, joint.stance_load);
    if (!plant) {
      return Error{joint.name + ": " + plant.error().message};
    }
    auto sensors = SensorChain::create(joint, robot.period_s, seed);
    if (!sensors) {
      return Error{joint.name + ": " + sensors.error().message};
    }
    world.joints_.push_back(
        {joint, std::move(plant).value(), std::move(sensors).value(), gait::Phase::kStance, 0.0, false});
  }
  for (const robot::LoadChange& change : load_changes) {
    if (change.joint >= world.joints_.size()) {
      return Error{"a load change of joint " + std::to_string(change.joint) + ": " + robot.name + " has " +
                   std::to_string(world.joints_.size()) + " joints"};
    }
    plant::Joint trial = world.joints_[change.joint].plant;
    if (!trial.set_load(change.load)) {
      return Error{robot.joints[change.joint].name + ": cannot carry a load of " + std::to_string(change.load.mass) +
                   " from tick " + std::to_string(change.tick) + " on"};
    }
  }
  std::ranges::stable_sort(load_changes, {}, &robot::LoadChange::tick);
  world.load_changes_ = std::move(load_changes);
  world.apply_loads();
  for (Joint& joint : world.joints_) {
    joint.sensors.begin(truth_of(joint.plant));
  }
  return world;
}

void SimWorld::apply_load_changes() noexcept {
  for (; next_load_change_ < load_changes_.size() && load_changes_[next_load_change_].tick <= tick_;
       ++next_load_change_) {
    const robot::LoadChange& change = load_changes_[next_load_change_];
    joints_[change.joint].plant.set_load(change.load);
    joints_[change.joint].load_ruled = true;
  }
}

void SimWorld::apply_loads() noexcept {
  apply_load_changes();
  for (Joint& joint : joints_) {
    const int leg = joint.parameters.leg;
    const gait::Phase phase = schedule_.actual_phase(leg, tick_);
    if (phase != joint.load_phase && !joint.load_ruled) {
      joint.plant.set_load(phase == gait::Phase::kStance ? joint.parameters.stance_load : joint.parameters.swing_load);
    }
    joint.load_phase = phase;
    joint.external_force = 0.0;
  }
  // The ground pushes each leg up with its share of the weight: tau = J^T f at the leg's actual pose.
  for (std::size_t leg = 0; leg < plan_.legs.size(); ++leg) {
    if (plan_.gait.reference != gait::ReferenceKind::kLegKinematics) {
      continue;
    }
    const int number = static_cast<int>(leg);
    const double share =
        gait::load_share(schedule_.actual_stance_progress(number, tick_), plan_.gait.load_transfer_fraction);
    if (share <= 0.0) {
      continue;
    }
    Eigen::Vector3d angles = Eigen::Vector3d::Zero();
    for (const Joint& joint : joints_) {
      if (joint.parameters.leg == number) {
        angles[joint.parameters.index_in_leg] = joint.parameters.linkage.angle(joint.plant.readings().position);
      }
    }
    const Eigen::Vector3d torques =
        gait::ground_torques(plan_.legs[leg].geometry, angles, share * reference_.weight_per_share_N(tick_));
    for (Joint& joint : joints_) {
      if (joint.parameters.leg == number) {
        const int index = joint.parameters.index_in_leg;
        joint.external_force = joint.parameters.linkage.force(angles[index], torques[index]);
      }
    }
  }
}

world::JointReading SimWorld::reading(std::size_t index) const noexcept {
  const Measured sample = joints_[index].sensors.sample();
  return {sample.position, sample.velocity, sample.force};
}

signals::JointSensors SimWorld::sample(std::size_t index) const noexcept {
  const Joint& joint = joints_[index];
  signals::JointSensors sensors;
  sensors.joint = joint.parameters.number;
  sensors.tick = tick_;
  put(joint.sensors.sample(), sensors);
  return sensors;
}

void SimWorld::describe(std::size_t index, trace::TraceRow& row) const noexcept {
  const Joint& joint = joints_[index];
  const plant::JointReadings read = joint.plant.readings();
  row.tick = tick_;
  row.joint = joint.parameters.number;
  row.position_m_or_rad = read.position;
  row.velocity_m_s_or_rad_s = read.velocity;
  row.force_N_or_Nm = read.load_cell_force;
  if (const plant::HydraulicJoint* hydraulic = joint.plant.hydraulic()) {
    row.pressure_a_Pa = hydraulic->state().pressure_a_Pa;
    row.pressure_b_Pa = hydraulic->state().pressure_b_Pa;
  }
  row.external_force_N_or_Nm = joint.external_force;
  row.load_mass_kg_or_kgm2 = joint.plant.load().mass;
  row.actual_phase = joint.load_phase;
}

// One period in as many parts as the sensors convert in it; the last conversion waits for the load of the next tick.
void SimWorld::step(Joint& joint, double valve_current_A) noexcept {
  const int parts = joint.sensors.conversions();
  for (int part = 0; part < parts; ++part) {
    const plant::StepReport report = joint.plant.step(valve_current_A, joint.external_force, plan_.period_s / parts);
    worst_.error_position = std::max(worst_.error_position, report.error_position);
    worst_.error_velocity = std::max(worst_.error_velocity, report.error_velocity);
    worst_.error_pressure_Pa = std::max(worst_.error_pressure_Pa, report.error_pressure_Pa);
    worst_.substeps = std::max(worst_.substeps, report.substeps);
    worst_.bound_hit = worst_.bound_hit || report.bound_hit;
    if (part + 1 < parts) {
      joint.sensors.convert(truth_of(joint.plant), tick_ + 1, part);
    }
  }
}

bool SimWorld::advance(std::span<const double> valve_current_A) noexcept {
  for (std::size_t i = 0; i < joints_.size(); ++i) {
    step(joints_[i], valve_current_A[i]);
  }
  ++tick_;
  apply_loads();
  for (Joint& joint : joints_) {
    joint.sensors.convert(truth_of(joint.plant), tick_, joint.sensors.conversions() - 1);
  }
  return true;
}

Result<std::unique_ptr<SimulatedRobot>> simulated_bench(const robot::Robot& robot, std::uint64_t seed,
                                                        std::vector<robot::LoadChange> load_changes) {
  auto bench = FARRIER_TRY(SimWorld::create(robot, seed, std::move(load_changes)));
  return std::unique_ptr<SimulatedRobot>(std::make_unique<SimWorld>(std::move(bench)));
}

}  // namespace farrier::sim_bridge
