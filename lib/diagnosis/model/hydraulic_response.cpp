// JointModel::respond(): the plant's own integrator with a model's effects.

#include <algorithm>

#include "diagnosis/model/joint_model.hpp"
#include "plant/hydraulic_joint.hpp"
#include "plant/terms/load_effects.hpp"

namespace farrier::diagnosis {

std::vector<plant::JointReadings> JointModel::respond(const Model& model, std::span<const double> current_A,
                                                      double period_s) const {
  std::vector<plant::ActiveEffect> effects;
  plant::TermSet<double> sensors;
  const auto add = [&](const Model::Effect& effect) {
    effects.push_back(plant::active_effect(effect.id, effect.fitted, scales_));
    plant::add_to(sensors, effects.back(), scales_, period_s);
  };
  std::ranges::for_each(model.effects, add);
  for (const Model::Effect& known : known_) {
    if (!model.has(known.id)) {
      add(known);
    }
  }
  const plant::LoadParams load = plant::loads_with_effects({load_, load_}, actuator_, effects).swing;
  auto plant =
      plant::HydraulicJoint::create(actuator_, load, plant::equilibrium(actuator_, load, 0.5 * actuator_.stroke, 0.0),
                                    plant::HydraulicJoint::kDefaultTolerance, effects);
  std::vector<plant::JointReadings> readings;
  if (!plant) {
    return readings;
  }
  for (const double command_A : current_A) {
    const plant::State& state = plant.value().state();
    plant::ForceMoment<double> cell{plant.value().load_cell_force()};
    sensors.on_force(cell);
    readings.push_back({state.position, sensors.on_velocity(state.velocity), cell.force});
    plant.value().step(command_A, 0.0, period_s);
  }
  return readings;
}

}  // namespace farrier::diagnosis
