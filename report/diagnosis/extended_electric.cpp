#include "report/diagnosis/extended_model.hpp"

#include <algorithm>
#include <optional>
#include <string_view>

#include "plant/terms/load_effects.hpp"
#include "robot/joint_scales.hpp"

namespace farrier::report {
namespace {

/// An item of a section that `users` joints have: itself for one user, else a copy under a name that is free.
template <class T>
T& own_item(config::Named<T>& items, std::string& name, std::ptrdiff_t users, const std::string& wanted) {
  const auto place = [&](const std::string& of) {
    return std::ranges::find(items, of, [](const auto& item) { return item.first; });
  };
  if (users > 1) {
    std::string free = wanted;
    for (int i = 2; place(free) != items.end(); ++i) {
      free = wanted + std::to_string(i);
    }
    items.emplace_back(free, place(name)->second);
    name = free;
  }
  return place(name)->second;
}

/// The joint's template, which no other joint has.
robot::JointTemplate& own_template(robot::RobotFile& file, const std::string& joint) {
  std::string* name = nullptr;
  const auto each = [&](auto&& use) {
    for (auto& [_, leg] : file.legs) {
      std::ranges::for_each(leg.joints, use);
    }
  };
  each([&](auto& item) { name = item.first == joint ? &item.second : name; });
  std::ptrdiff_t users = 0;
  each([&, used = *name](const auto& item) { users += item.second == used ? 1 : 0; });
  return own_item(file.joints, *name, users, joint);
}

/// Values of one joint's drive and load.
struct OwnValues {
  robot::ElectricActuator& drive;
  robot::RotaryLoads& load;
};

OwnValues own_values(robot::RobotFile& file, const std::string& joint) {
  robot::JointTemplate& mine = own_template(file, joint);
  const auto users = [&](std::string robot::JointTemplate::*part) {
    return std::ranges::count_if(file.joints, [&](const auto& item) { return item.second.*part == mine.*part; });
  };
  const std::ptrdiff_t of_drive = users(&robot::JointTemplate::actuator);
  const std::ptrdiff_t of_load = users(&robot::JointTemplate::load);
  return {own_item(file.electric_actuators, mine.actuator, of_drive, joint),
          *own_item(file.loads, mine.load, of_load, joint).rotary};
}

/// Puts an effect of the drive into its values; false if it has none for it.
bool put_into_drive(robot::ElectricActuator& drive, const plant::ElectricParams& as_given,
                    const plant::ActiveEffect& effect) {
  const std::string_view name = effect.info().name;
  const double value = effect.values[0];
  const bool motor = !drive.by_limits();
  if (name == "torque_constant" && !as_given.rigid) {
    drive.torque_constant_Nm_A = *drive.torque_constant_Nm_A * value;
  } else if (name == "rotor_inertia" && motor) {
    drive.rotor_inertia_kg_m2 = value;
  } else if (name == "gear_stiffness" && !as_given.rigid) {
    drive.spring_stiffness_Nm_rad = value;
  } else if (name == "gear_friction" || (name == "load_friction" && as_given.rigid)) {
    drive.coulomb_Nm += value;
  } else if (name == "current_lag" && as_given.rigid) {
    drive.torque_time_constant_s += value;
  } else if (name == "current_limit" && !motor) {
    drive.torque_limit_Nm = value;
  } else {
    return false;
  }
  return true;
}

void put_into(robot::RotaryLoad& section, const plant::LoadParams& load) {
  section.inertia_kg_m2 = load.mass;
  section.damping_Nms_rad = load.damping;
  section.stiffness_Nm_rad = load.stiffness;
  section.equilibrium_position_rad = load.equilibrium_position;
}

std::string reason(const plant::ActiveEffect& effect, bool rigid) {
  const std::string name = effect.info().name;
  return name == "torque_constant" && rigid
             ? name + ": the drive computes its torque by its own constant, so set it there"
             : name + ": a robot file has no value for it";
}

}  // namespace

std::vector<std::string> put_into_drive_and_load(robot::RobotFile& file, const robot::Joint& joint,
                                                 std::span<const plant::ActiveEffect> effects) {
  const plant::ElectricParams& drive = *joint.electric;
  robot::RobotFile changed = file;
  const OwnValues own = own_values(changed, joint.name);
  std::vector<std::string> left_out;
  bool any = false;
  for (const plant::ActiveEffect& effect : effects) {
    if (plant::is_in_load(effect.id) || put_into_drive(own.drive, drive, effect)) {
      any = true;
    } else {
      left_out.push_back(reason(effect, drive.rigid));
    }
  }
  const plant::Loads loads =
      plant::loads_with_effects({joint.swing_load, joint.stance_load}, robot::scales_of(joint), effects);
  put_into(own.load.swing, loads.swing);
  put_into(own.load.stance, loads.stance);
  if (any) {
    file = std::move(changed);
  }
  return left_out;
}

}  // namespace farrier::report
