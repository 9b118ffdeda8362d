#pragma once

// Models of a run through thesis/rig/walking_cycle.hpp's loads against the truth, as the studies of Chapter 6 judge and draw
// them.

#include <complex>
#include <span>
#include <string>
#include <vector>

#include "thesis/rig/bode.hpp"
#include "thesis/rig/walking_cycle.hpp"

namespace farrier::thesis {

// Bounds of a converged estimate; the text has pictures and no numbers. An open valve's gain differs between its signs
// by the roots of (3.26), 10 log10(1 / alpha) = 2.15 dB. The sign of the few samples in the memory is chance, so the
// truth itself is no narrower.
inline constexpr double kConverged_dB = 2.15;
inline constexpr double kConvergedMass = 0.05;

/// The middle value; NaN for none.
double median(std::vector<double> values);

/// The pole above the real axis, or the largest one.
std::complex<double> complex_pole(const Eigen::Matrix3d& a);

/// Sections count from 0, ticks from a section's begin. The error of a model is the difference of its magnitude from
/// the true one's, as the median over 1 to 450 Hz in equal steps of the logarithm. It does not depend on the height of
/// a resonance.
class CycleEstimates {
 public:
  /// Least squares on `samples` of `loads`, which may be one.
  CycleEstimates(const std::vector<thesis::CycleSample>& samples, std::span<const plant::LoadParams> loads,
                 double forgetting_factor);

  std::size_t sections() const { return loads_.size(); }
  std::span<const control::DiscreteModel> models(std::size_t section) const;
  control::DiscreteModel truth(std::size_t section) const;
  Response true_response(std::size_t section, std::span<const double> grid) const;

  /// Ticks until the error, or the mass's error over the mass, stays below its bound to the section's end, or to `until`.
  double converged_ms(std::size_t section, Tick until = thesis::kSectionTicks) const;
  double mass_converged_ms(std::size_t section, Tick until = thesis::kSectionTicks) const;

  double largest_error_dB(std::size_t section) const;
  double largest_mass_error(std::size_t section, Tick from) const;

  /// Way of the estimated mass in the 60 ms after the section's begin over the distance of the two loads.
  double mass_detour(std::size_t section) const;

  /// Least estimated mass in the `within` ticks after the section's begin, over the section's true mass.
  double least_mass(std::size_t section, Tick within) const;

  /// Share of a section's models, from 60 ms on, with a highest magnitude more than 3 dB off the true one's.
  double resonance_missed(std::size_t section) const;

  /// Mean error, and mean change of the magnitude from tick to tick, from 60 ms after each section's begin.
  double settled_error_dB() const;
  double settled_spread_dB(Tick from = 60, Tick until = thesis::kSectionTicks) const;

  /// Magnitude and phase of a section's models every 5 ms up to `until`, and the truth.
  std::vector<Panel> bode(const std::string& title, std::size_t section, Tick until = thesis::kSectionTicks) const;
  /// Its poles or zeros.
  Panel plane(const std::string& title, std::size_t section, bool zeros) const;
  /// Mass over time, and the true one, up to `until` of the last section.
  Panel mass_panel(const std::string& title, Tick until = thesis::kSectionTicks) const;

 private:
  double error_dB(std::size_t section, std::size_t tick) const { return errors_[section * kTicks + tick]; }
  double mass(std::size_t section, std::size_t tick) const { return masses_[section * kTicks + tick]; }
  double mass_error(std::size_t section, std::size_t tick) const;

  static constexpr auto kTicks = static_cast<std::size_t>(thesis::kSectionTicks);
  std::vector<plant::LoadParams> loads_;
  std::vector<control::DiscreteModel> models_;
  std::vector<std::vector<double>> magnitudes_dB_;  // of models_, on the grid of the errors
  std::vector<double> errors_;
  std::vector<double> masses_;
};

}  // namespace farrier::thesis
