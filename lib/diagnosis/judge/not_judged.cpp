#include "diagnosis/judge/not_judged.hpp"

#include <algorithm>
#include <cmath>

#include "diagnosis/separability/separability.hpp"

namespace farrier::diagnosis {
namespace {

double rms_between(const std::vector<double>& a, const std::vector<double>& b) {
  double sum = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    sum += (a[i] - b[i]) * (a[i] - b[i]);
  }
  return std::sqrt(sum / static_cast<double>(a.size()));
}

}  // namespace

std::vector<plant::EffectId> not_judged(const Bench& bench, const Model& model,
                                        const std::array<Remainder, kChannels>& left, double least_reduction) {
  const Simulator& simulator = bench.simulator();
  const Span all{0, simulator.size()};
  std::array<std::vector<double>, kChannels> without;
  for (std::size_t c = 0; c < kChannels; ++c) {
    if (bench.fit_data().judged[c]) {
      without[c] = residuals(simulator, all, model, static_cast<Channel>(c), bench.options());
    }
  }
  const double visible = visible_beside_noise(least_reduction);
  std::vector<plant::EffectId> hidden;
  for (plant::EffectId id = 0; id < plant::kNameableCount; ++id) {
    const ChannelMask mine = simulator.channels(id);
    if (!meet(mine, mine) || model.has(id) || simulator.known(id) != nullptr) {
      continue;
    }
    Model with = model;
    with.effects.push_back({id, usual_size(simulator, id)});
    bool shows = false;
    for (std::size_t c = 0; c < kChannels && !shows && !with.effects.back().fitted.empty(); ++c) {
      shows = mine[c] && bench.fit_data().judged[c] &&
              rms_between(residuals(simulator, all, with, static_cast<Channel>(c), bench.options()), without[c]) >
                  visible * std::max(left[c].rms, left[c].expected);
    }
    if (!shows) {
      hidden.push_back(id);
    }
  }
  return hidden;
}

}  // namespace farrier::diagnosis
