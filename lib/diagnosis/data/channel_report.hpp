#pragma once

#include <vector>

#include "diagnosis/judge/hypothesis.hpp"
#include "diagnosis/model/joint_simulator.hpp"
#include "diagnosis/judge/residual_statistics.hpp"

namespace farrier::diagnosis {

/// NRMSE (root mean square of the error over the standard deviation of the measurement) of simulations on held-out
/// time, by prediction horizon.
struct Horizons {
  double one_step, ahead_50ms, free_running;
};

/// Errors of a model on one channel.
struct ChannelReport {
  Channel channel;
  const char* name;          ///< "valve_and_oil" or "drive", "load", "velocity_sensor"
  Horizons before, after;    ///< the nominal model with its constants fitted within 3 %; the chosen model
  double whiteness;          ///< of the residual before, see residual_statistics.hpp
  double cross_correlation;  ///< of the residual before with the input of the channel
  double whiteness_after, cross_correlation_after;
  std::vector<Dependence> dependences;                                ///< of the residual before
  std::vector<double> frequency_Hz, spectrum_before, spectrum_after;  ///< power density of both residuals
  std::vector<double> measured, simulated_before, simulated_after;    ///< over the recording, for pictures
};

/// One report per judged channel. `bench` judges hypotheses by `joint`.
std::vector<ChannelReport> report_channels(const Bench& bench, const JointSimulator& joint, const Hypothesis& before,
                                           const Hypothesis& after);

}  // namespace farrier::diagnosis
