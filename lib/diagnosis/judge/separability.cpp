#include "diagnosis/judge/separability.hpp"

#include <algorithm>
#include <cmath>

#include <Eigen/Cholesky>

#include "diagnosis/judge/fit_costs.hpp"
#include "diagnosis/judge/linearised.hpp"

namespace farrier::diagnosis {
namespace {

/// Least diagonal of a normal matrix, over its largest element: numbers that nothing shows stay where they are.
constexpr double kLeastDiagonal = 1e-9;

/// An rms that a change must have, over the noise, so that the rms of both is larger than the noise by this share.
double visible_beside_noise(double share) {
  const double kept = 1.0 - share;
  return std::sqrt(1.0 / (kept * kept) - 1.0);
}

/// Columns, in the matrix of all changes, that an effect with these numbers has.
struct Response {
  std::vector<double> numbers;
  Eigen::Index change = 0;       ///< column of its change
  Eigen::Index slopes = 0;       ///< first column of the derivatives by its numbers
  std::vector<FreeNumber> free;  ///< these numbers
};

struct EffectResponses {
  plant::EffectId id;
  ChannelMask shows;
  Response usual;
  std::vector<Response> starts;
};

/// Products of all changes and derivatives of a recording, from which any least squares problem among them is solved.
class Changes {
 public:
  Changes(const Bench& bench, const Model& model, const std::array<double, kChannels>& expected,
          const ForEach& for_each);

  const std::vector<EffectResponses>& effects() const noexcept { return effects_; }

  struct Left {
    double rms;                   ///< largest of a channel, over the noise
    std::vector<double> numbers;  ///< of the effect that follows
  };
  /// Remainder of a change when the model's constants follow it, and an effect from one of its starts.
  Left left_of(const EffectResponses& target, const EffectResponses* other, const Response* start) const;

 private:
  void add(plant::EffectId id, const std::array<double, kChannels>& expected);
  Response placed(const std::vector<double>& numbers, Eigen::Index& columns, const plant::EffectId id) const;

  const Bench& bench_;
  const Model& model_;
  std::vector<FreeNumber> own_;
  std::vector<EffectResponses> effects_;
  std::array<Eigen::MatrixXd, kChannels> products_;
  std::array<double, kChannels> count_{};
};

Response Changes::placed(const std::vector<double>& numbers, Eigen::Index& columns, const plant::EffectId id) const {
  Model with = model_;
  with.effects.push_back({id, numbers});
  std::size_t first = kNominals;
  for (const Model::Effect& effect : model_.effects) {
    first += effect.fitted.size();
  }
  Response response{.numbers = numbers,
                    .change = columns,
                    .slopes = columns + 1,
                    .free = bench_.simulator().free_numbers(with, bench_.simulator().channels(id), 0.0)};
  std::erase_if(response.free, [&](const FreeNumber& free) { return free.place < first; });
  columns += 1 + std::ssize(response.free);
  return response;
}

Changes::Changes(const Bench& bench, const Model& model, const std::array<double, kChannels>& expected,
                 const ForEach& for_each)
    : bench_(bench),
      model_(model),
      own_(bench.simulator().free_numbers(model, bench.fit_data().judged, bench.options().nominal_spread)) {
  const Simulator& simulator = bench.simulator();
  const ChannelMask& judged = bench.fit_data().judged;
  Eigen::Index columns = std::ssize(own_);
  for (plant::EffectId id = 0; id < plant::kNameableCount; ++id) {
    const auto starts = simulator.starts(id);
    if (starts.empty() || !meet(simulator.channels(id), judged) || model.has(id) || simulator.known(id) != nullptr) {
      continue;
    }
    EffectResponses effect{.id = id, .shows = simulator.channels(id), .usual = {}, .starts = {}};
    effect.usual = placed(usual_size(simulator, id), columns, id);
    for (const auto& start : starts) {
      effect.starts.push_back(placed(start, columns, id));
    }
    effects_.push_back(std::move(effect));
  }
  const Span all{0, simulator.size()};
  for (std::size_t c = 0; c < kChannels; ++c) {
    if (!judged[c]) {
      continue;
    }
    const auto channel = static_cast<Channel>(c);
    const Linearised own = linearised(bench, all, model, channel, own_, expected[c]);
    Eigen::MatrixXd changes = Eigen::MatrixXd::Zero(own.residual.size(), columns);
    changes.leftCols(own.slope.cols()) = own.slope;
    for_each(effects_.size(), [&](std::size_t i) {
      const EffectResponses& effect = effects_[i];
      const auto fill = [&](const Response& response) {
        Model with = model;
        with.effects.push_back({effect.id, response.numbers});
        const Linearised mine = linearised(bench, all, with, channel, response.free, expected[c]);
        if (mine.residual.allFinite() && mine.slope.allFinite()) {
          changes.col(response.change) = own.residual - mine.residual;
          changes.middleCols(response.slopes, mine.slope.cols()) = mine.slope;
        }
      };
      if (effect.shows[c]) {
        fill(effect.usual);
        std::ranges::for_each(effect.starts, fill);
      }
    });
    products_[c] = changes.transpose() * changes;
    count_[c] = static_cast<double>((own.residual.array() != 0.0).count());
  }
}

Changes::Left Changes::left_of(const EffectResponses& target, const EffectResponses* other,
                               const Response* start) const {
  std::vector<Eigen::Index> columns;
  std::vector<const FreeNumber*> free;
  for (std::size_t i = 0; i < own_.size(); ++i) {
    columns.push_back(static_cast<Eigen::Index>(i));
    free.push_back(&own_[i]);
  }
  for (std::size_t i = 0; start != nullptr && i < start->free.size(); ++i) {
    columns.push_back(start->slopes + static_cast<Eigen::Index>(i));
    free.push_back(&start->free[i]);
  }
  Model with = model_;
  if (start != nullptr) {
    with.effects.push_back({other->id, start->numbers});
  }
  const ChannelMask& judged = bench_.fit_data().judged;
  const auto concerns = [&](std::size_t c) {
    return judged[c] && (target.shows[c] || (other != nullptr && other->shows[c]));
  };
  const Eigen::Index count = std::ssize(columns);
  Eigen::MatrixXd normal = Eigen::MatrixXd::Zero(count, count);
  Eigen::VectorXd descent = Eigen::VectorXd::Zero(count);
  for (std::size_t c = 0; c < kChannels; ++c) {
    if (!concerns(c)) {
      continue;
    }
    const double weight = 1.0 / bench_.options().samples_per_fact;
    normal += weight * products_[c](columns, columns);
    descent += weight * products_[c](columns, target.usual.change);
    if (start != nullptr) {
      descent -= weight * products_[c](columns, start->change);
    }
  }
  for (Eigen::Index i = 0; i < count; ++i) {
    const FreeNumber& one = *free[static_cast<std::size_t>(i)];
    if (one.spread > 0.0) {
      normal(i, i) += 1.0 / (one.spread * one.spread);
    }
  }
  normal.diagonal().array() += kLeastDiagonal * std::max(normal.diagonal().maxCoeff(), 1e-300);
  const Eigen::VectorXd step = normal.ldlt().solve(descent);
  // Coefficients of the columns that make up what is left.
  Eigen::VectorXd part = Eigen::VectorXd::Zero(products_[0].size() > 0 ? products_[0].cols() : products_[1].cols());
  part[target.usual.change] += 1.0;
  if (start != nullptr) {
    part[start->change] -= 1.0;
  }
  Left left{0.0, start != nullptr ? start->numbers : std::vector<double>()};
  for (Eigen::Index i = 0; i < count; ++i) {
    const FreeNumber& one = *free[static_cast<std::size_t>(i)];
    const double now = number_at(with, one.place);
    const double moved = std::clamp(now + step[i], one.low, one.high);
    part[columns[static_cast<std::size_t>(i)]] -= moved - now;
    if (static_cast<std::size_t>(i) >= own_.size()) {
      number_at(with, one.place) = moved;
    }
  }
  if (start != nullptr) {
    left.numbers = with.effects.back().fitted;
  }
  for (std::size_t c = 0; c < kChannels; ++c) {
    if (concerns(c) && count_[c] > 0.0) {
      const double squares = std::max(0.0, part.dot(products_[c] * part));
      left.rms = std::max(left.rms, std::sqrt(squares / count_[c]));
    }
  }
  return left;
}

}  // namespace

std::vector<double> usual_size(const Simulator& simulator, plant::EffectId id) {
  const auto starts = simulator.starts(id);
  if (starts.empty()) {
    return {};
  }
  std::vector<double> fitted = starts.front();
  const plant::EffectInfo& info = plant::effect_info(id);
  const double neutral = simulator.scales().neutral(info.parameters[0]);
  if (info.nominal && neutral != 0.0) {
    fitted[0] = 1.2 * neutral;
  }
  return fitted;
}

std::vector<EffectVisibility> effect_visibilities(const Bench& bench, const Model& model,
                                                  const std::array<double, kChannels>& expected, const Rules& rules,
                                                  const ForEach& for_each) {
  const Changes changes(bench, model, expected, for_each);
  const double enough = visible_beside_noise(rules.least_reduction);
  const double clear = visible_beside_noise(rules.clear_lead);
  std::vector<EffectVisibility> all(changes.effects().size());
  for_each(all.size(), [&](std::size_t i) {
    const EffectResponses& effect = changes.effects()[i];
    EffectVisibility& one = all[i];
    one.id = effect.id;
    one.size = effect.usual.numbers;
    one.change = changes.left_of(effect, nullptr, nullptr).rms;
    one.shows = one.change > enough;
    const Simulator& simulator = bench.simulator();
    const double neutral = simulator.scales().neutral(plant::effect_info(effect.id).parameters[0]);
    one.shows_from = neutral + (one.size[0] - neutral) * enough / std::max(one.change, 1e-300);
    for (const EffectResponses& other : changes.effects()) {
      std::optional<LikeEffect> best;
      for (const Response& start : other.starts) {
        const Changes::Left left = changes.left_of(effect, &other, &start);
        if (!best || left.rms < best->left) {
          best = {other.id, left.numbers, left.rms};
        }
      }
      if (one.shows && other.id != effect.id && meet(other.shows, effect.shows) && best && best->left < clear) {
        one.rivals.push_back(std::move(*best));
      }
    }
    std::ranges::sort(one.rivals, {}, &LikeEffect::left);
  });
  return all;
}

}  // namespace farrier::diagnosis
