#include "diagnosis/judge/screening.hpp"

#include <algorithm>
#include <cmath>

namespace farrier::diagnosis {

Screening::Screening(const Bench& bench, const Hypothesis& from)
    : bench_(bench),
      from_(from),
      span_(bench.halves()[0]),
      free_(bench.simulator().free_numbers(from.halves[0].model, bench.fit_data().judged,
                                           bench.options().nominal_spread)) {
  for (std::size_t c = 0; c < kChannels; ++c) {
    if (bench_.fit_data().judged[c]) {
      own_[c] = linearise(from_.halves[0].model, static_cast<Channel>(c), free_);
    }
  }
}

Linearised Screening::linearise(const Model& model, Channel channel, const std::vector<FreeNumber>& free) const {
  const double unit = from_.weight[static_cast<std::size_t>(channel)] * std::sqrt(bench_.options().samples_per_fact);
  return linearised(bench_.simulator(), bench_.options(), span_, model, channel, free, unit);
}

double Screening::predicted_log_ratio(const std::vector<Model::Effect>& effects) const {
  const Simulator& simulator = bench_.simulator();
  const ChannelMask& judged = bench_.fit_data().judged;
  Model with = from_.halves[0].model;
  ChannelMask shows{};
  for (const Model::Effect& effect : effects) {
    with.effects.push_back(effect);
    shows = either_of(shows, simulator.channels(effect.id));
  }
  const ChannelMask concerned = bench_.closure(shows, from_.halves[0].model.effects);
  const std::vector<FreeNumber> added = numbers_of_last_effect(simulator, with, shows, effects.size());
  const Eigen::Index own = std::ssize(free_);
  const Eigen::Index all = own + std::ssize(added);
  std::array<Linearised, kChannels> parts;
  Eigen::MatrixXd normal = Eigen::MatrixXd::Zero(all, all);
  Eigen::VectorXd descent = Eigen::VectorXd::Zero(all);
  for (std::size_t c = 0; c < kChannels; ++c) {
    if (!concerned[c] || !judged[c]) {
      continue;
    }
    parts[c] = shows[c]
                   ? linearise(with, static_cast<Channel>(c), added)
                   : Linearised{own_[c].residual, Eigen::MatrixXd::Zero(own_[c].residual.size(), std::ssize(added))};
    if (!parts[c].residual.allFinite() || !parts[c].slope.allFinite()) {
      return 0.0;
    }
    const Eigen::MatrixXd& mine = own_[c].slope;
    normal.topLeftCorner(own, own) += mine.transpose() * mine;
    normal.topRightCorner(own, std::ssize(added)) += mine.transpose() * parts[c].slope;
    normal.bottomRightCorner(std::ssize(added), std::ssize(added)) += parts[c].slope.transpose() * parts[c].slope;
    descent.head(own) += mine.transpose() * parts[c].residual;
    descent.tail(std::ssize(added)) += parts[c].slope.transpose() * parts[c].residual;
  }
  normal.bottomLeftCorner(std::ssize(added), own) = normal.topRightCorner(own, std::ssize(added)).transpose();
  Model from = from_.halves[0].model;
  for (Eigen::Index i = 0; i < own; ++i) {
    const FreeNumber& free = free_[static_cast<std::size_t>(i)];
    if (free.spread > 0.0) {
      const double weight = 1.0 / (free.spread * free.spread);
      descent[i] += weight * (free.prior - number_at(from, free.place));
    }
  }
  std::vector<FreeNumber> free = free_;
  free.insert(free.end(), added.begin(), added.end());
  const Eigen::VectorXd step = bounded_step(std::move(normal), descent, free, with);
  double log_ratio = 0.0;
  for (std::size_t c = 0; c < kChannels; ++c) {
    if (concerned[c] && judged[c]) {
      const Eigen::VectorXd left =
          parts[c].residual - own_[c].slope * step.head(own) - parts[c].slope * step.tail(std::ssize(added));
      log_ratio += 0.5 * std::log((own_[c].residual.squaredNorm() + 1e-300) / (left.squaredNorm() + 1e-300));
    }
  }
  return log_ratio;
}

Screening::Promise Screening::promise_of(plant::EffectId effect) const {
  Promise best;
  for (const auto& start : bench_.simulator().starts(effect)) {
    const double log_ratio = predicted_log_ratio({{effect, start}});
    if (best.start.empty() || log_ratio > best.log_ratio) {
      best = {start, log_ratio};
    }
  }
  return best;
}

Screening::PairPromise Screening::promise_of(plant::EffectId one, plant::EffectId other) const {
  PairPromise best;
  for (const auto& first : bench_.simulator().starts(one)) {
    for (const auto& second : bench_.simulator().starts(other)) {
      std::vector<Model::Effect> start{{one, first}, {other, second}};
      const double log_ratio = predicted_log_ratio(start);
      if (best.start.empty() || log_ratio > best.log_ratio) {
        best = {std::move(start), log_ratio};
      }
    }
  }
  return best;
}

}  // namespace farrier::diagnosis
