#include "report/diagnosis/extended_model.hpp"

#include <algorithm>
#include <string_view>
#include <utility>

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

/// The file's text with the joint that it loads to again.
struct Reloaded {
  std::string text;
  robot::Robot robot;
};

Result<Reloaded> reloaded(const robot::Robot& extended) {
  std::string text = robot::print_config(extended);
  auto loaded = robot::load_robot_text(text, "extended model");
  if (!loaded) {
    return Error{"the model with the effects found cannot be loaded: " + config::to_string(loaded.error())};
  }
  return Reloaded{std::move(text), std::move(loaded).value()};
}

ExtendedModel electric_model(robot::Robot extended, const robot::Joint& joint,
                             std::span<const plant::ActiveEffect> found) {
  ExtendedModel model;
  model.left_out = put_into_drive_and_load(extended.file, joint, found);
  if (model.left_out.size() < found.size()) {
    auto again = reloaded(extended);
    if (!again) {
      model.left_out.push_back(again.error().message);
    } else if (again.value().robot.find(joint.name)->electric->rigid != joint.electric->rigid) {
      model.left_out.emplace_back("gear_stiffness: a drive with so stiff a spring counts as rigid in a robot file");
    } else {
      model.text = std::move(again.value().text);
      model.robot = std::move(again.value().robot);
    }
  }
  return model;
}

}  // namespace

Result<ExtendedModel> extended_model(const robot::Robot& robot, const robot::Joint& joint,
                                     std::span<const plant::ActiveEffect> found) {
  robot::Robot extended = robot;
  if (joint.electric) {
    return electric_model(std::move(extended), joint, found);
  }
  robot::JointEffectsSection& section = section_of(extended.file, joint.name);
  for (const plant::ActiveEffect& effect : found) {
    section.effects[effect.id] = section_of(effect, joint.rotary);
  }
  Reloaded again = FARRIER_TRY(reloaded(extended));
  const robot::Joint* const known = again.robot.find(joint.name);
  for (const plant::ActiveEffect& effect : found) {
    if (known == nullptr || std::ranges::find(known->effects, effect) == known->effects.end()) {
      return Error{"the model with the effects found loads without " + std::string(effect.info().name) + " of " +
                   joint.name};
    }
  }
  return ExtendedModel{std::move(again.text), std::move(again.robot), {}};
}

}  // namespace farrier::report
