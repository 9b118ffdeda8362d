#pragma once

#include <vector>

#include "diagnosis/data/joint_data.hpp"
#include "plant/terms/term.hpp"

namespace farrier::diagnosis {

/// Starts of position_dependent_friction, as Simulator::starts has them: the strongest waves of the friction in the
/// balance of forces on the load, the strongest first. They are fitted beside inertia, damping, spring and a level
/// friction by least squares, at every wavelength of a grid. Those of the library where the recording shows none.
std::vector<std::vector<double>> starts_of_friction_wave(const JointData& data, const plant::Scales& scales);

/// A start of spring_hardening, as Simulator::starts has them. It is the cubic spring that the balance of forces on the
/// load has beside inertia, damping, dry friction and a linear spring, by least squares. Empty for a
/// recording that is too short, or in which the load of the model does not move.
std::vector<std::vector<double>> starts_of_hardening(const JointData& data, const plant::Scales& scales);

}  // namespace farrier::diagnosis
