#include "robot/sections/method_sections.hpp"

namespace farrier::estimation {

using config::Default;
using config::Visitor;

void declare(Visitor& v, AdaptiveForgettingParams& aff) {
  const AdaptiveForgettingParams d;
  v.number("forgetting_min", aff.forgetting_min, {0.5, 1}, Default{d.forgetting_min}, "Least lambda of a row (9.3).");
  v.number("noise_factor", aff.noise_factor, {0, 1e6}, Default{d.noise_factor},
           "Variances of the sensor's noise that an error may have without being forgotten for, c_1 (9.1), (9.3).");
  v.number("error_memory", aff.error_memory, {0, 0.9999}, Default{d.error_memory},
           "Weight of an error's power against the next one's, beta (9.2).");
}

void declare(Visitor& v, RandomWalkParams& kalman) {
  const RandomWalkParams d;
  v.number("parameter_drift", kalman.parameter_drift, {0, 1e12}, Default{d.parameter_drift},
           "Variance of a parameter's step from tick to tick over that of the noise, normalised (B.16).");
}

void declare(Visitor& v, VariableDirectionParams& vdf) {
  const VariableDirectionParams d;
  v.number("excitation_min", vdf.excitation_min, {1e-12, 1e6}, Default{d.excitation_min},
           "Share of the regressor along an eigenvector of the information above which that is forgotten, normalised.");
}

void declare(Visitor& v, SubspaceParams& sift) {
  const SubspaceParams d;
  v.number("excitation_min", sift.excitation_min, {1e-12, 1e6}, Default{d.excitation_min},
           "Norm of the weighted regressor below which a sample is left out, normalised.");
}

void declare(Visitor& v, GreyBoxParams& g) {
  const GreyBoxParams d;
  v.number("mass_uncertainty", g.mass_uncertainty, {1e-3, 5}, Default{d.mass_uncertainty},
           "Standard deviation of the load mass's logarithm at the start and after a change of load.");
  v.number("damping_uncertainty", g.damping_uncertainty, {0, 5}, Default{d.damping_uncertainty},
           "Standard deviation of the load friction's logarithm at the start and after a change of load; 0: known.");
  v.number("coulomb_uncertainty", g.coulomb_uncertainty, {0, 1}, Default{d.coulomb_uncertainty},
           "Of Coulomb friction, share of the force's scale; 0: there is none.");
  v.number("stiffness_uncertainty", g.stiffness_uncertainty, {0, 10}, Default{d.stiffness_uncertainty},
           "Of the load spring's stiffness, share of it; 0: known.");
  v.number("bias_uncertainty", g.bias_uncertainty, {0, 1}, Default{d.bias_uncertainty},
           "Of a constant force on the load, share of the force's scale; 0: there is none.");
  v.number("valve_gain_uncertainty", g.valve_gain_uncertainty, {0, 2}, Default{d.valve_gain_uncertainty},
           "Standard deviation of the valve gain's logarithm; 0: known.");
  v.number("bulk_modulus_uncertainty", g.bulk_modulus_uncertainty, {0, 2}, Default{d.bulk_modulus_uncertainty},
           "Standard deviation of the bulk modulus's logarithm; 0: known.");
  v.number("leakage_uncertainty", g.leakage_uncertainty, {0, 1}, Default{d.leakage_uncertainty},
           "Of the leakage at supply pressure, share of the open valve's flow; 0: there is none.");
  v.number("load_drift", g.load_drift, {0, 100}, Default{d.load_drift},
           "Growth of what is uncertain of the logarithms of load mass and friction, per root of a second.");
  v.number("bias_drift", g.bias_drift, {0, 100}, Default{d.bias_drift},
           "Growth of what is uncertain of the constant force, share of the force's scale per root of a second.");
  v.number("flow_error", g.flow_error, {0, 1}, Default{d.flow_error},
           "Error of the flow law from tick to tick, share of the valve's flow at supply pressure.");
  v.number("force_error", g.force_error, {0, 1}, Default{d.force_error},
           "Force on the load that no term has, share of the force's scale.");
  v.number("change_threshold", g.change_threshold, {5, 1e12}, Default{d.change_threshold},
           "Surplus of squared, normalised prediction errors that counts as a change of load.");
}

void declare(Visitor& v, ValveFlowParams& f) {
  const ValveFlowParams d;
  v.number("memory_s", f.memory_s, {1e-3, 1e4}, Default{d.memory_s},
           "Time of an open valve after which a sample counts 1/e.");
  v.number("smoothing_s", f.smoothing_s, {1e-4, 1}, Default{d.smoothing_s},
           "Time constant of the filter on every signal.");
  v.number("least_opening", f.least_opening, {0, 0.9}, Default{d.least_opening},
           "Opening beyond the overlap at which samples begin, share of the full current.");
  v.number("flow_error", f.flow_error, {1e-6, 1}, Default{d.flow_error},
           "Error of a smoothed flow, share of the open valve's flow at supply pressure.");
  v.number("change_threshold", f.change_threshold, {1, 1e6}, Default{d.change_threshold},
           "RMS of flow errors over the usual one beyond which the valve has changed, and is learnt anew.");
  v.number("gain_uncertainty", f.gain_uncertainty, {1e-3, 5}, Default{d.gain_uncertainty},
           "Standard deviation of the valve gain before the first sample, share of it.");
  v.number("overlap_uncertainty", f.overlap_uncertainty, {1e-6, 1}, Default{d.overlap_uncertainty},
           "Of the overlap before the first sample, share of the full current.");
  v.number("leakage_uncertainty", f.leakage_uncertainty, {1e-6, 1}, Default{d.leakage_uncertainty},
           "Of the leakage at supply pressure before the first sample, share of the open valve's flow.");
  v.number("compressibility_uncertainty", f.compressibility_uncertainty, {1e-6, 100},
           Default{d.compressibility_uncertainty},
           "Of the oil's compressibility before the first sample, share of the nominal one.");
  v.number("damping_uncertainty", f.damping_uncertainty, {1e-6, 100}, Default{d.damping_uncertainty},
           "Of the piston's damping before the first sample, share of the nominal one.");
}

void declare(Visitor& v, PersistenceParams& pe) {
  const PersistenceParams d;
  v.integer("window_ticks", pe.window_ticks, {8, 4096}, Default{d.window_ticks}, "N of (9.4).");
  v.number("information_min", pe.information_min, {0, 1e12}, Default{d.information_min},
           "Least singular value of the sum of h h' over the window, alpha (9.4), normalised.");
  v.number("information_max", pe.information_max, {0, 1e12}, Default{d.information_max},
           "Largest singular value, beta (9.4), normalised.");
  v.check(pe.information_min < pe.information_max, "information_max", "must be above information_min");
}

void declare(Visitor& v, SpectrumParams& fft) {
  const SpectrumParams d;
  v.integer("window_ticks", fft.window_ticks, {8, 1024}, Default{d.window_ticks}, "N of (9.5); even.");
  v.number("magnitude_min", fft.magnitude_min, {1e-12, 1e6}, Default{d.magnitude_min},
           "Amplitude of a frequency of a normalised signal above which it counts, M_min (9.5).");
  v.integer("frequencies_min", fft.frequencies_min, {0, 1532}, Default{d.frequencies_min},
            "More than this many of the window_ticks / 2 - 1 frequencies of all signals must count, f_min (9.5).");
  v.check(fft.window_ticks % 2 == 0, "window_ticks", "must be even");
  v.check(fft.frequencies_min < 3 * (fft.window_ticks / 2 - 1), "frequencies_min",
          "must be below the number of frequencies, 3 (window_ticks / 2 - 1)");
}

}  // namespace farrier::estimation
