#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "diagnosis/judge/fit.hpp"

namespace farrier::diagnosis {

/// A set of effects, fitted to each half of a recording and judged on the other.
struct Hypothesis {
  std::vector<plant::EffectId> effects;
  std::array<FitResult, 2> halves;
  /// Sum of squared residuals of each block of the recording, by channel; a block is judged by the other half's fit.
  std::array<std::vector<double>, kChannels> squares;
  /// Sum of squared residuals of each half by its own fit, by channel.
  std::array<std::array<double, 2>, kChannels> fitted_squares{};
  /// Rms of the residuals of each half by its own fit, by channel: what a residual counts as one in fits that go on from
  /// here. With that of a poorer model priors would outweigh the data, and effects take the place of constants.
  std::array<double, kChannels> weight{1.0, 1.0, 1.0};

  double total(std::size_t channel) const noexcept;
};

/// The hypothesis that a model is right, which nothing was fitted to or judged by.
Hypothesis hypothesis_of(const Model& model);

/// By how much the held-out error of `after` is below that of `before`.
struct Gain {
  double log_ratio;  ///< sum over the channels of ln(rms before / rms after)
  double low, high;  ///< its 95 % band under resampled blocks (Kuensch 1989)
  std::array<double, 2> by_half;
  std::array<double, kChannels> reduction;  ///< 1 - rms after / rms before
  double chance;                            ///< share of resamplings in which `after` is better
};

/// Held-out NRMSE of two hypotheses: the root of the mean over channels of squared error over the variance of the
/// measurement; and the 95 % band of before / after.
struct ErrorRatio {
  double before, after, low, high;
};

/// Everything needed to judge hypotheses about one recording.
class Bench {
 public:
  /// `simulator` outlives this.
  Bench(const Simulator& simulator, const ChannelMask& judged, const FitOptions& options);

  /// The nominal model, its constants fitted within their band.
  Hypothesis base() const;
  /// `from` fitted again by the weight of its own residuals; `from` itself if that leaves more on held-out time.
  Hypothesis refined(const Hypothesis& from) const;
  /// Effects beside a hypothesis, fitted to the first half in few steps.
  struct Sketch {
    std::vector<plant::EffectId> added;
    Model model;
    double cost;     ///< of the fit; infinite if it has no finite simulation
    double promise;  ///< log ratio of errors that they improve on the second half
  };
  /// Sketches one effect beside `from`, from the best of `starts`; empty without a start.
  std::optional<Sketch> sketch(const Hypothesis& from, plant::EffectId effect,
                               const std::vector<std::vector<double>>& starts) const;
  /// Sketches effects together beside `from`, which has none of them.
  Sketch sketch(const Hypothesis& from, const std::vector<Model::Effect>& start) const;
  /// Adds the sketched effects to `from`. Empty if the sketch promises less than `least_gain` of log ratio, or if a fit
  /// improves its own half by less.
  std::optional<Hypothesis> with(const Hypothesis& from, const Sketch& sketch, double least_gain) const;
  /// Adds an effect to `from` by its numbers in one half: the other half, on which it is not to act, gets the same. Empty
  /// without a start.
  std::optional<Hypothesis> with_in_half(const Hypothesis& from, plant::EffectId effect, std::size_t half) const;
  /// Rms over a half for the sum of its squares.
  double rms_of_half(double squares, std::size_t half, std::size_t channel) const noexcept;
  /// `from` with one effect less and all else as it is.
  Hypothesis cut(const Hypothesis& from, plant::EffectId effect) const;
  /// `from` with one effect less, fitted again.
  Hypothesis without(const Hypothesis& from, plant::EffectId effect) const;
  /// `from` with `other` in place of `effect`, its fits beginning at `fitted` by half; it stands last.
  Hypothesis exchanged(const Hypothesis& from, plant::EffectId effect, plant::EffectId other,
                       const std::array<std::vector<double>, 2>& fitted) const;

  Gain gain(const Hypothesis& before, const Hypothesis& after) const;
  ErrorRatio error_ratio(const Hypothesis& before, const Hypothesis& after) const;

  const Simulator& simulator() const noexcept { return simulator_; }
  const FitData& fit_data() const noexcept { return fit_data_; }
  const FitOptions& options() const noexcept { return options_; }
  std::array<Span, 2> halves() const noexcept;
  /// `mask` and the channels of those effects that reach into it: what must be fitted together.
  ChannelMask closure(ChannelMask mask, const std::vector<Model::Effect>& effects) const noexcept;
  /// The channels of effects beside `from`, and those that must be fitted with them.
  ChannelMask closure_of(const std::vector<plant::EffectId>& added, const Hypothesis& from) const noexcept;

 private:
  /// Fits `start` to a half. If `bent`, an effect that bends the force between samples has come or gone, and the load's
  /// constants are fitted again by that force: else they stand for the bend. The effect itself is not, since the bend goes
  /// up and down with a delay.
  FitResult fit_half(const Hypothesis& from, std::size_t half, const Model& start, const ChannelMask& mask,
                     bool bent) const;
  /// `fitted` to one half as a start for the other: numbers that concern no channel of `mask` are those of `own`.
  Model start_of_other(const Model& fitted, const Model& own, const ChannelMask& mask) const;
  void judge(Hypothesis& hypothesis, const Hypothesis* like, const ChannelMask& changed) const;
  /// Sum of squared residuals of a half by its own fit.
  double fitted_square(const Hypothesis& hypothesis, std::size_t half, std::size_t channel) const;
  std::vector<double> block_squares(const Model& model, std::size_t half, std::size_t channel) const;
  double fitted_gain(const Hypothesis& from, const Hypothesis& with, const ChannelMask& mask) const;
  double promise(const Hypothesis& from, const Model& model, const ChannelMask& mask) const;
  /// Rms over both halves for the sum of their squares.
  double rms_of(double squares, std::size_t channel) const noexcept;
  /// The recording, a residual counting as it does beside `from`.
  FitData beside(const Hypothesis& from) const noexcept { return {&simulator_, fit_data_.judged, from.weight}; }

  const Simulator& simulator_;
  FitOptions options_;
  FitData fit_data_;
  std::array<std::array<std::size_t, 2>, kChannels> count_{};  ///< samples that are judged, by half
};

}  // namespace farrier::diagnosis
