#pragma once

#include "trials/truth/truth.hpp"

namespace farrier::truth {

/// generate() of an electric joint. Its samples have no pressures.
Result<Trial> generate_electric(const robot::Joint& joint, double period_s, const Plan& plan);

/// Effects that the library knows of such an electric joint, and those that none of them can stand for.
std::vector<std::string> known_electric_effects(const robot::Joint& joint);
std::vector<std::string> outside_electric_effects();

}  // namespace farrier::truth
