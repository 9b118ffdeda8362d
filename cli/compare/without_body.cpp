// In place of body.cpp in a build without the physics engine.

#include "cli/base/command.hpp"
#include "cli/compare/comparison.hpp"

namespace farrier::cli {

int run_body(const robot::Robot&, const CompareOptions&) {
  return refuse("compare",
                "compare body needs MuJoCo 2.2.2, and this build has none: install libmujoco-dev and build again");
}

}  // namespace farrier::cli
