#include "world/actuators.hpp"

#include <algorithm>
#include <utility>

#include "robot/joint_plant.hpp"

namespace farrier::world {

namespace {

constexpr double kWearStep_s = 0.01;

/// `from` with what the change gives.
robot::Wear end_of(const body::ActuatorChange& change, const robot::Wear& from) noexcept {
  return {.valve_gain = change.valve_gain.value_or(from.valve_gain),
          .bulk_modulus = change.bulk_modulus.value_or(from.bulk_modulus),
          .viscosity = change.viscosity.value_or(from.viscosity),
          .seal_friction = change.seal_friction.value_or(from.seal_friction),
          .leakage = change.leakage_m3_s_Pa.value_or(from.leakage),
          .overlap_A = change.overlap_A.value_or(from.overlap_A),
          .stuck_A = change.stuck_A ? change.stuck_A : from.stuck_A};
}

Result<Done> check_supply_changes(const robot::Robot& robot, std::span<const body::SupplyChange> changes) {
  for (const body::SupplyChange& change : changes) {
    const std::string where = (change.origin.empty() ? "" : change.origin + ": ") + "supply." + change.name;
    if (!robot.supply) {
      return Error{where + ": " + robot.name + " has no pump: give supply.pump in its file, or leave this out"};
    }
    if (change.accumulator_volume_m3.value_or(0.0) > 0.0 && !(robot.supply->precharge_Pa > 0.0)) {
      return Error{where + ".accumulator_volume_m3: " + robot.name +
                   " has no accumulator: give supply.accumulator in its file, or leave this out"};
    }
  }
  return Done{};
}

}  // namespace

JointDrives::~JointDrives() = default;

Result<Actuators> Actuators::create(const robot::Robot& robot, std::vector<body::SupplyChange> supply_changes,
                                    std::vector<body::ActuatorChange> actuator_changes) {
  FARRIER_TRY(check_supply_changes(robot, supply_changes));
  auto changes = FARRIER_TRY(changes_of(robot, std::move(actuator_changes)));
  std::ranges::stable_sort(supply_changes, {}, &body::SupplyChange::start_s);
  std::optional<plant::Supply> supply;
  if (robot.supply) {
    supply = FARRIER_TRY(plant::Supply::create(*robot.supply));
  }
  std::vector<Joint> joints;
  body::JointVector angles_rad(static_cast<Eigen::Index>(robot.joints.size()));
  for (const robot::Joint& joint : robot.joints) {
    auto plant = robot::make_plant(joint, joint.stance_load);
    if (!plant) {
      return Error{joint.name + ": " + plant.error().message};
    }
    joints.push_back({.linkage = joint.linkage, .plant = std::move(plant).value(), .wear = robot::no_wear(joint)});
    angles_rad[joint.number] = joint.home_angle_rad;
  }
  return Actuators(std::move(joints), supply, std::move(supply_changes), std::move(changes), robot, angles_rad);
}

Actuators::Actuators(std::vector<Joint> joints, const std::optional<plant::Supply>& supply,
                     std::vector<body::SupplyChange> supply_changes, std::vector<Change> changes,
                     const robot::Robot& robot, const body::JointVector& angles_rad)
    : joints_(std::move(joints)),
      supply_(supply),
      supply_changes_(std::move(supply_changes)),
      as_in_file_(changes.empty() ? std::vector<robot::Joint>{} : robot.joints),
      changes_(std::move(changes)),
      torques_Nm_(body::JointVector::Zero(static_cast<Eigen::Index>(joints_.size()))) {
  for (std::size_t i = 0; i < joints_.size(); ++i) {
    set_force(i, angles_rad[static_cast<Eigen::Index>(i)]);
  }
  oil_at_start_J_ = stored_J();
  supply_at_start_J_ = supply_ ? supply_->stored_J() : 0.0;
}

Result<std::vector<Actuators::Change>> Actuators::changes_of(const robot::Robot& robot,
                                                             std::vector<body::ActuatorChange> actuator_changes) {
  std::ranges::stable_sort(actuator_changes, {}, &body::ActuatorChange::start_s);
  std::vector<Change> changes;
  std::vector<robot::Wear> wears;
  for (const robot::Joint& joint : robot.joints) {
    wears.push_back(robot::no_wear(joint));
  }
  for (const body::ActuatorChange& change : actuator_changes) {
    const std::string where = (change.origin.empty() ? "" : change.origin + ": ") + "actuators." + change.name;
    const std::size_t before = changes.size();
    for (const robot::Joint& joint : robot.joints) {
      if (!change.joint.empty() && joint.name != change.joint) {
        continue;
      }
      if (joint.electric) {
        return Error{where + ": " + joint.name + " is electric: give a hydraulic joint"};
      }
      robot::Wear& wear = wears[joint.number];
      wear = end_of(change, wear);
      if (const auto plant = robot::make_plant(robot::worn(joint, wear), joint.stance_load); !plant) {
        return Error{where + ": " + joint.name + ": " + plant.error().message};
      }
      changes.push_back({joint.number, change.start_s, change.duration_s, change});
    }
    if (changes.size() == before) {
      return Error{where + ".joint: " + robot.name + " has no joint " + change.joint +
                   ": give one of its joints, or leave the key out for all"};
    }
  }
  return changes;
}

void Actuators::wear_out(double time_s) noexcept {
  worn_until_s_ = time_s;
  std::erase_if(changes_, [&](Change& change) {
    if (change.start_s > time_s) {
      return false;
    }
    Joint& joint = joints_[change.joint];
    if (!change.from) {
      change.from = joint.wear;
    }
    const double share = change.duration_s > 0.0 ? std::min(1.0, (time_s - change.start_s) / change.duration_s) : 1.0;
    joint.wear = robot::between(*change.from, end_of(change.to, *change.from), share);
    const robot::Joint worn = robot::worn(as_in_file_[change.joint], joint.wear);
    joint.plant.set_actuator(worn.actuator, worn.effects);
    return share >= 1.0;
  });
}

void Actuators::set_force(std::size_t index, double angle_rad) noexcept {
  Joint& joint = joints_[index];
  joint.force = joint.plant.mechanism_force();
  torques_Nm_[static_cast<Eigen::Index>(index)] = joint.linkage.torque(angle_rad, joint.force);
}

void Actuators::command(std::span<const double> currents_A, double time_s) noexcept {
  for (; next_change_ < supply_changes_.size() && supply_changes_[next_change_].start_s <= time_s; ++next_change_) {
    const body::SupplyChange& change = supply_changes_[next_change_];
    supply_->set_pump_flow(change.pump_flow_m3_s.value_or(supply_->params().pump_flow_m3_s));
    if (change.accumulator_volume_m3) {
      supply_->set_accumulator_volume(*change.accumulator_volume_m3);
    }
  }
  if (!changes_.empty() && (time_s == 0.0 || time_s >= worn_until_s_ + kWearStep_s)) {
    wear_out(time_s);
  }
  for (std::size_t i = 0; i < joints_.size(); ++i) {
    joints_[i].current_A = joints_[i].wear.stuck_A.value_or(currents_A[i]);
  }
}

void Actuators::follow(const body::BodyState& state, double step_s) noexcept {
  const std::optional<double> pressure_Pa = supply_ ? std::optional(supply_->pressure_Pa()) : std::nullopt;
  const double drawn_before_m3 = energies_.oil.supply_m3;
  for (std::size_t i = 0; i < joints_.size(); ++i) {
    Joint& joint = joints_[i];
    const auto row = static_cast<Eigen::Index>(i);
    const double angle_rad = state.angles_rad[row];
    const plant::Motion end{joint.linkage.position(angle_rad),
                            joint.linkage.lever(angle_rad) * state.velocities_rad_s[row]};
    const double work_J = joint.force * (end.position - joint.plant.readings().position);
    const plant::DriveAccount account = joint.plant.follow(joint.current_A, pressure_Pa, end, step_s);
    energies_.oil.add(account.oil, 1.0);
    energies_.electric_J += account.electric_J;
    energies_.work_J += work_J;
    energies_.coupling_J += work_J - account.work_J;
    set_force(i, angle_rad);
  }
  if (supply_) {
    supply_->advance(energies_.oil.supply_m3 - drawn_before_m3, step_s);
  }
}

EnergyAudit Actuators::audit() const noexcept {
  if (!supply_) {
    return {};
  }
  const plant::SupplyAccount& supply = supply_->account();
  const plant::OilAccount& oil = energies_.oil;
  return {.pump_J = supply.pump_J,
          .accumulator_J = supply_->stored_J() - supply_at_start_J_ + supply.removed_J,
          .relief_J = supply.relief_J,
          .supply_leakage_J = supply.leakage_J,
          .valve_J = oil.valve_J,
          .leakage_J = oil.leakage_J,
          .return_J = oil.return_J,
          .oil_J = stored_J() - oil_at_start_J_,
          .friction_J = oil.friction_J,
          .work_J = energies_.work_J};
}

double Actuators::stored_J() const noexcept {
  double stored = 0.0;
  for (const Joint& joint : joints_) {
    stored += joint.plant.hydraulic() != nullptr ? joint.plant.hydraulic()->stored_J() : 0.0;
  }
  return stored;
}

}  // namespace farrier::world
