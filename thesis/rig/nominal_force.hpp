#pragma once

// The load-cell force of Table A.1's joint, which Figs 4.6 to 4.10 and A.2 vary.

#include <vector>

#include "control/model/model_analysis.hpp"
#include "plant/nominal.hpp"

namespace farrier::thesis {

/// Frequencies (Hz) at which responses are compared.
inline const std::vector<double>& force_grid() {
  static const std::vector<double> frequencies = control::logarithmic_grid(0.1, 1000.0, 200);
  return frequencies;
}

/// From valve current to load-cell force, load-cell model (3.51).
inline control::SingleInOut<3> nominal_force(const plant::OperatingPoint& point,
                                             const plant::LoadParams& load = plant::nominal_load()) {
  return control::load_cell_system(plant::nominal_cylinder(), load, point, plant::Output::kLoadCellForce);
}

}  // namespace farrier::thesis
