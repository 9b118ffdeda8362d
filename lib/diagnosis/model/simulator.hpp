#pragma once

#include <vector>

#include "diagnosis/model/model.hpp"

namespace farrier::diagnosis {

/// A number of a model that a fit may change.
struct FreeNumber {
  std::size_t place;  ///< as in Simulator::simulate_lanes
  ChannelMask channels;
  double low, high;
  double prior, spread;  ///< spread 0: none
};

/// A recording and the simulations of it by models, to which hypotheses are fitted and by which they are judged.
class Simulator {
 public:
  /// Derivatives that one simulation carries.
  static constexpr std::size_t kLanes = 12;

  virtual ~Simulator() = default;

  virtual double period_s() const noexcept = 0;
  virtual std::size_t size() const noexcept = 0;
  /// Measured values of a channel.
  virtual const std::vector<double>& measured(Channel channel) const noexcept = 0;
  /// True if a model claims to explain a channel at a sample.
  virtual bool explains(Channel channel, std::size_t sample) const noexcept = 0;

  virtual const plant::Scales& scales() const noexcept = 0;
  /// Numbers of an effect that every simulation has unless the model has its own of that kind, null for none.
  virtual const std::vector<double>* known(plant::EffectId id) const noexcept = 0;
  /// Error of these simulations in the fitted number of an effect's first parameter.
  virtual double least(plant::EffectId) const noexcept { return 0.0; }

  /// The model without effects.
  virtual Model nominal() const = 0;
  /// Channels on which an effect shows; none for an effect that what is simulated does not have.
  virtual ChannelMask channels(plant::EffectId effect) const noexcept = 0;
  /// True if an effect of the valve also bends the force between samples, which moves the load.
  virtual bool bends_force(plant::EffectId) const noexcept { return false; }
  /// Numbers of an effect's parameters from which its fits begin; none for an effect that this recording cannot show.
  virtual std::vector<std::vector<double>> starts(plant::EffectId effect) const = 0;
  /// Factors and numbers of effects of `model` that concern channels of `mask`. A factor that is known to
  /// `nominal_spread` is drawn to its nominal value.
  virtual std::vector<FreeNumber> free_numbers(const Model& model, const ChannelMask& mask,
                                               double nominal_spread) const = 0;

  /// The model's simulation of a channel over a span.
  virtual std::vector<double> simulate(Span span, const Model& model, Channel channel,
                                       const Observer& observer) const = 0;
  /// simulate() with derivatives by up to kLanes of the model's numbers. `lanes` name them: below kNominals a factor,
  /// from there on the numbers of the effects in their order. `jacobian` gets rows of lanes.size() numbers.
  virtual std::vector<double> simulate_lanes(Span span, const Model& model, Channel channel, const Observer& observer,
                                             const std::vector<std::size_t>& lanes,
                                             std::vector<double>& jacobian) const = 0;
};

}  // namespace farrier::diagnosis
