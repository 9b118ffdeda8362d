#pragma once

#include <vector>

#include "diagnosis/data/joint_data.hpp"
#include "plant/terms/term.hpp"

namespace farrier::diagnosis {

/// Starts of position_dependent_friction, as Simulator::starts has them: the strongest waves of the friction in the
/// balance of forces on the load, the strongest first. They are fitted beside inertia, damping, spring and a level
/// friction by least squares, at every wavelength of a grid. Those of the library where the recording shows none.
std::vector<std::vector<double>> starts_of_friction_wave(const JointData& data, const plant::Scales& scales);

}  // namespace farrier::diagnosis
