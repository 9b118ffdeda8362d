#pragma once

#include <optional>

#include "signals/signals.hpp"

namespace farrier::monitor {

/// Mass of the load (kg, of a rotary joint kg m^2) that an estimate stands for: its m_l where it knows the physics,
/// otherwise what its model says. Empty where that is no positive number.
std::optional<double> load_mass(const signals::JointModelEstimate& estimate, double period_s);

}  // namespace farrier::monitor
