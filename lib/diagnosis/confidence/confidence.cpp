#include "diagnosis/confidence/confidence.hpp"

#include <algorithm>
#include <cmath>

namespace farrier::diagnosis {
namespace {

constexpr ConfidenceMap kHydraulic =
#include "diagnosis/confidence/confidence_hydraulic.def"
    ;
constexpr ConfidenceMap kElectric =
#include "diagnosis/confidence/confidence_electric.def"
    ;

/// Largest confidence of a name that the recording does not tell from another one, or on whose channels much is left: to
/// be sure of it would contradict the verdict. In trials of seed 100001 the maps gave 25 tied names 0.7 or more, and 19
/// were right.
constexpr double kMostUnsure = 0.8;

double log_within(double value, double low, double high) noexcept { return std::log(std::clamp(value, low, high)); }

}  // namespace

std::array<double, kEvidences> numbers_of(const Evidence& e) noexcept {
  return {e.rival_chance, e.runner_up,  e.own_left,     e.all_left, e.unexplained, e.share,
          e.gain,         e.deviations, e.halves_apart, e.effects,  e.rivals};
}

Evidence evidence_of(const std::array<double, kEvidences>& n) noexcept {
  return {n[0], n[1], n[2], n[3], n[4], n[5], n[6], n[7], n[8], n[9], n[10]};
}

std::array<double, kEvidences> certainties(const Evidence& e) noexcept {
  const double chance = std::clamp(e.rival_chance, 0.02, 0.998);
  return {std::log(chance / (1.0 - chance)),       -std::clamp(e.runner_up, 0.0, 1.5),
          -log_within(e.own_left, 1.0, 20.0),      -log_within(e.all_left, 1.0, 20.0),
          -log_within(e.unexplained, 0.01, 1.0),   log_within(e.share, 0.01, 1.0),
          log_within(e.gain, 0.03, 5.0),           log_within(e.deviations, 3.0, 300.0),
          -log_within(e.halves_apart, 0.003, 1.0), 1.0 - std::clamp(e.effects, 1.0, 6.0),
          -std::clamp(e.rivals, 0.0, 1.0)};
}

const ConfidenceMap& confidence_map(bool electric) noexcept { return electric ? kElectric : kHydraulic; }

double confidence_of(const Evidence& evidence, const ConfidenceMap& map) noexcept {
  const auto certain = certainties(evidence);
  double log_odds = map.bias;
  for (std::size_t i = 0; i < kEvidences; ++i) {
    log_odds += map.weights[i] * certain[i];
  }
  const bool unsure = evidence.rivals > 0.0 || evidence.unexplained > kMostLeft;
  const double most = unsure ? kMostUnsure : 1.0 - 1.0 / map.trials;
  return std::min(1.0 / (1.0 + std::exp(-log_odds)), most);
}

double covering_deviation(double deviation, double distance, const ConfidenceMap& map) noexcept {
  return map.widening * std::hypot(deviation, map.least_share * distance);
}

}  // namespace farrier::diagnosis
