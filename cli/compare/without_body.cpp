// In place of body.cpp and adaptation.cpp in a build without the physics engine.

#include "cli/base/command.hpp"
#include "cli/compare/comparison.hpp"

namespace farrier::cli {
namespace {

int refuse_without_engine(const char* what) {
  return refuse("compare", std::string("compare ") + what +
                               " needs MuJoCo 2.2.2, and this build has none: install libmujoco-dev and build again");
}

}  // namespace

int run_body(const robot::Robot&, const CompareOptions&) { return refuse_without_engine("body"); }

int run_adaptation(const robot::Robot&, const CompareOptions&) { return refuse_without_engine("adaptation"); }

}  // namespace farrier::cli
