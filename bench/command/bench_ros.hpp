#pragma once

#include "cli/processes/dds_run.hpp"
#include "report/figures/figures.hpp"
#include "robot/robot.hpp"

namespace farrier::cli {

/// The cost of `farrier ros` at 100 Hz beside runs in real time (bench.ros), while a node reads it. Figures are its share of
/// a core, and the latency of the control loop with it over that without, as medians of pairs of runs. It takes two minutes,
/// and refuses as run_over_dds does.
Result<Done> bench_ros(const robot::Robot& robot, const DdsRun& plain, report::Figures& figures);

}  // namespace farrier::cli
