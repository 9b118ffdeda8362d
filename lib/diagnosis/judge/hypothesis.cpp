#include "diagnosis/judge/hypothesis.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace farrier::diagnosis {
namespace {

/// Square of residuals that stands for a simulation without a finite end: more than any recording leaves.
constexpr double kDiverged = 1e60;
/// Log ratio of errors by which a fit that goes on may be worse on held-out time.
constexpr double kNoWorse = 0.02;

}  // namespace

double Hypothesis::total(std::size_t channel) const noexcept {
  return std::accumulate(squares[channel].begin(), squares[channel].end(), 0.0);
}

Hypothesis hypothesis_of(const Model& model) {
  Hypothesis all;
  std::ranges::transform(model.effects, std::back_inserter(all.effects), &Model::Effect::id);
  const FitResult half{.model = model, .cost = 0.0, .deviation = {}};
  all.halves = {half, half};
  return all;
}

Bench::Bench(const Simulator& simulator, const ChannelMask& judged, const FitOptions& options)
    : simulator_(simulator), options_(options), fit_data_{&simulator, judged, {1.0, 1.0, 1.0}} {
  for (std::size_t c = 0; c < kChannels; ++c) {
    if (judged[c]) {
      const auto error =
          residuals(simulator, {0, simulator.size()}, simulator.nominal(), static_cast<Channel>(c), options_);
      fit_data_.weight[c] = std::max(judged_rms(error), 1e-12);
    }
    const auto skip = static_cast<std::size_t>(options_.warm_up_s / simulator.period_s());
    for (std::size_t half = 0; half < 2; ++half) {
      const Span span = halves()[half];
      for (std::size_t i = span.begin + std::min(skip, span.size()); i < span.end; ++i) {
        count_[c][half] += simulator.explains(static_cast<Channel>(c), i) ? 1 : 0;
      }
    }
  }
}

double Bench::rms_of(double squares, std::size_t channel) const noexcept {
  return std::sqrt(squares / static_cast<double>(std::max<std::size_t>(count_[channel][0] + count_[channel][1], 1)));
}

double Bench::rms_of_half(double squares, std::size_t half, std::size_t channel) const noexcept {
  return std::sqrt(squares / static_cast<double>(std::max<std::size_t>(count_[channel][half], 1)));
}

std::array<Span, 2> Bench::halves() const noexcept {
  return {Span{0, simulator_.size() / 2}, Span{simulator_.size() / 2, simulator_.size()}};
}

ChannelMask Bench::closure(ChannelMask mask, const std::vector<Model::Effect>& effects) const noexcept {
  for (int pass = 0; pass < 2; ++pass) {
    for (const Model::Effect& effect : effects) {
      if (const ChannelMask mine = simulator_.channels(effect.id); meet(mask, mine)) {
        mask = either_of(mask, mine);
      }
    }
  }
  return mask;
}

ChannelMask Bench::closure_of(const std::vector<plant::EffectId>& added, const Hypothesis& from) const noexcept {
  ChannelMask shows{};
  for (const plant::EffectId id : added) {
    shows = either_of(shows, simulator_.channels(id));
  }
  return closure(shows, from.halves[0].model.effects);
}

FitResult Bench::fit_half(const Hypothesis& from, std::size_t half, const Model& start, const ChannelMask& mask,
                          bool bent) const {
  FitResult result = fit(beside(from), halves()[half], start, mask, options_);
  const ChannelMask load = closure({false, true, false}, start.effects);
  if (bent && !load[static_cast<std::size_t>(Channel::kForce)]) {
    result.model = fit(beside(from), halves()[half], result.model, load, options_).model;
  }
  return result;
}

Model Bench::start_of_other(const Model& fitted, const Model& own, const ChannelMask& mask) const {
  Model start = fitted;
  const std::vector<FreeNumber> free = simulator_.free_numbers(own, mask, options_.nominal_spread);
  Model kept = own;
  std::size_t count = kNominals;
  for (const Model::Effect& effect : own.effects) {
    count += effect.fitted.size();
  }
  for (std::size_t place = 0; place < count; ++place) {
    if (std::ranges::find(free, place, &FreeNumber::place) == free.end()) {
      number_at(start, place) = number_at(kept, place);
    }
  }
  return start;
}

std::vector<double> Bench::block_squares(const Model& model, std::size_t half, std::size_t channel) const {
  const auto block = static_cast<std::size_t>(options_.block_s / simulator_.period_s());
  const auto error = residuals(simulator_, halves()[half], model, static_cast<Channel>(channel), options_);
  std::vector<double> squares;
  for (std::size_t from = 0; from + block <= error.size(); from += block) {
    double sum = 0.0;
    for (std::size_t i = from; i < from + block; ++i) {
      sum += error[i] * error[i];
    }
    squares.push_back(std::isfinite(sum) ? std::min(sum, kDiverged) : kDiverged);
  }
  return squares;
}

void Bench::judge(Hypothesis& hypothesis, const Hypothesis* like, const ChannelMask& changed) const {
  for (std::size_t c = 0; c < kChannels; ++c) {
    // The valve's motion within a period bends the force on the load.
    const bool moved = changed[c] || (c == static_cast<std::size_t>(Channel::kMotion) && changed[0]);
    if (like != nullptr && !moved) {
      hypothesis.squares[c] = like->squares[c];
      hypothesis.fitted_squares[c] = like->fitted_squares[c];
      hypothesis.weight[c] = like->weight[c];
      continue;
    }
    hypothesis.squares[c].clear();
    for (std::size_t half = 0; fit_data_.judged[c] && half < 2; ++half) {
      const auto squares = block_squares(hypothesis.halves[1 - half].model, half, c);
      hypothesis.squares[c].insert(hypothesis.squares[c].end(), squares.begin(), squares.end());
      hypothesis.fitted_squares[c][half] = fitted_square(hypothesis, half, c);
    }
    const auto& own = hypothesis.fitted_squares[c];
    hypothesis.weight[c] = std::max(rms_of(own[0] + own[1], c), 1e-12);
  }
}

double Bench::fitted_square(const Hypothesis& hypothesis, std::size_t half, std::size_t channel) const {
  const auto fitted = block_squares(hypothesis.halves[half].model, half, channel);
  return std::accumulate(fitted.begin(), fitted.end(), 1e-300);
}

double Bench::promise(const Hypothesis& from, const Model& model, const ChannelMask& mask) const {
  double gain = 0.0;
  for (std::size_t c = 0; c < kChannels; ++c) {
    if (mask[c] && fit_data_.judged[c]) {
      const auto now = block_squares(model, 1, c);
      const auto& before = from.squares[c];
      const double was = std::accumulate(before.end() - std::ssize(now), before.end(), 1e-300);
      gain += 0.5 * std::log(was / std::accumulate(now.begin(), now.end(), 1e-300));
    }
  }
  return gain;
}

double Bench::fitted_gain(const Hypothesis& from, const Hypothesis& with, const ChannelMask& mask) const {
  std::array<double, 2> gain{};
  for (std::size_t half = 0; half < 2; ++half) {
    for (std::size_t c = 0; c < kChannels; ++c) {
      if (mask[c] && fit_data_.judged[c]) {
        gain[half] += 0.5 * std::log(from.fitted_squares[c][half] / with.fitted_squares[c][half]);
      }
    }
  }
  return std::min(gain[0], gain[1]);
}

Hypothesis Bench::base() const {
  Hypothesis base;
  for (std::size_t half = 0; half < 2; ++half) {
    base.halves[half] = fit(fit_data_, halves()[half], simulator_.nominal(), {true, true, true}, options_);
  }
  judge(base, nullptr, {true, true, true});
  return refined(base);
}

Hypothesis Bench::refined(const Hypothesis& from) const {
  Hypothesis again;
  again.effects = from.effects;
  for (std::size_t half = 0; half < 2; ++half) {
    again.halves[half] = fit(beside(from), halves()[half], from.halves[half].model, {true, true, true}, options_);
  }
  judge(again, nullptr, {true, true, true});
  return gain(from, again).log_ratio < -kNoWorse ? from : again;
}

}  // namespace farrier::diagnosis
