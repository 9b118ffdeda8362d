#pragma once

#include <functional>

#include "trials/truth/truth.hpp"

namespace farrier::truth {

/// Command of a run, A, by the time since recording began and the readings of position and velocity.
using Command = std::function<double(double time_s, double position, double velocity)>;

/// generate() of an electric joint. Its samples have no pressures. A `command`, from 0.3 s before the recording on, takes
/// the place of the plan's excitation. The effects are then those that the plan hides with its own excitation.
Result<Trial> generate_electric(const robot::Joint& joint, double period_s, const Plan& plan,
                                const Command& command = {});

/// Effects that the library knows of such an electric joint, and those that none of them can stand for.
std::vector<std::string> known_electric_effects(const robot::Joint& joint);
std::vector<std::string> outside_electric_effects();

}  // namespace farrier::truth
