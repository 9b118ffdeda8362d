#pragma once

#include <array>
#include <vector>

#include "diagnosis/model/simulator.hpp"

namespace farrier::diagnosis {

struct FitOptions {
  Observer observer;
  double warm_up_s = 0.3;  ///< from a span's beginning that is not judged
  double block_s = 0.1;    ///< within which residuals count as dependent
  bool deviations = true;  ///< standard deviations are wanted
  int most_iterations = 15;
  double tolerance = 1e-4;       ///< relative change of cost that ends a fit
  double samples_per_fact = 10;  ///< neighbouring residuals that count as one fact: sets the weight of the data against
                                 ///< priors
  double nominal_spread = 0.02;  ///< prior standard deviation of a nominal factor
};

/// A recording with the channels that can be judged.
struct FitData {
  const Simulator* simulator;
  ChannelMask judged;
  std::array<double, kChannels> weight;  ///< standard deviation that a residual counts as one
};

/// Result of a fit.
struct FitResult {
  Model model;
  double cost = 0.0;
  std::vector<double> deviation;  ///< standard deviation of the effects' numbers, in their order, if wanted
};

/// Fits the factors and effects of `start` to a span: simulation error of the channels in `mask`, derivatives through the
/// simulation, factors within kNominalBand, effects within their ranges. Each step is the best within these ranges, damped
/// as by Marquardt (1963) and Nielsen (1999). Numbers of `start` that concern no such channel stay.
FitResult fit(const FitData& data, Span span, const Model& start, const ChannelMask& mask, const FitOptions& options);

/// Residuals of a channel over a span, measured less simulated; 0 where they are not judged.
std::vector<double> residuals(const Simulator& simulator, Span span, const Model& model, Channel channel,
                              const FitOptions& options);

/// Root mean square of those that are judged; 0 for none.
double judged_rms(const std::vector<double>& residuals) noexcept;

}  // namespace farrier::diagnosis
