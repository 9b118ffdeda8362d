#pragma once

// Content of Figs 9.1 to 9.10 and G.1 to G.6, the estimates of a chirp, as numbers and as panels.

#include <complex>
#include <string>
#include <vector>

#include "thesis/rig/rig_estimates.hpp"

namespace farrier::thesis {

/// Frequencies at which the estimates are compared, 0.3 to 200 Hz.
const std::vector<double>& chirp_grid();
/// From normalised valve current to normalised load-cell force.
std::vector<std::complex<double>> force_response(const control::DiscreteModel& model, double period_s);

/// True if the response has a maximum between 0.3 and 10 Hz that stands 3 dB above its left and right: a resonance the
/// rig does not have there.
bool has_fictive_peak(const control::DiscreteModel& model, double period_s);
/// Share of the models between two times with such a peak.
double fictive_share(const ChirpEstimates& run, double from_s, double to_s);
/// RMS distance in dB from the nominal response over [from_Hz, to_Hz], mean of the models between two times.
double distance_dB(const ChirpEstimates& run, double from_s, double to_s, double from_Hz = 1.0, double to_Hz = 100.0);
/// That of the first guess.
double first_distance_dB(const ChirpEstimates& run, double from_Hz = 1.0, double to_Hz = 100.0);
/// Mean over the models between two times of the RMS change in dB from the model before.
double roughness_dB(const ChirpEstimates& run, double from_s, double to_s);
/// Spans in which the gate was open, in ticks, those that last less than `shortest` ticks left out.
struct Span {
  std::size_t begin, end;
};
std::vector<Span> open_spans(const ChirpEstimates& run, std::size_t shortest = 1);
/// "open from sample 3000 to 3650,", for a note.
std::string spans_text(const std::vector<Span>& spans);
/// Share of the estimates taken while the gate was open that have a fictive peak.
double open_share(const ChirpEstimates& run);

/// Magnitude and phase over frequency: estimates from black to yellow, the last one green, the first purple, nominal
/// blue.
std::vector<Panel> estimates_panels(const std::string& title, const ChirpEstimates& run);
/// lambda of the rows, a panel each.
Picture forgetting_picture(const std::string& caption, const ChirpEstimates& run);

}  // namespace farrier::thesis
