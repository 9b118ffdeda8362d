#pragma once

#include "cli/trot/trot_options.hpp"

namespace farrier::cli {

/// Seconds of a walk unless --duration is given: it stands up, walks from the eighth second on, and is judged from the
/// twelfth.
inline constexpr double kWalkDuration_s = 20.0;

/// Why --design adaptive is refused for this robot on a ground, with the remedy; empty: it is not.
std::string cannot_adapt_on_ground(const robot::Robot& robot);

/// Error of options that a run on a ground does not have; empty for none.
std::string refused_on_ground(const robot::Robot& robot, const TrotOptions& options);

/// A trot of the whole robot on a ground: run, judge, report. Returns the exit status. All paths of `options` are there.
int run_on_ground(const robot::Robot& robot, const TrotOptions& options);

}  // namespace farrier::cli
