#pragma once

#include <array>
#include <string>
#include <vector>

#include "core/result.hpp"
#include "diagnosis/data/joint_data.hpp"
#include "diagnosis/model/joint_sides.hpp"
#include "diagnosis/model/model.hpp"
#include "diagnosis/model/side_models.hpp"
#include "plant/terms/terms.hpp"

namespace farrier::diagnosis {

/// A hydraulic joint as its file has it, for simulations of its sides.
class JointModel final : public JointSides {
 public:
  /// `known` effects are in every simulation, unless the model has its own of that kind.
  JointModel(const plant::ActuatorParams& actuator, const plant::LoadParams& load,
             std::vector<Model::Effect> known = {});

  const std::vector<double>* known(plant::EffectId id) const noexcept override;
  const std::vector<Model::Effect>& known() const noexcept { return known_; }

  const char* actuator_side() const noexcept override { return "valve_and_oil"; }
  const plant::Scales& scales() const noexcept override { return scales_; }
  const plant::ActuatorParams& actuator() const noexcept { return actuator_; }
  const plant::LoadParams& load() const noexcept override { return load_; }

  ChannelMask channels(plant::EffectId id) const noexcept override;
  bool bends_force(plant::EffectId id) const noexcept override;
  ChannelMask nominal_channels(std::size_t factor) const noexcept override;
  std::size_t replaced(plant::EffectId id) const noexcept override { return replaced_of_load(id); }
  bool fits(plant::EffectId id, std::size_t parameter) const noexcept override;
  std::vector<std::vector<double>> starts(plant::EffectId id, const JointData& data) const override;

  /// Constants for factors.
  template <class T>
  Constants<T> constants(const std::array<T, kNominals>& factors) const;

  JointData prepared(const Recording& recording, double position_noise) const override {
    return prepare(recording, actuator_, position_noise);
  }
  std::vector<double> simulate(const JointData& data, Span span, const Model& model, Channel channel,
                               const Observer& observer) const override;
  std::vector<double> errors_ahead(const JointData& data, Span span, const Model& model, Channel channel,
                                   const Observer& observer, std::size_t steps, std::size_t every) const override;
  std::vector<double> simulate_lanes(const JointData& data, Span span, const Model& model, Channel channel,
                                     const Observer& observer, const std::vector<std::size_t>& lanes,
                                     std::vector<double>& jacobian) const override;
  std::vector<plant::JointReadings> respond(const Model& model, std::span<const double> current_A,
                                            double period_s) const override;

 private:
  template <class T>
  std::vector<T> run(const JointData& data, Span span, const std::array<T, kNominals>& factors,
                     const EffectNumbers<T>& effects, Channel channel, const Observer& observer) const;

  template <class T>
  plant::TermSet<T> terms(const JointData& data, const EffectNumbers<T>& effects, Channel channel) const;

  plant::ActuatorParams actuator_;
  plant::LoadParams load_;
  plant::Scales scales_;
  std::vector<Model::Effect> known_;
};

}  // namespace farrier::diagnosis
