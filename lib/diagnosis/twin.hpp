#pragma once

#include <array>

#include "diagnosis/judgement.hpp"

namespace farrier::diagnosis {

/// Root mean square by channel of what a model's residuals would be if it were right and its sensors had `noise`: that
/// of a twin, a recording the model makes itself over the same motion.
std::array<double, kChannels> expected_residuals(const Bench& bench, const Hypothesis& hypothesis,
                                                 const SensorNoiseLevels& noise);

}  // namespace farrier::diagnosis
