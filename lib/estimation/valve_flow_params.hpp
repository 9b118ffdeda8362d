#pragma once

namespace farrier::estimation {

/// Settings of the estimator of a valve's flow. Shares of flow are of the flow through the open valve at supply pressure.
struct ValveFlowParams {
  double memory_s = 2.0;          ///< time of an open valve after which a sample counts 1/e; > 0
  double smoothing_s = 0.005;     ///< time constant of the filter on every signal; > 0
  double least_opening = 0.005;   ///< share of full current beyond the overlap at which samples begin; in [0, 1)
  double flow_error = 0.004;      ///< error of a smoothed flow, share; > 0
  double change_threshold = 4.0;  ///< RMS of flow errors over the usual one, beyond which the valve has changed; > 1
  // Standard deviations before the first sample:
  double gain_uncertainty = 0.5;             ///< of the valve gain, share of the nominal one; > 0
  double overlap_uncertainty = 0.01;         ///< of the overlap, share of full current; > 0
  double leakage_uncertainty = 0.02;         ///< of the leakage at supply pressure, share; > 0
  double damping_uncertainty = 2.0;          ///< of the piston's damping, share of the nominal one; > 0
  double compressibility_uncertainty = 1.0;  ///< of the oil's compressibility, share of the nominal one; > 0
};

}  // namespace farrier::estimation
