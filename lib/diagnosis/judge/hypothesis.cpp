#include "diagnosis/judge/hypothesis.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "core/noise.hpp"
#include "diagnosis/data/sample_statistics.hpp"

namespace farrier::diagnosis {
namespace {

constexpr int kResamplings = 400;

}  // namespace

double Hypothesis::total(std::size_t channel) const noexcept {
  return std::accumulate(squares[channel].begin(), squares[channel].end(), 0.0);
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
    for (const Span half : halves()) {
      for (std::size_t i = half.begin + std::min(skip, half.size()); i < half.end; ++i) {
        count_[c] += simulator.explains(static_cast<Channel>(c), i) ? 1 : 0;
      }
    }
  }
}

double Bench::rms_of(double squares, std::size_t channel) const noexcept {
  return std::sqrt(squares / static_cast<double>(std::max<std::size_t>(count_[channel], 1)));
}

std::array<Span, 2> Bench::halves() const noexcept {
  return {Span{0, simulator_.size() / 2}, Span{simulator_.size() / 2, simulator_.size()}};
}

ChannelMask Bench::closure(ChannelMask mask, const std::vector<Model::Effect>& effects) const noexcept {
  for (int pass = 0; pass < 2; ++pass) {
    for (const Model::Effect& effect : effects) {
      const ChannelMask mine = simulator_.channels(effect.id);
      if (meet(mask, mine)) {
        for (std::size_t c = 0; c < kChannels; ++c) {
          mask[c] = mask[c] || mine[c];
        }
      }
    }
  }
  return mask;
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
    squares.push_back(sum);
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
      const auto fitted = block_squares(hypothesis.halves[half].model, half, c);
      hypothesis.fitted_squares[c][half] = std::accumulate(fitted.begin(), fitted.end(), 1e-300);
    }
    const auto& own = hypothesis.fitted_squares[c];
    hypothesis.weight[c] = std::max(rms_of(own[0] + own[1], c), 1e-12);
  }
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
  return again;
}

std::optional<Bench::Sketch> Bench::sketch(const Hypothesis& from, plant::EffectId effect,
                                           const std::vector<std::vector<double>>& starts) const {
  const ChannelMask mask = closure(simulator_.channels(effect), from.halves[0].model.effects);
  FitOptions quick = options_;
  quick.most_iterations = 6;
  quick.tolerance = 1e-2;
  std::optional<FitResult> best;
  for (const auto& start : starts) {
    Model model = from.halves[0].model;
    model.effects.push_back({effect, start});
    FitResult found = fit(beside(from), halves()[0], model, mask, quick);
    if (!best || found.cost < best->cost) {
      best = std::move(found);
    }
  }
  if (!best) {
    return std::nullopt;
  }
  const double promised = promise(from, best->model, mask);
  return Sketch{effect, std::move(best->model), promised};
}

std::optional<Hypothesis> Bench::with(const Hypothesis& from, const Sketch& sketch, double least_gain) const {
  if (sketch.promise < least_gain) {
    return std::nullopt;
  }
  const ChannelMask mask = closure(simulator_.channels(sketch.effect), from.halves[0].model.effects);
  Hypothesis with;
  with.effects = from.effects;
  with.effects.push_back(sketch.effect);
  with.halves[0] = fit(beside(from), halves()[0], sketch.model, mask, options_);
  with.halves[1] = fit(beside(from), halves()[1], with.halves[0].model, mask, options_);
  judge(with, &from, mask);
  return fitted_gain(from, with, mask) < least_gain ? std::nullopt : std::optional(std::move(with));
}

Hypothesis Bench::without(const Hypothesis& from, plant::EffectId effect) const {
  Hypothesis less;
  std::ranges::copy_if(from.effects, std::back_inserter(less.effects), [effect](auto id) { return id != effect; });
  const ChannelMask mask = closure(simulator_.channels(effect), from.halves[0].model.effects);
  for (std::size_t half = 0; half < 2; ++half) {
    Model model = from.halves[half].model;
    std::erase_if(model.effects, [effect](const auto& e) { return e.id == effect; });
    less.halves[half] = fit(beside(from), halves()[half], model, mask, options_);
  }
  judge(less, &from, mask);
  return less;
}

Hypothesis Bench::exchanged(const Hypothesis& from, plant::EffectId effect, plant::EffectId other,
                            const std::array<std::vector<double>, 2>& fitted) const {
  Hypothesis changed;
  std::ranges::copy_if(from.effects, std::back_inserter(changed.effects), [effect](auto id) { return id != effect; });
  changed.effects.push_back(other);
  const auto& effects = from.halves[0].model.effects;
  const ChannelMask was = simulator_.channels(effect);
  ChannelMask mask = simulator_.channels(other);
  for (std::size_t c = 0; c < kChannels; ++c) {
    mask[c] = mask[c] || was[c];
  }
  mask = closure(mask, effects);
  for (std::size_t half = 0; half < 2; ++half) {
    Model model = from.halves[half].model;
    std::erase_if(model.effects, [effect](const auto& e) { return e.id == effect; });
    model.effects.push_back({other, fitted[half]});
    changed.halves[half] = fit(beside(from), halves()[half], model, mask, options_);
  }
  judge(changed, &from, mask);
  return changed;
}

Gain Bench::gain(const Hypothesis& before, const Hypothesis& after) const {
  Gain gain{};
  std::size_t blocks = 0;
  for (std::size_t c = 0; c < kChannels; ++c) {
    blocks = std::max(blocks, before.squares[c].size());
  }
  const auto over = [&](auto&& index_of, std::size_t count) {
    double sum = 0.0;
    for (std::size_t c = 0; c < kChannels; ++c) {
      if (before.squares[c].empty()) {
        continue;
      }
      double was = 1e-300;
      double is = 1e-300;
      for (std::size_t i = 0; i < count; ++i) {
        was += before.squares[c][index_of(i)];
        is += after.squares[c][index_of(i)];
      }
      sum += 0.5 * std::log(was / is);
    }
    return sum;
  };
  gain.log_ratio = over([](std::size_t i) { return i; }, blocks);
  gain.by_half = {over([](std::size_t i) { return i; }, blocks / 2),
                  over([&](std::size_t i) { return blocks / 2 + i; }, blocks - blocks / 2)};
  for (std::size_t c = 0; c < kChannels; ++c) {
    const double was = before.total(c);
    gain.reduction[c] = was > 0.0 ? 1.0 - std::sqrt(after.total(c) / was) : 0.0;
  }
  const NoiseStream draws(1, "diagnosis", "bootstrap");
  std::vector<double> samples;
  for (int r = 0; r < kResamplings; ++r) {
    const auto drawn = [&](std::size_t i) {
      return static_cast<std::size_t>(draws.uniform(static_cast<Tick>(r) * 100000 + static_cast<Tick>(i)) *
                                      static_cast<double>(blocks));
    };
    samples.push_back(over(drawn, blocks));
  }
  std::ranges::sort(samples);
  gain.low = samples[kResamplings / 40];
  gain.high = samples[kResamplings - 1 - kResamplings / 40];
  gain.chance = static_cast<double>(std::ranges::count_if(samples, [](double s) { return s > 0.0; })) / kResamplings;
  return gain;
}

ErrorRatio Bench::error_ratio(const Hypothesis& before, const Hypothesis& after) const {
  std::size_t blocks = 0;
  std::array<double, kChannels> weight{};
  for (std::size_t c = 0; c < kChannels; ++c) {
    blocks = std::max(blocks, before.squares[c].size());
    if (fit_data_.judged[c]) {
      const std::vector<double>& values = simulator_.measured(static_cast<Channel>(c));
      const double deviation = standard_deviation(values);
      weight[c] = 1.0 / std::max(deviation * deviation * static_cast<double>(values.size()), 1e-300);
    }
  }
  const auto error = [&](const Hypothesis& hypothesis, const std::vector<std::size_t>& drawn) {
    double sum = 0.0;
    for (std::size_t c = 0; c < kChannels; ++c) {
      for (const std::size_t i : drawn) {
        sum += i < hypothesis.squares[c].size() ? weight[c] * hypothesis.squares[c][i] : 0.0;
      }
    }
    return std::sqrt(sum / static_cast<double>(std::ranges::count(fit_data_.judged, true)));
  };
  std::vector<std::size_t> drawn(blocks);
  std::iota(drawn.begin(), drawn.end(), std::size_t{0});
  ErrorRatio ratio{error(before, drawn), error(after, drawn), 1.0, 1.0};
  const NoiseStream draws(1, "diagnosis", "ratio");
  std::vector<double> samples;
  for (int r = 0; r < kResamplings; ++r) {
    for (std::size_t i = 0; i < blocks; ++i) {
      const Tick number = static_cast<Tick>(r) * static_cast<Tick>(blocks) + static_cast<Tick>(i);
      drawn[i] = static_cast<std::size_t>(draws.uniform(number) * static_cast<double>(blocks));
    }
    samples.push_back(error(before, drawn) / std::max(error(after, drawn), 1e-300));
  }
  std::ranges::sort(samples);
  ratio.low = samples[kResamplings / 40];
  ratio.high = samples[kResamplings - 1 - kResamplings / 40];
  return ratio;
}

}  // namespace farrier::diagnosis
