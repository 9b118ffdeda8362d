#pragma once

#include <array>
#include <vector>

#include "diagnosis/judge/hypothesis.hpp"
#include "diagnosis/judge/linearised.hpp"

namespace farrier::diagnosis {

/// Predicts what effects would improve beside a hypothesis, without fits. Each start of an effect takes one simulation with
/// derivatives, and the Gauss-Newton step from there moves the effect's numbers and those of the hypothesis together.
class Screening {
 public:
  /// Simulates the hypothesis over the first half. Both outlive this.
  Screening(const Bench& bench, const Hypothesis& from);

  /// Start of an effect's fit and the log ratio of errors that the step from there predicts, over the first half.
  struct Promise {
    std::vector<double> start;  ///< empty: the recording cannot show the effect
    double log_ratio = 0.0;
  };
  /// The most promising start of an effect that the hypothesis does not have.
  Promise promise_of(plant::EffectId effect) const;
  /// Starts of two effects that the hypothesis does not have, the most promising together; `start` is empty if the
  /// recording cannot show one of them.
  struct PairPromise {
    std::vector<Model::Effect> start;
    double log_ratio = 0.0;
  };
  PairPromise promise_of(plant::EffectId one, plant::EffectId other) const;

 private:
  Linearised linearise(const Model& model, Channel channel, const std::vector<FreeNumber>& free) const;
  /// Log ratio that a step of the hypothesis with `added` from their starts predicts.
  double predicted_log_ratio(const std::vector<Model::Effect>& added) const;

  const Bench& bench_;
  const Hypothesis& from_;
  Span span_;
  std::vector<FreeNumber> free_;
  std::array<Linearised, kChannels> own_;
};

}  // namespace farrier::diagnosis
