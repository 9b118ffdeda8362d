#include "diagnosis/judge/separability.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "diagnosis/judge/fit_costs.hpp"
#include "diagnosis/judge/linearised.hpp"

namespace farrier::diagnosis {
namespace {

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
  Response placed(const std::vector<double>& numbers, Eigen::Index& columns, plant::EffectId id) const;

  const Bench& bench_;
  const Model& model_;
  std::vector<FreeNumber> own_;
  std::vector<EffectResponses> effects_;
  Eigen::Index column_count_ = 0;
  std::array<Eigen::MatrixXd, kChannels> products_;
  std::array<double, kChannels> count_{};
};

Response Changes::placed(const std::vector<double>& numbers, Eigen::Index& columns, plant::EffectId id) const {
  Model with = model_;
  with.effects.push_back({id, numbers});
  const Simulator& simulator = bench_.simulator();
  Response response{.numbers = numbers,
                    .change = columns,
                    .slopes = columns + 1,
                    .free = numbers_of_last_effect(simulator, with, simulator.channels(id))};
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
  column_count_ = columns;
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
  std::vector<Eigen::Index> columns(own_.size());
  std::iota(columns.begin(), columns.end(), Eigen::Index{0});
  std::vector<FreeNumber> free = own_;
  Model with = model_;
  if (start != nullptr) {
    for (std::size_t i = 0; i < start->free.size(); ++i) {
      columns.push_back(start->slopes + static_cast<Eigen::Index>(i));
    }
    free.insert(free.end(), start->free.begin(), start->free.end());
    with.effects.push_back({other->id, start->numbers});
  }
  const ChannelMask& judged = bench_.fit_data().judged;
  const auto concerns = [&](std::size_t c) {
    return judged[c] && (target.shows[c] || (other != nullptr && other->shows[c]));
  };
  // Coefficients of the columns that make up what is to be followed, and then what is left of it.
  Eigen::VectorXd part = Eigen::VectorXd::Zero(column_count_);
  part[target.usual.change] = 1.0;
  if (start != nullptr) {
    part[start->change] = -1.0;
  }
  const Eigen::Index count = std::ssize(columns);
  Eigen::MatrixXd normal = Eigen::MatrixXd::Zero(count, count);
  Eigen::VectorXd descent = Eigen::VectorXd::Zero(count);
  for (std::size_t c = 0; c < kChannels; ++c) {
    if (concerns(c)) {
      const double weight = 1.0 / bench_.options().samples_per_fact;
      normal += weight * products_[c](columns, columns);
      descent += weight * products_[c](columns, Eigen::all) * part;
    }
  }
  const Eigen::VectorXd step = bounded_step(std::move(normal), descent, free, with);
  part(columns) -= step;
  for (std::size_t i = own_.size(); i < free.size(); ++i) {
    number_at(with, free[i].place) += step[static_cast<Eigen::Index>(i)];
  }
  Left left{0.0, start != nullptr ? with.effects.back().fitted : std::vector<double>()};
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
