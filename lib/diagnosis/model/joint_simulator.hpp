#pragma once

#include "diagnosis/model/joint_sides.hpp"
#include "diagnosis/model/simulator.hpp"

namespace farrier::diagnosis {

/// The sides of a joint, from its recording. Both outlive this.
class JointSimulator final : public Simulator {
 public:
  /// `force_noise`: standard deviation of the force sensor, N or Nm; smaller forces are no effects.
  JointSimulator(const JointSides& model, const JointData& data, double force_noise = 0.0);

  const JointSides& model() const noexcept { return model_; }
  const JointData& data() const noexcept { return data_; }

  double period_s() const noexcept override { return data_.period_s; }
  std::size_t size() const noexcept override { return data_.size(); }
  const std::vector<double>& measured(Channel channel) const noexcept override;
  bool explains(Channel channel, std::size_t sample) const noexcept override;
  const plant::Scales& scales() const noexcept override { return model_.scales(); }
  const std::vector<double>* known(plant::EffectId id) const noexcept override { return model_.known(id); }
  double least(plant::EffectId effect) const noexcept override;
  Model nominal() const override { return Model::nominal(); }
  ChannelMask channels(plant::EffectId effect) const noexcept override { return model_.channels(effect); }
  bool bends_force(plant::EffectId effect) const noexcept override { return model_.bends_force(effect); }
  std::vector<std::vector<double>> starts(plant::EffectId effect) const override { return starts_[effect]; }
  std::vector<FreeNumber> free_numbers(const Model& model, const ChannelMask& mask,
                                       double nominal_spread) const override;
  std::vector<double> simulate(Span span, const Model& model, Channel channel,
                               const Observer& observer) const override {
    return model_.simulate(data_, span, model, channel, observer);
  }
  std::vector<double> simulate_lanes(Span span, const Model& model, Channel channel, const Observer& observer,
                                     const std::vector<std::size_t>& lanes,
                                     std::vector<double>& jacobian) const override {
    return model_.simulate_lanes(data_, span, model, channel, observer, lanes, jacobian);
  }

 private:
  const JointSides& model_;
  const JointData& data_;
  double force_noise_;
  std::vector<std::vector<std::vector<double>>> starts_;  ///< by effect
};

}  // namespace farrier::diagnosis
