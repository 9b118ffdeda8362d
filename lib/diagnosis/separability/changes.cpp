#include "diagnosis/separability/changes.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include <Eigen/Cholesky>

#include "diagnosis/judge/linearised.hpp"

namespace farrier::diagnosis {
namespace {

/// Least share of what is known of a number that no combination of others can take away: keeps a matrix invertible.
constexpr double kLeastShare = 1e-9;

/// Simulations with derivatives on the way to a settled remainder.
constexpr int kSettlingSteps = 3;

ChannelMask united(ChannelMask one, const ChannelMask& other) {
  for (std::size_t c = 0; c < kChannels; ++c) {
    one[c] = one[c] || other[c];
  }
  return one;
}

ChannelMask channels_of(const Simulator& simulator, const AddedEffects& added) {
  ChannelMask all{};
  for (const Model::Effect& effect : added) {
    all = united(all, simulator.channels(effect.id));
  }
  return all;
}

/// True if a place among a model's numbers is one of the effect `id`.
bool belongs_to(std::size_t place, plant::EffectId id, const Model& model) {
  std::size_t first = kNominals;
  for (const Model::Effect& effect : model.effects) {
    if (effect.id == id) {
      return place >= first && place < first + effect.fitted.size();
    }
    first += effect.fitted.size();
  }
  return false;
}

}  // namespace

double Changes::Left::largest() const noexcept { return *std::ranges::max_element(rms); }

Changes::Changes(const Bench& bench, const Model& reference, const std::array<double, kChannels>& unit,
                 const std::vector<AddedEffects>& targets, const std::vector<plant::EffectId>& others,
                 const ForEach& for_each)
    : bench_(bench),
      reference_(reference),
      unit_(unit),
      own_(bench.simulator().free_numbers(reference, bench.fit_data().judged, bench.options().nominal_spread)),
      columns_(std::ssize(own_)) {
  const Simulator& simulator = bench.simulator();
  const ChannelMask& judged = bench.fit_data().judged;
  for (const plant::EffectId id : others) {
    if (meet(simulator.channels(id), judged) && !reference.has(id) && simulator.known(id) == nullptr) {
      for (const auto& start : simulator.starts(id)) {
        starts_[id].push_back(place_of({{id, start}}));
      }
    }
  }
  for (const AddedEffects& target : targets) {
    targets_.push_back(place_of(target));
  }
  for (std::size_t c = 0; c < kChannels; ++c) {
    if (judged[c]) {
      unit_[c] = std::max(unit_[c], 1e-12);
      simulate(c, for_each);
    }
  }
}

std::size_t Changes::place_of(const AddedEffects& added) {
  const auto same = [](const Model::Effect& a, const Model::Effect& b) { return a.id == b.id && a.fitted == b.fitted; };
  const auto known =
      std::ranges::find_if(responses_, [&](const Response& one) { return std::ranges::equal(one.added, added, same); });
  if (known == responses_.end()) {
    const Simulator& simulator = bench_.simulator();
    const ChannelMask shows = channels_of(simulator, added);
    responses_.push_back({added, shows, columns_, numbers_of_last_effect(simulator, with(added), shows)});
    columns_ += 1 + std::ssize(responses_.back().free);
    return responses_.size() - 1;
  }
  return static_cast<std::size_t>(known - responses_.begin());
}

Model Changes::with(const AddedEffects& added) const {
  Model with = reference_;
  with.effects.insert(with.effects.end(), added.begin(), added.end());
  return with;
}

void Changes::simulate(std::size_t channel, const ForEach& for_each) {
  const double unit = unit_[channel];
  const Span all{0, bench_.simulator().size()};
  const auto as_channel = static_cast<Channel>(channel);
  const Linearised own = linearised(bench_.simulator(), bench_.options(), all, reference_, as_channel, own_, unit);
  Eigen::MatrixXd changes = Eigen::MatrixXd::Zero(own.residual.size(), columns_);
  changes.leftCols(own.slope.cols()) = own.slope;
  for_each(responses_.size(), [&](std::size_t i) {
    const Response& response = responses_[i];
    if (response.shows[channel]) {
      const Linearised mine =
          linearised(bench_.simulator(), bench_.options(), all, with(response.added), as_channel, response.free, unit);
      if (mine.residual.allFinite() && mine.slope.allFinite()) {
        changes.col(response.change) = own.residual - mine.residual;
        changes.middleCols(response.change + 1, mine.slope.cols()) = mine.slope;
      }
    }
  });
  residuals_[channel].resize(changes.rows(), std::ssize(targets_));
  for (std::size_t i = 0; i < targets_.size(); ++i) {
    residuals_[channel].col(static_cast<Eigen::Index>(i)) = own.residual - changes.col(responses_[targets_[i]].change);
  }
  products_[channel] = changes.transpose() * changes;
  count_[channel] = static_cast<double>((own.residual.array() != 0.0).count());
}

ChannelMask Changes::concerned(const ChannelMask& shows) const {
  ChannelMask all = bench_.closure(shows, reference_.effects);
  for (std::size_t c = 0; c < kChannels; ++c) {
    all[c] = all[c] && bench_.fit_data().judged[c];
  }
  return all;
}

Eigen::MatrixXd Changes::facts(const ChannelMask& channels, const std::vector<Eigen::Index>& rows,
                               const std::vector<Eigen::Index>& columns) const {
  Eigen::MatrixXd sum = Eigen::MatrixXd::Zero(std::ssize(rows), std::ssize(columns));
  for (std::size_t c = 0; c < kChannels; ++c) {
    if (channels[c]) {
      sum += products_[c](rows, columns) / bench_.options().samples_per_fact;
    }
  }
  return sum;
}

Changes::Left Changes::left_of(const Response& target, const Response* other,
                               const std::vector<plant::EffectId>& held) const {
  std::vector<Eigen::Index> columns;
  std::vector<FreeNumber> free;
  for (std::size_t i = 0; i < own_.size(); ++i) {
    const auto holds = [&](plant::EffectId id) { return belongs_to(own_[i].place, id, reference_); };
    if (std::ranges::none_of(held, holds)) {
      columns.push_back(static_cast<Eigen::Index>(i));
      free.push_back(own_[i]);
    }
  }
  ChannelMask shows = target.shows;
  // Coefficients of the columns that make up what is to be followed, and then what is left of it.
  Eigen::VectorXd part = Eigen::VectorXd::Zero(columns_);
  part[target.change] = 1.0;
  if (other != nullptr) {
    part[other->change] = -1.0;
    for (std::size_t i = 0; i < other->free.size(); ++i) {
      columns.push_back(other->change + 1 + static_cast<Eigen::Index>(i));
    }
    free.insert(free.end(), other->free.begin(), other->free.end());
    shows = united(shows, other->shows);
  }
  const ChannelMask channels = concerned(shows);
  std::vector<Eigen::Index> all(static_cast<std::size_t>(columns_));
  std::iota(all.begin(), all.end(), Eigen::Index{0});
  Left left{.rms = {}, .follower = other != nullptr ? with(other->added) : reference_};
  const Eigen::VectorXd step =
      bounded_step(facts(channels, columns, columns), facts(channels, columns, all) * part, free, left.follower);
  part(columns) -= step;
  for (std::size_t i = 0; i < free.size(); ++i) {
    number_at(left.follower, free[i].place) += step[static_cast<Eigen::Index>(i)];
  }
  for (std::size_t c = 0; c < kChannels; ++c) {
    if (channels[c] && count_[c] > 0.0) {
      left.rms[c] = std::sqrt(std::max(0.0, part.dot(products_[c] * part)) / count_[c]);
    }
  }
  return left;
}

Changes::Left Changes::left_of(std::size_t target, const std::vector<plant::EffectId>& held) const {
  return left_of(responses_[targets_[target]], nullptr, held);
}

std::optional<Changes::Left> Changes::left_beside(std::size_t target, plant::EffectId other) const {
  const Response& mine = responses_[targets_[target]];
  std::optional<Left> best;
  for (const std::size_t start : starts_[other]) {
    if (meet(responses_[start].shows, mine.shows)) {
      Left left = left_of(mine, &responses_[start], {});
      if (!best || left.largest() < best->largest()) {
        best = std::move(left);
      }
    }
  }
  return best;
}

Changes::Left Changes::settled(std::size_t target, const Left& linear) const {
  const Span all{0, bench_.simulator().size()};
  ChannelMask shows = responses_[targets_[target]].shows;
  if (linear.follower.effects.size() > reference_.effects.size()) {
    shows = united(shows, bench_.simulator().channels(linear.follower.effects.back().id));
  }
  const ChannelMask channels = concerned(shows);
  Left best = linear;
  Model model = linear.follower;
  for (int i = 0; i < kSettlingSteps; ++i) {
    const std::vector<FreeNumber> free =
        bench_.simulator().free_numbers(model, channels, bench_.options().nominal_spread);
    Eigen::MatrixXd normal = Eigen::MatrixXd::Zero(std::ssize(free), std::ssize(free));
    Eigen::VectorXd descent = Eigen::VectorXd::Zero(std::ssize(free));
    Left left{.rms = {}, .follower = model};
    for (std::size_t c = 0; c < kChannels; ++c) {
      if (channels[c] && count_[c] > 0.0) {
        const Linearised now =
            linearised(bench_.simulator(), bench_.options(), all, model, static_cast<Channel>(c), free, unit_[c]);
        const Eigen::VectorXd apart = now.residual - residuals_[c].col(static_cast<Eigen::Index>(target));
        left.rms[c] = std::sqrt(apart.squaredNorm() / count_[c]);
        normal += now.slope.transpose() * now.slope / bench_.options().samples_per_fact;
        descent += now.slope.transpose() * apart / bench_.options().samples_per_fact;
      }
    }
    if (!normal.allFinite() || !descent.allFinite() || (i > 0 && left.largest() >= best.largest())) {
      break;
    }
    best = std::move(left);
    for (std::size_t k = 0; k < free.size(); ++k) {
      const double spread = free[k].spread;
      descent[static_cast<Eigen::Index>(k)] +=
          spread > 0.0 ? (free[k].prior - number_at(model, free[k].place)) / (spread * spread) : 0.0;
    }
    const Eigen::VectorXd step = bounded_step(normal, descent, free, model);
    for (std::size_t k = 0; k < free.size(); ++k) {
      number_at(model, free[k].place) += step[static_cast<Eigen::Index>(k)];
    }
  }
  return best;
}

double Changes::deviation_of(std::size_t target) const {
  const Response& mine = responses_[targets_[target]];
  const Simulator& simulator = bench_.simulator();
  const ChannelMask channels = concerned(mine.shows);
  std::size_t first = kNominals;
  const Model model = with(mine.added);
  for (std::size_t i = 0; i + 1 < model.effects.size(); ++i) {
    first += model.effects[i].fitted.size();
  }
  // A constant whose place the effect takes is free in the reference alone.
  const std::vector<FreeNumber> free = simulator.free_numbers(model, channels, bench_.options().nominal_spread);
  std::vector<Eigen::Index> columns;
  std::vector<double> spreads;
  Eigen::Index asked = -1;
  const auto add = [&](const FreeNumber& number, Eigen::Index column) {
    if (std::ranges::find(free, number.place, &FreeNumber::place) != free.end()) {
      asked = number.place == first ? std::ssize(columns) : asked;
      columns.push_back(column);
      spreads.push_back(number.spread);
    }
  };
  for (std::size_t i = 0; i < own_.size(); ++i) {
    add(own_[i], static_cast<Eigen::Index>(i));
  }
  for (std::size_t i = 0; i < mine.free.size(); ++i) {
    add(mine.free[i], mine.change + 1 + static_cast<Eigen::Index>(i));
  }
  if (asked < 0) {
    return std::numeric_limits<double>::infinity();
  }
  Eigen::MatrixXd normal = facts(channels, columns, columns);
  for (std::size_t i = 0; i < spreads.size(); ++i) {
    const auto k = static_cast<Eigen::Index>(i);
    normal(k, k) += spreads[i] > 0.0 ? 1.0 / (spreads[i] * spreads[i]) : 0.0;
  }
  // In units of each number's own deviation, so that numbers of any size are of one order.
  const Eigen::VectorXd unit = normal.diagonal().cwiseMax(1e-300).cwiseSqrt().cwiseInverse();
  normal = unit.asDiagonal() * normal * unit.asDiagonal();
  normal.diagonal().array() += kLeastShare;
  const Eigen::VectorXd variance = normal.ldlt().solve(Eigen::VectorXd::Unit(normal.rows(), asked));
  return unit[asked] * std::sqrt(std::max(0.0, variance[asked]));
}

}  // namespace farrier::diagnosis
