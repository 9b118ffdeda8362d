#pragma once

// Result of `farrier compare models`.

#include <span>
#include <string>
#include <vector>

#include "report/figures/figures.hpp"

namespace farrier::report {

/// A form of the joint's model for one load, and the gains designed on it.
struct ModelRow {
  std::string load_kg;  ///< "0.5"
  std::string form;     ///< "exact", "thesis", "massless_piston"
  double resonance_Hz;  ///< of the damped oscillation
  double position_gain, velocity_gain, force_gain;
  double disk_margin;  ///< of these gains on the exact model
};

/// Adds compare.models.*.
void add_models(Figures& figures, std::span<const ModelRow> rows);

/// Table for people: a line for each row.
std::string models_text(std::span<const ModelRow> rows);

}  // namespace farrier::report
