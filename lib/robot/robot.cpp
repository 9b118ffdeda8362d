#include "robot/robot.hpp"

#include <algorithm>
#include <fstream>
#include <utility>

#include "config/printer.hpp"
#include "config/reader.hpp"
#include "config/reference_table.hpp"
#include "core/noise.hpp"
#include "plant/terms/supply_droop.hpp"
#include "robot/body_loads.hpp"
#include "robot/description_format.hpp"
#include "robot/robot_builder.hpp"

namespace farrier::robot {
namespace {

constexpr std::size_t kLongestForeign = 4u << 20;  // of a robot's description of another kind, as much as is searched

std::vector<config::Setting> settings_of(const Overrides& overrides) {
  std::vector<config::Setting> settings;
  if (overrides.pattern) {
    settings.push_back({"gait.pattern", name_of(gait::kPatterns, *overrides.pattern)});
  }
  if (overrides.frequency_Hz) {
    settings.push_back({"gait.frequency_Hz", config::number_text(*overrides.frequency_Hz)});
  }
  return settings;
}

/// Joints of a robot on a ground have the controllers and estimators of locomotion and effects_on_ground. A command acts as late in
/// lock-step as in real time.
void put_on_ground(RobotFile& file, bool estimator_is_chosen) {
  for (auto& [name, joint] : file.joints) {
    if (file.locomotion && !file.locomotion->controller.empty()) {
      joint.controller = file.locomotion->controller;
    }
    if (file.locomotion && !file.locomotion->joint_estimator.empty() && !estimator_is_chosen) {
      joint.estimator = file.locomotion->joint_estimator;
    }
  }
  for (const auto& [name, added] : file.effects_on_ground) {
    const auto old = std::ranges::find(file.effects, name, &std::pair<std::string, JointEffectsSection>::first);
    if (old == file.effects.end()) {
      file.effects.emplace_back(name, added);
      continue;
    }
    for (std::size_t i = 0; i < added.effects.size(); ++i) {
      old->second.effects[i] = added.effects[i] ? added.effects[i] : old->second.effects[i];
    }
  }
  if (file.supply && file.supply->pump) {  // all joints share one supply in place of their own
    for (auto& [name, joint] : file.effects) {
      joint.effects[plant::effect_id<plant::SupplyDroop>()].reset();
    }
  }
  file.loop_delay_ticks.lockstep = file.loop_delay_ticks.realtime;
}

Result<Robot, config::Problems> build(Result<RobotFile, config::Problems> read, const Overrides& overrides) {
  if (!read) {
    return read.error();
  }
  RobotFile file = std::move(read).value();
  for (auto& [name, joint] : file.joints) {
    joint.dither_percent = overrides.without_dither ? 0.0 : joint.dither_percent;
    joint.estimator = overrides.estimator.value_or(joint.estimator);
  }
  if (overrides.on_ground) {
    put_on_ground(file, overrides.estimator.has_value());
  }
  if (overrides.without_effects) {
    file.effects.clear();
  }
  for (auto& [name, controller] : file.controllers) {
    controller.kind = overrides.controller.value_or(controller.kind);
  }
  auto robot = build_robot(std::move(file));
  if (overrides.on_ground && robot && robot.value().body) {
    robot.value().on_ground = true;
    put_loads_of_body(robot.value());
  }
  return robot;
}

}  // namespace

const Joint* Robot::find(std::string_view joint_name) const noexcept {
  const auto found =
      std::find_if(joints.begin(), joints.end(), [&](const Joint& joint) { return joint.name == joint_name; });
  return found == joints.end() ? nullptr : &*found;
}

std::string Robot::cannot_walk_error() const {
  return name + " cannot walk on a ground: give body.trunk and locomotion in its file";
}

const Joint* Robot::first_electric() const noexcept {
  const auto found = std::ranges::find_if(joints, [](const Joint& joint) { return joint.electric.has_value(); });
  return found == joints.end() ? nullptr : &*found;
}

Result<Robot, config::Problems> load_robot(const std::string& path, const Overrides& overrides) {
  auto read = config::read_file<RobotFile>(path, settings_of(overrides));
  if (!read) {
    std::ifstream stream(path, std::ios::binary);
    std::string begin(kLongestForeign, '\0');
    stream.read(begin.data(), static_cast<std::streamsize>(begin.size()));
    begin.resize(static_cast<std::size_t>(std::max<std::streamsize>(stream.gcount(), 0)));
    if (auto foreign = foreign_description(begin, path)) {
      return config::Problems{std::move(*foreign)};
    }
  }
  return build(std::move(read), overrides);
}

Result<Robot, config::Problems> load_robot_text(const std::string& text, const std::string& file,
                                                const Overrides& overrides) {
  if (auto foreign = foreign_description(text, file)) {
    return config::Problems{std::move(*foreign)};
  }
  return build(config::read_text<RobotFile>(text, file, settings_of(overrides)), overrides);
}

std::string print_config(const Robot& robot) { return config::print_yaml(robot.file); }

std::uint64_t configuration_hash(const Robot& robot) {
  RobotFile behaviour = robot.file;
  behaviour.deployment.reset();  // where a process runs changes nothing of what it does
  return stable_hash(config::print_yaml(std::move(behaviour)));
}

std::string parameter_table() { return config::reference_table<RobotFile>(); }

}  // namespace farrier::robot
