#pragma once

#include "diagnosis/data/scaled_recording.hpp"
#include "diagnosis/model/simulator.hpp"
#include "plant/actuator.hpp"

namespace farrier::diagnosis {

/// Positions that a valve produces, in units of the recording's own:
///
///   position+ = position + gain q(valve) + drift
///
/// The flow q of the valve is its opening, modified by effects. Oil that a valve meters moves a piston at a speed,
/// Merritt (1967), 6.1, and the unseen load lets it sink or creep. The simulation runs freely, because no sensor in
/// between could feed an observer. It starts where the mean of a span's first kFirst positions is met, since a single
/// one would shift the whole span by its noise. Factors 0 and 1 of a Model are gain and drift.
class ScaledSimulator final : public Simulator {
 public:
  /// The only channel: the output of valve and oil, which is the position here.
  static constexpr Channel kChannel = Channel::kForce;
  /// Nominal duration of a sample, s. The effects' ranges of time are those of joints that are sampled at 1 kHz.
  static constexpr double kSample_s = 1e-3;
  static constexpr std::size_t kFirst = 8;

  /// `recording` outlives this.
  explicit ScaledSimulator(const ScaledRecording& recording);

  double period_s() const noexcept override { return kSample_s; }
  std::size_t size() const noexcept override { return recording_.position.size(); }
  const std::vector<double>& measured(Channel) const noexcept override { return recording_.position; }
  bool explains(Channel channel, std::size_t) const noexcept override { return channel == kChannel; }
  const plant::Scales& scales() const noexcept override { return scales_; }
  const std::vector<double>* known(plant::EffectId) const noexcept override { return nullptr; }
  /// Gain and drift that fit the steps of the position best.
  Model nominal() const override { return nominal_; }
  /// Starts for effects between command and flow.
  ChannelMask channels(plant::EffectId effect) const noexcept override;
  std::vector<std::vector<double>> starts(plant::EffectId effect) const override;
  std::vector<FreeNumber> free_numbers(const Model& model, const ChannelMask& mask,
                                       double nominal_spread) const override;
  std::vector<double> simulate(Span span, const Model& model, Channel channel, const Observer& observer) const override;
  std::vector<double> simulate_lanes(Span span, const Model& model, Channel channel, const Observer& observer,
                                     const std::vector<std::size_t>& lanes,
                                     std::vector<double>& jacobian) const override;

 private:
  template <class T>
  std::vector<T> run(Span span, const T& gain, const T& drift, plant::TermSet<T>& terms) const;

  const ScaledRecording& recording_;
  std::vector<double> valve_integral_;  ///< valve summed over time up to a sample, s; one more than samples
  plant::Scales scales_;
  Model nominal_;
};

}  // namespace farrier::diagnosis
