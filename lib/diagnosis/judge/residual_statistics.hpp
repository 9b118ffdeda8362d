#pragma once

#include <span>
#include <vector>

namespace farrier::diagnosis {

/// A quantity that may drive a residual, and what the residual does with it.
struct Dependence {
  const char* driver;                         ///< speed, current, force, position
  std::vector<double> from, mean, deviation;  ///< bins of equal counts: lower edge, mean residual, its deviation
  double explained;                           ///< share of the residual's power that the bins' means explain
};

/// `bins` >= 1 of equal counts; spans of one size, at least one sample per bin.
Dependence dependence(const char* driver, std::span<const double> values, std::span<const double> residual, int bins);

/// Largest autocorrelation at lags 1 to `lags`, times the root of the count: below about 4 for white noise.
double whiteness(std::span<const double> residual, int lags);

/// Largest correlation with `input` at lags -lags to lags, times the root of the count.
double cross_correlation(std::span<const double> residual, std::span<const double> input, int lags);

/// One-sided power density of segments of `segment` samples, half of each in the next, under Hann's window (Welch
/// 1967). Places k / (segment period); segment a power of two, empty where the residual is shorter.
std::vector<double> power_density(std::span<const double> residual, double period_s, int segment);

}  // namespace farrier::diagnosis
