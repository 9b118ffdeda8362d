#pragma once

#include "cli/processes/dds_run.hpp"
#include "report/figures/figures.hpp"
#include "robot/robot.hpp"

namespace farrier::cli {

/// The cost of `farrier ros` at 100 Hz, with a node that reads it, beside runs in real time (bench.ros): its share of a core,
/// and the latency of the control loop with it over that without, as medians of pairs of runs. Takes two minutes. Refuses
/// as run_over_dds does.
Result<Done> bench_ros(const robot::Robot& robot, const DdsRun& plain, report::Figures& figures);

}  // namespace farrier::cli
