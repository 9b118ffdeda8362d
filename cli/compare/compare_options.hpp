#pragma once

#include "cli/trot/trot_options.hpp"

namespace farrier::cli {

/// The command line of `farrier compare`: the gait of one run, made by several contenders.
struct CompareOptions : TrotOptions {
  int seeds = 5;            ///< robots that are drawn, from `seed` on
  bool estimators = false;  ///< body: compare estimators in place of force controllers
  // For adaptation; empty: all.
  std::vector<std::string> rows, conditions, designs;
  bool search = false;  ///< search the fixed designs in place of the comparison
  bool noise = false;   ///< levels of noise in place of the designs
  bool go_on = false;   ///< with the runs of a comparison that was interrupted
  int threads = 2;
};

}  // namespace farrier::cli
