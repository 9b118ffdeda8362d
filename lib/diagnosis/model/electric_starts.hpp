#pragma once

#include <vector>

#include "diagnosis/data/joint_data.hpp"
#include "plant/electric_actuator.hpp"
#include "plant/terms/term.hpp"

namespace farrier::diagnosis {

// Starts of fits that only a recording can give, as Simulator::starts has them.

/// Starts of current_limit: shares of the largest recorded command; none where no current was recorded.
std::vector<std::vector<double>> starts_of_limit(const JointData& data, const plant::Scales& scales);

/// Starts of cogging: the strongest sinusoids of the rotor's position in the balance of torques, the strongest first.
/// They are fitted beside its linear terms by least squares, at every period of a grid.
std::vector<std::vector<double>> starts_of_cogging(const JointData& data, const plant::ElectricParams& drive,
                                                   const plant::LoadParams& load, const plant::Scales& scales);

/// Starts of gravity: the sinusoid of the load's position with one period per turn in the balance of its torques.
std::vector<std::vector<double>> starts_of_gravity(const JointData& data, const plant::ElectricParams& drive,
                                                   const plant::LoadParams& load, const plant::Scales& scales);

}  // namespace farrier::diagnosis
