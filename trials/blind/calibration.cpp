#include "trials/blind/calibration.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>

#include "core/noise.hpp"
#include "core/number_as.hpp"
#include "core/wilson.hpp"
#include "trials/blind/score.hpp"

namespace farrier::blind {
namespace {

using diagnosis::kEvidences;
using Certainties = std::array<double, kEvidences>;

constexpr std::size_t kBins = 10;
constexpr Tick kDraws = 1000;
constexpr double kDeviationsOf95 = 1.96;
constexpr int kSweeps = 2000;

/// Mean over statements, in the order of their confidence, of how far each tenth is off.
template <class Right>
double calibration_error(const std::vector<Statement>& sorted, Right right) {
  double error = 0.0;
  for (std::size_t bin = 0; bin < kBins; ++bin) {
    double apart = 0.0;
    for (std::size_t i = bin * sorted.size() / kBins; i < (bin + 1) * sorted.size() / kBins; ++i) {
      apart += sorted[i].confidence - (right(i) ? 1.0 : 0.0);
    }
    error += std::abs(apart);
  }
  return error / static_cast<double>(sorted.size());
}

/// Names with what speaks for them.
struct Example {
  Certainties certain;
  double right;
};

std::vector<Example> examples_of(const std::vector<Outcome>& outcomes) {
  std::vector<Example> examples;
  for (const Outcome& outcome : outcomes) {
    for (const Named& named : outcome.named) {
      examples.push_back({diagnosis::certainties(named.evidence), hides(outcome, named.name) ? 1.0 : 0.0});
    }
  }
  return examples;
}

/// Means and deviations of certainties, by which a ridge treats them alike.
struct Standard {
  Certainties mean{}, deviation{};

  explicit Standard(const std::vector<Example>& examples) {
    const auto count = static_cast<double>(examples.size());
    for (std::size_t j = 0; j < kEvidences; ++j) {
      for (const Example& one : examples) {
        mean[j] += one.certain[j] / count;
      }
      for (const Example& one : examples) {
        deviation[j] += (one.certain[j] - mean[j]) * (one.certain[j] - mean[j]) / count;
      }
      deviation[j] = std::sqrt(deviation[j]);
    }
  }
};

/// Logistic regression by Newton steps along one weight at a time. `ridge` counts as statements.
diagnosis::ConfidenceMap logistic(std::vector<Example> examples, double ridge) {
  const Standard standard(examples);
  for (Example& one : examples) {
    for (std::size_t j = 0; j < kEvidences; ++j) {
      one.certain[j] = standard.deviation[j] > 0.0 ? (one.certain[j] - standard.mean[j]) / standard.deviation[j] : 0.0;
    }
  }
  double bias = 0.0;
  Certainties weights{};
  std::vector<double> log_odds(examples.size(), 0.0);
  const auto step = [&](auto&& factor, double pull, double stiffness, double least, double& weight) {
    double slope = pull * weight;
    double curvature = stiffness;
    for (std::size_t i = 0; i < examples.size(); ++i) {
      const double p = 1.0 / (1.0 + std::exp(-log_odds[i]));
      slope += (p - examples[i].right) * factor(i);
      curvature += std::max(p * (1.0 - p), 1e-4) * factor(i) * factor(i);
    }
    const double next = std::max(weight - slope / curvature, least);
    for (std::size_t i = 0; i < examples.size(); ++i) {
      log_odds[i] += (next - weight) * factor(i);
    }
    weight = next;
  };
  for (int sweep = 0; sweep < kSweeps; ++sweep) {
    step([](std::size_t) { return 1.0; }, 0.0, 1e-9, -std::numeric_limits<double>::infinity(), bias);
    for (std::size_t j = 0; j < kEvidences; ++j) {
      step([&](std::size_t i) { return examples[i].certain[j]; }, ridge, ridge, 0.0, weights[j]);
    }
  }
  diagnosis::ConfidenceMap map{bias, {}, 0.0, 0.0, 1.0};
  for (std::size_t j = 0; j < kEvidences; ++j) {
    if (standard.deviation[j] > 0.0) {
      map.weights[j] = weights[j] / standard.deviation[j];
      map.bias -= map.weights[j] * standard.mean[j];
    }
  }
  return map;
}

/// Widens 95 % intervals until they cover 95 % of these sizes. A share of the distance from neutral is added to the
/// deviation of a fit: of a few shares the one with the narrowest intervals, in the mean of their logarithms.
void cover(diagnosis::ConfidenceMap& map, const std::vector<Outcome>& outcomes) {
  std::vector<const Named*> sizes;
  for (const Outcome& outcome : outcomes) {
    for (const Named& named : outcome.named) {
      if (named.fit_error && named.distance > 0.0) {
        sizes.push_back(&named);
      }
    }
  }
  double narrowest = std::numeric_limits<double>::infinity();
  for (const double share : {0.0005, 0.001, 0.002, 0.004, 0.007, 0.01, 0.015, 0.02, 0.03, 0.05}) {
    diagnosis::ConfidenceMap one = map;
    one.least_share = share;
    one.widening = 1.0;
    std::vector<double> needed;
    double width = 0.0;
    for (const Named* size : sizes) {
      const double deviation = diagnosis::covering_deviation(size->fit_deviation, size->distance, one);
      needed.push_back(*size->fit_error / kDeviationsOf95 / deviation);
      width += std::log(deviation / size->distance) / static_cast<double>(sizes.size());
    }
    if (needed.empty()) {
      return;
    }
    // The empirical quantile that covers a size to come with 95 % (Vovk et al. 2005).
    const double rank = std::ceil(0.95 * static_cast<double>(needed.size() + 1));
    const auto at = static_cast<std::ptrdiff_t>(std::min(rank, static_cast<double>(needed.size()))) - 1;
    std::ranges::nth_element(needed, needed.begin() + at);
    one.widening = needed[static_cast<std::size_t>(at)];
    if (width + std::log(one.widening) < narrowest) {
      narrowest = width + std::log(one.widening);
      map = one;
    }
  }
}

}  // namespace

std::vector<Statement> statements_of(const std::vector<Outcome>& outcomes) {
  std::vector<Statement> statements;
  for (const Outcome& outcome : outcomes) {
    for (const Named& named : outcome.named) {
      statements.push_back({named.confidence, hides(outcome, named.name)});
    }
  }
  return statements;
}

Calibration calibration_of(std::vector<Statement> statements) {
  constexpr double kNoNumber = std::numeric_limits<double>::quiet_NaN();
  Calibration result{statements.size(), kNoNumber, kNoNumber, kNoNumber, kNoNumber, kNoNumber};
  if (statements.empty()) {
    return result;
  }
  std::ranges::sort(statements, {}, &Statement::confidence);
  double square = 0.0;
  double excess = 0.0;
  double variance = 0.0;
  for (const auto& [p, right] : statements) {
    const double y = right ? 1.0 : 0.0;
    square += (y - p) * (y - p);
    excess += (y - p) * (1.0 - 2.0 * p);
    variance += (1.0 - 2.0 * p) * (1.0 - 2.0 * p) * p * (1.0 - p);
  }
  result.brier = square / static_cast<double>(statements.size());
  result.spiegelhalter_z = excess / std::sqrt(std::max(variance, 1e-300));
  result.error = calibration_error(statements, [&](std::size_t i) { return statements[i].right; });
  result.most = statements.back().confidence;
  const NoiseStream stream(1, "blind trials", "calibration");
  result.expected = 0.0;
  for (Tick draw = 0; draw < kDraws; ++draw) {
    const Tick first = draw * static_cast<Tick>(statements.size());
    result.expected +=
        calibration_error(
            statements,
            [&](std::size_t i) { return stream.uniform(first + static_cast<Tick>(i)) < statements[i].confidence; }) /
        static_cast<double>(kDraws);
  }
  return result;
}

Coverage coverage_of(const std::vector<Outcome>& outcomes) {
  Coverage coverage;
  std::size_t covered = 0;
  for (const Outcome& outcome : outcomes) {
    for (const Named& named : outcome.named) {
      if (named.fit_error) {
        ++coverage.sizes;
        covered += *named.fit_error <= kDeviationsOf95 * named.deviation ? 1 : 0;
      }
    }
  }
  coverage.share = static_cast<double>(covered) / static_cast<double>(coverage.sizes);
  const WilsonInterval band = wilson_interval(covered, coverage.sizes);
  coverage.low = band.low;
  coverage.high = band.high;
  return coverage;
}

std::optional<diagnosis::ConfidenceMap> fitted_map(const std::vector<Outcome>& outcomes) {
  std::vector<Example> examples = examples_of(outcomes);
  const auto right = std::ranges::count(examples, 1.0, &Example::right);
  if (right == 0 || right == std::ssize(examples)) {
    return std::nullopt;
  }
  diagnosis::ConfidenceMap map = logistic(std::move(examples), 1.0);
  map.trials = static_cast<double>(outcomes.size());
  cover(map, outcomes);
  return map;
}

std::string map_text(const diagnosis::ConfidenceMap& map, const std::string& source) {
  std::string weights;
  for (const double weight : map.weights) {
    weights += (weights.empty() ? "" : ", ") + number_as("%.6g", weight);
  }
  return "// " + source + "\n{" + number_as("%.6g", map.bias) + ",\n {" + weights + "},\n " +
         number_as("%.1f", map.trials) + ", " + number_as("%.6g", map.least_share) + ", " +
         number_as("%.6g", map.widening) + "}\n";
}

}  // namespace farrier::blind
