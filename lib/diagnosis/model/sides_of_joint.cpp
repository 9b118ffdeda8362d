#include "diagnosis/model/sides_of_joint.hpp"

#include "diagnosis/model/electric_model.hpp"
#include "diagnosis/model/joint_model.hpp"
#include "plant/terms/load_effects.hpp"
#include "robot/joint_scales.hpp"

namespace farrier::diagnosis {
namespace {

/// Effects of the joint's file, except those that are in its load.
std::vector<Model::Effect> known_effects(const robot::Joint& joint, const plant::Scales& scales) {
  std::vector<Model::Effect> known;
  for (const plant::ActiveEffect& effect : joint.effects) {
    if (!plant::is_in_load(effect.id)) {
      const auto fitted = plant::fitted_of(effect, scales);
      known.push_back({effect.id, {fitted.begin(), fitted.begin() + std::ssize(effect.info().parameters)}});
    }
  }
  return known;
}

}  // namespace

std::unique_ptr<JointSides> sides_of(const robot::Joint& joint) {
  if (joint.electric) {
    return std::make_unique<ElectricModel>(*joint.electric, joint.swing_load, joint.push_limit);
  }
  return std::make_unique<JointModel>(joint.actuator, joint.swing_load, known_effects(joint, robot::scales_of(joint)));
}

}  // namespace farrier::diagnosis
