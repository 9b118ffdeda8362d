#include <algorithm>
#include <iterator>
#include <utility>

#include "diagnosis/judge/hypothesis.hpp"

namespace farrier::diagnosis {
namespace {

/// The effects and models of `from` without one effect.
Hypothesis stripped(const Hypothesis& from, plant::EffectId effect) {
  Hypothesis less = from;
  std::erase(less.effects, effect);
  for (FitResult& half : less.halves) {
    std::erase_if(half.model.effects, [effect](const auto& e) { return e.id == effect; });
  }
  return less;
}

}  // namespace

Bench::Sketch Bench::sketch(const Hypothesis& from, const std::vector<Model::Effect>& start) const {
  FitOptions quick = options_;
  quick.most_iterations = 6;
  quick.tolerance = 1e-2;
  quick.deviations = false;
  Sketch sketch{.added = {}, .model = from.halves[0].model, .cost = 0.0, .promise = 0.0};
  for (const Model::Effect& effect : start) {
    sketch.added.push_back(effect.id);
    sketch.model.effects.push_back(effect);
  }
  const ChannelMask mask = closure_of(sketch.added, from);
  FitResult found = fit(beside(from), halves()[0], sketch.model, mask, quick);
  sketch.model = std::move(found.model);
  sketch.cost = found.cost;
  sketch.promise = promise(from, sketch.model, mask);
  return sketch;
}

std::optional<Bench::Sketch> Bench::sketch(const Hypothesis& from, plant::EffectId effect,
                                           const std::vector<std::vector<double>>& starts) const {
  std::optional<Sketch> best;
  for (const auto& start : starts) {
    Sketch found = sketch(from, {{effect, start}});
    if (!best || found.cost < best->cost) {
      best = std::move(found);
    }
  }
  return best;
}

std::optional<Hypothesis> Bench::with(const Hypothesis& from, const Sketch& sketch, double least_gain) const {
  if (sketch.promise < least_gain) {
    return std::nullopt;
  }
  const ChannelMask mask = closure_of(sketch.added, from);
  Hypothesis with;
  with.effects = from.effects;
  std::ranges::copy(sketch.added, std::back_inserter(with.effects));
  const bool bent = std::ranges::any_of(sketch.added, [this](auto id) { return simulator_.bends_force(id); });
  with.halves[0] = fit_half(from, 0, sketch.model, mask, bent);
  const Model second = start_of_other(with.halves[0].model, from.halves[1].model, mask);
  with.halves[1] = fit_half(from, 1, second, mask, bent);
  judge(with, &from, mask);
  return fitted_gain(from, with, mask) < least_gain ? std::nullopt : std::optional(std::move(with));
}

std::optional<Hypothesis> Bench::with_in_half(const Hypothesis& from, plant::EffectId effect, std::size_t half) const {
  const ChannelMask mask = closure(simulator_.channels(effect), from.halves[0].model.effects);
  std::optional<FitResult> best;
  for (const auto& start : simulator_.starts(effect)) {
    Model model = from.halves[half].model;
    model.effects.push_back({effect, start});
    FitResult found = fit(beside(from), halves()[half], model, mask, options_);
    if (!best || found.cost < best->cost) {
      best = std::move(found);
    }
  }
  if (!best) {
    return std::nullopt;
  }
  Hypothesis with;
  with.effects = from.effects;
  with.effects.push_back(effect);
  const Model::Effect& added = best->model.effects.back();
  FitResult idle = from.halves[1 - half];
  idle.model.effects.push_back(added);
  idle.deviation.insert(idle.deviation.end(), best->deviation.end() - std::ssize(added.fitted), best->deviation.end());
  with.halves[1 - half] = std::move(idle);
  with.halves[half] = std::move(*best);
  judge(with, &from, mask);
  return with;
}

Hypothesis Bench::cut(const Hypothesis& from, plant::EffectId effect) const {
  Hypothesis less = stripped(from, effect);
  judge(less, &from, closure(simulator_.channels(effect), from.halves[0].model.effects));
  less.weight = from.weight;
  return less;
}

Hypothesis Bench::without(const Hypothesis& from, plant::EffectId effect) const {
  Hypothesis less = stripped(from, effect);
  const ChannelMask mask = closure(simulator_.channels(effect), from.halves[0].model.effects);
  for (std::size_t half = 0; half < 2; ++half) {
    less.halves[half] = fit_half(from, half, less.halves[half].model, mask, simulator_.bends_force(effect));
  }
  judge(less, &from, mask);
  return less;
}

Hypothesis Bench::exchanged(const Hypothesis& from, plant::EffectId effect, plant::EffectId other,
                            const std::array<std::vector<double>, 2>& fitted) const {
  Hypothesis changed = stripped(from, effect);
  changed.effects.push_back(other);
  const ChannelMask mask = closure_of({effect, other}, from);
  const bool bent = simulator_.bends_force(effect) || simulator_.bends_force(other);
  for (std::size_t half = 0; half < 2; ++half) {
    Model model = changed.halves[half].model;
    model.effects.push_back({other, fitted[half]});
    changed.halves[half] = fit_half(from, half, model, mask, bent);
  }
  judge(changed, &from, mask);
  return changed;
}

}  // namespace farrier::diagnosis
