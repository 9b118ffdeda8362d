#include "estimation/valve/valve_flow_check.hpp"

#include <cmath>
#include <string>

namespace farrier::estimation {

Result<Done> validate(const ValveFlowParams& p) {
  std::string text;
  const auto positive = [&text](const char* name, double value) {
    if (!(value > 0.0 && std::isfinite(value))) {
      text += std::string(text.empty() ? "" : "; ") + name + " must be above 0, is " + std::to_string(value);
    }
  };
  positive("memory_s", p.memory_s);
  positive("smoothing_s", p.smoothing_s);
  positive("flow_error", p.flow_error);
  positive("change_threshold", p.change_threshold);
  positive("gain_uncertainty", p.gain_uncertainty);
  positive("overlap_uncertainty", p.overlap_uncertainty);
  positive("leakage_uncertainty", p.leakage_uncertainty);
  positive("damping_uncertainty", p.damping_uncertainty);
  positive("compressibility_uncertainty", p.compressibility_uncertainty);
  if (!(p.least_opening >= 0.0 && p.least_opening < 1.0)) {
    text += std::string(text.empty() ? "" : "; ") + "least_opening must be within [0, 1)";
  }
  return text.empty() ? Result<Done>(Done{}) : Result<Done>(Error{"valve_flow: " + text});
}

}  // namespace farrier::estimation
