#include "sim_bridge/body_robot.hpp"

#include <algorithm>

#include "config/problem.hpp"
#include "world/scene_file.hpp"

namespace farrier::sim_bridge {
namespace {

constexpr std::size_t kAxes = 3;
constexpr double kTouches_N = 1.0;  ///< a foot that presses more stands

std::array<double, kAxes> array_of(const Eigen::Vector3d& vector) noexcept {
  return {vector.x(), vector.y(), vector.z()};
}

}  // namespace

BodyRobot::BodyRobot(const robot::Robot& robot, world::BodyWorld world, std::optional<world::Actuators> actuators,
                     std::vector<SensorChain> sensors)
    : joints_(robot.joints),
      period_s_(robot.period_s),
      world_(std::move(world)),
      actuators_(std::move(actuators)),
      sensors_(std::move(sensors)),
      torques_Nm_(joints_.size(), 0.0),
      supply_ticks_(robot.supply_ticks()) {
  if (actuators_ && actuators_->supply() != nullptr) {
    meter_.emplace(*actuators_->supply(), period_s_);
  }
  for (std::size_t i = 0; i < joints_.size(); ++i) {
    before_.push_back(truth_of_joint(i));
    sensors_[i].begin(before_[i]);
  }
}

Result<BodyRobot> BodyRobot::create(const robot::Robot& robot, const body::Scene& scene, std::uint64_t seed, bool ideal,
                                    int finer) {
  auto world = FARRIER_TRY(world::BodyWorld::create(robot, scene, seed, world::kImuNoise, finer));
  std::optional<world::Actuators> actuators;
  if (!ideal) {
    actuators = FARRIER_TRY(world::Actuators::create(robot, scene.supply_changes, scene.actuator_changes));
  } else if (!scene.supply_changes.empty()) {
    const body::SupplyChange& change = scene.supply_changes.front();
    return Error{(change.origin.empty() ? "" : change.origin + ": ") + "supply." + change.name +
                 ": ideal joints have no supply: simulate the actuators, or leave this out"};
  } else if (!scene.actuator_changes.empty()) {
    const body::ActuatorChange& change = scene.actuator_changes.front();
    return Error{(change.origin.empty() ? "" : change.origin + ": ") + "actuators." + change.name +
                 ": ideal joints have no actuators: simulate them, or leave this out"};
  }
  std::vector<SensorChain> sensors;
  for (const robot::Joint& joint : robot.joints) {
    sensors.push_back(FARRIER_TRY(SensorChain::create(joint, robot.period_s, seed)));
  }
  return BodyRobot(robot, std::move(world), std::move(actuators), std::move(sensors));
}

Measured BodyRobot::truth_of_joint(std::size_t index) const noexcept {
  const plant::Linkage& linkage = joints_[index].linkage;
  const world::JointReading hinge = world_.reading(index);
  return {.position = linkage.position(hinge.position),
          .velocity = linkage.lever(hinge.position) * hinge.velocity,
          .force = actuators_ ? actuators_->joint(index).readings().load_cell_force
                              : linkage.force(hinge.position, hinge.force)};
}

bool BodyRobot::move(std::span<const double> commands) noexcept {
  if (actuators_) {
    actuators_->command(commands, static_cast<double>(tick()) * period_s_);
    return world_.advance(*actuators_);
  }
  for (std::size_t i = 0; i < joints_.size(); ++i) {
    torques_Nm_[i] = joints_[i].linkage.torque(world_.state().angles_rad[static_cast<Eigen::Index>(i)], commands[i]);
  }
  return world_.advance(torques_Nm_);
}

// Conversions between two ticks see a straight line between the truths of both.
bool BodyRobot::advance(std::span<const double> commands) noexcept {
  if (!move(commands)) {
    return false;
  }
  for (std::size_t i = 0; i < joints_.size(); ++i) {
    const Measured now = truth_of_joint(i);
    const int parts = sensors_[i].conversions();
    for (int part = 0; part < parts; ++part) {
      const double share = static_cast<double>(part + 1) / parts;
      const Measured between{.position = before_[i].position + share * (now.position - before_[i].position),
                             .velocity = before_[i].velocity + share * (now.velocity - before_[i].velocity),
                             .force = now.force};
      sensors_[i].convert(part + 1 < parts ? between : now, tick(), part);
    }
    before_[i] = now;
  }
  if (meter_ && tick() % supply_ticks_ == 0) {
    meter_->sample(*actuators_->supply(), tick());
  }
  return true;
}

std::optional<world::SupplyReading> BodyRobot::supply() const noexcept {
  if (!meter_) {
    return std::nullopt;
  }
  return world::SupplyReading{meter_->state().pressure_Pa, meter_->state().pump_flow_m3_s};
}

void BodyRobot::describe(std::size_t index, trace::TraceRow& row) const noexcept {
  row.tick = tick();
  row.joint = joints_[index].number;
  row.position_m_or_rad = before_[index].position;
  row.velocity_m_s_or_rad_s = before_[index].velocity;
  row.force_N_or_Nm = before_[index].force;
  if (const plant::HydraulicJoint* hydraulic = actuators_ ? actuators_->joint(index).hydraulic() : nullptr) {
    row.pressure_a_Pa = hydraulic->state().pressure_a_Pa;
    row.pressure_b_Pa = hydraulic->state().pressure_b_Pa;
  }
  row.actual_phase = world_.foot_force_N(joints_[index].leg).norm() > kTouches_N ? Phase::kStance : Phase::kSwing;
}

std::optional<signals::BodyTruth> BodyRobot::truth() const noexcept {
  const body::BodyState& state = world_.state();
  signals::BodyTruth truth;
  truth.tick = tick();
  truth.position_m = array_of(state.position_m);
  truth.attitude = {state.attitude.w(), state.attitude.x(), state.attitude.y(), state.attitude.z()};
  truth.velocity_m_s = array_of(state.linear_velocity_m_s);
  truth.angular_velocity_rad_s = array_of(state.angular_velocity_rad_s);
  for (int leg = 0; leg < world_.body().legs(); ++leg) {
    const auto force = array_of(world_.foot_force_N(leg));
    std::ranges::copy(force, truth.foot_force_N.begin() + static_cast<std::ptrdiff_t>(kAxes) * leg);
  }
  truth.push_N = array_of(world_.push_N());
  return truth;
}

std::optional<signals::SupplyTruth> BodyRobot::supply_truth() const noexcept {
  if (!meter_) {
    return std::nullopt;
  }
  signals::SupplyTruth truth;
  truth.tick = tick();
  for (std::size_t i = 0; i < std::min(joints_.size(), truth.pressure_a_Pa.size()); ++i) {
    if (const plant::HydraulicJoint* hydraulic = actuators_->joint(i).hydraulic()) {
      truth.pressure_a_Pa[i] = hydraulic->state().pressure_a_Pa;
      truth.pressure_b_Pa[i] = hydraulic->state().pressure_b_Pa;
    }
  }
  world::put(actuators_->audit(), truth);
  return truth;
}

bool has_physics_engine() noexcept { return true; }

Result<std::unique_ptr<SimulatedRobot>> simulated_body(const robot::Robot& robot, const std::string& scene_path,
                                                       std::uint64_t seed, bool ideal) {
  const auto scene =
      scene_path.empty() ? world::load_scene_text("friction: 0.8\n", "the plane") : world::load_scene(scene_path);
  if (!scene) {
    return Error{config::to_string(scene.error())};
  }
  auto body = FARRIER_TRY(BodyRobot::create(robot, scene.value(), seed, ideal));
  return std::unique_ptr<SimulatedRobot>(std::make_unique<BodyRobot>(std::move(body)));
}

}  // namespace farrier::sim_bridge
