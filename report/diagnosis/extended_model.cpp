#include "report/diagnosis/extended_model.hpp"

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <fstream>
#include <string_view>

namespace farrier::report {
namespace {

robot::JointEffectsSection& section_of(robot::RobotFile& file, const std::string& joint) {
  for (auto& [name, section] : file.effects) {
    if (name == joint) {
      return section;
    }
  }
  return file.effects.emplace_back(joint, robot::JointEffectsSection{}).second;
}

robot::EffectSection section_of(const plant::ActiveEffect& effect, bool rotary) {
  robot::EffectSection section{.id = effect.id, .values = {}, .rotary_values = {}, .place = {}};
  for (std::size_t i = 0; i < effect.info().parameters.size(); ++i) {
    const plant::Parameter& p = effect.info().parameters[i];
    const bool by_rotary_name = rotary && std::string_view(p.name) != p.rotary_name;
    (by_rotary_name ? section.rotary_values : section.values)[i] = effect.values[i];
  }
  return section;
}

}  // namespace

Result<std::string> extended_model(const robot::Robot& robot, const robot::Joint& joint,
                                   std::span<const plant::ActiveEffect> found) {
  robot::Robot extended = robot;
  robot::JointEffectsSection& section = section_of(extended.file, joint.name);
  for (const plant::ActiveEffect& effect : found) {
    section.effects[effect.id] = section_of(effect, joint.rotary);
  }
  const std::string text = robot::print_config(extended);
  const auto loaded = robot::load_robot_text(text, "extended model");
  if (!loaded) {
    return Error{"the model with the effects found cannot be loaded: " + config::to_string(loaded.error())};
  }
  const robot::Joint* const again = loaded.value().find(joint.name);
  for (const plant::ActiveEffect& effect : found) {
    if (again == nullptr || std::ranges::find(again->effects, effect) == again->effects.end()) {
      return Error{"the model with the effects found loads without " + std::string(effect.info().name) + " of " +
                   joint.name};
    }
  }
  return text;
}

}  // namespace farrier::report
