#pragma once

namespace farrier::estimation {

/// Settings of the grey-box estimator. A quantity with uncertainty 0 is taken as known and not estimated.
/// EstimatorParams holds the settings shared with other methods (blank_ticks, min_samples, phase_memory). Uncertainties
/// of positive quantities are of their natural logarithm, so that 0.1 is about 10 %.
struct GreyBoxParams {
  double mass_uncertainty = 2.0;          ///< of ln m_l, at the start and after a change of load; (0, 5]
  double damping_uncertainty = 1.0;       ///< of ln d_l, at the start and after a change of load; [0, 5]
  double coulomb_uncertainty = 0.0;       ///< of F_c, share of the force's scale; [0, 1]
  double stiffness_uncertainty = 0.05;    ///< of C, share of the prior's; [0, 10]
  double bias_uncertainty = 0.001;        ///< of F_bias, share of the force's scale; [0, 1]
  double valve_gain_uncertainty = 0.0;    ///< of ln K_v; [0, 2]
  double bulk_modulus_uncertainty = 0.0;  ///< of ln beta_e; [0, 2]
  double leakage_uncertainty = 0.0;       ///< share of the open valve's flow at supply pressure; [0, 1]

  double load_drift = 0.0;        ///< growth of ln m_l's and ln d_l's uncertainty, 1/sqrt(s); [0, 100]
  double bias_drift = 0.0;        ///< growth of F_bias's uncertainty, share of the force's scale per sqrt(s); [0, 100]
  double flow_error = 0.005;      ///< of the flow law, share of the valve's flow at supply pressure; [0, 1]
  double force_error = 2e-4;      ///< force on the load that no term has, share of the force's scale; [0, 1]
  double change_threshold = 30.0; ///< surplus of squared, normalised prediction errors that is a change of load; >= 5
};

}  // namespace farrier::estimation
