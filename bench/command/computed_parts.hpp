#pragma once

#include <vector>

#include "bench/command/parts.hpp"
#include "robot/robot.hpp"

namespace farrier::cli {

struct ComputedPart {
  const char* only;  ///< the name of --only that asks for it
  Part part;
};

/// Parts of `farrier bench` that start no process, in their order. `robot`: whose tick and redesign are measured; it
/// outlives them.
std::vector<ComputedPart> computed_parts(const robot::Robot& robot);

}  // namespace farrier::cli
