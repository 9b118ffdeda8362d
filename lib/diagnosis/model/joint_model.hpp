#pragma once

#include <array>
#include <string>
#include <vector>

#include "core/result.hpp"
#include "diagnosis/data/joint_data.hpp"
#include "diagnosis/model/model.hpp"
#include "diagnosis/model/side_models.hpp"
#include "plant/terms/terms.hpp"

namespace farrier::diagnosis {

/// A joint as its file has it, for simulations of its sides.
class JointModel {
 public:
  /// `known` effects are in every simulation, unless the model has its own of that kind.
  JointModel(const plant::ActuatorParams& actuator, const plant::LoadParams& load,
             std::vector<Model::Effect> known = {});

  /// Numbers of an effect that the joint is known to have, null for none.
  const std::vector<double>* known(plant::EffectId id) const noexcept;
  const std::vector<Model::Effect>& known() const noexcept { return known_; }

  const plant::Scales& scales() const noexcept { return scales_; }
  const plant::ActuatorParams& actuator() const noexcept { return actuator_; }
  const plant::LoadParams& load() const noexcept { return load_; }

  /// Constants for factors.
  template <class T>
  Constants<T> constants(const std::array<T, kNominals>& factors) const;

  /// Simulated readings over a span: force; motion of the load, as JointData::motion; velocity sensor.
  std::vector<double> simulate(const JointData& data, Span span, const Model& model, Channel channel,
                               const Observer& observer) const;

  /// Errors, measured less simulated, of simulations that leave an observed one every `every` samples of a span and run
  /// freely for `steps`, by the places where they leave. They are errors of the force, or of the load's position over
  /// JointData::kMotionTime_s.
  std::vector<double> errors_ahead(const JointData& data, Span span, const Model& model, Channel channel,
                                   const Observer& observer, std::size_t steps, std::size_t every) const;

  /// simulate() with derivatives as Simulator::simulate_lanes has them.
  std::vector<double> simulate_lanes(const JointData& data, Span span, const Model& model, Channel channel,
                                     const Observer& observer, const std::vector<std::size_t>& lanes,
                                     std::vector<double>& jacobian) const;

 private:
  template <class T>
  std::vector<T> run(const JointData& data, Span span, const std::array<T, kNominals>& factors,
                     const EffectNumbers<T>& effects, Channel channel, const Observer& observer) const;

  template <class T>
  plant::TermSet<T> terms(const JointData& data, const EffectNumbers<T>& effects) const;

  plant::ActuatorParams actuator_;
  plant::LoadParams load_;
  plant::Scales scales_;
  std::vector<Model::Effect> known_;
};

}  // namespace farrier::diagnosis
