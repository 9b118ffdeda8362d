#pragma once

// Confidence of a name, by a map that is fitted to blind trials: docs/decisions/0094-calibrated-confidence.md.

#include <array>
#include <cstddef>

namespace farrier::diagnosis {

/// Share of a channel's rms before any effect from which on what is left leaves no name sure.
inline constexpr double kMostLeft = 0.35;

/// Figures about a named effect that its confidence depends on.
struct Evidence {
  double rival_chance = 1.0;  ///< share of resampled blocks in which no rival explains more, reduced for a small lead
  double runner_up = 0.0;  ///< log gain that a linear step promises of the best other effect in its place, over its own
  double own_left = 1.0;   ///< rms of what is left over that of noise, the largest on channels on which it shows
  double all_left = 1.0;   ///< the same on all channels
  double unexplained = 0.0;   ///< rms of what is left over that before any effect, the largest on its channels
  double share = 1.0;         ///< of the whole log gain
  double gain = 0.0;          ///< log gain that is lost without the effect
  double deviations = 0.0;    ///< distance from its neutral value over its standard deviation
  double halves_apart = 0.0;  ///< difference of both halves' values over the distance from the neutral value
  double effects = 1.0;       ///< that are named
  double rivals = 0.0;        ///< that cannot be excluded
};

inline constexpr std::size_t kEvidences = 11;

/// The figures as numbers in an order, as files of trials keep them, and back.
std::array<double, kEvidences> numbers_of(const Evidence& evidence) noexcept;
Evidence evidence_of(const std::array<double, kEvidences>& numbers) noexcept;

/// The figures on scales on which larger is more certain: logarithms, within limits that keep a single one from deciding.
std::array<double, kEvidences> certainties(const Evidence& evidence) noexcept;

/// A logistic map of certainties to a probability. No weight is negative, so no figure that speaks for a name lowers its
/// confidence.
struct ConfidenceMap {
  double bias;
  std::array<double, kEvidences> weights;
  double trials;       ///< that it was fitted to; no confidence exceeds 1 - 1/trials
  double least_share;  ///< of the distance from neutral, that the deviation of a size is at least before it is widened
  double widening;     ///< of deviations, with which 95 % intervals covered 95 % of the sizes in these trials
};

/// The map of joints of oil or electric ones, fitted by `farrier diagnose --benchmark --calibrate`.
const ConfidenceMap& confidence_map(bool electric) noexcept;

/// Probability that the effect is present.
double confidence_of(const Evidence& evidence, const ConfidenceMap& map) noexcept;

/// Standard deviation of a size so that 1.96 of them cover as often as they say. Its arguments: that of the fit, and the
/// distance of the fitted number from neutral.
double covering_deviation(double deviation, double distance, const ConfidenceMap& map) noexcept;

}  // namespace farrier::diagnosis
