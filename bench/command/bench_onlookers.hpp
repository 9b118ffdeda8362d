#pragma once

#include <string>

#include "robot/robot.hpp"
#include "cli/processes/dds_run.hpp"
#include "report/figures/figures.hpp"

namespace farrier::cli {

// The cost of passive readers, over the vendor of `plain`, Cyclone DDS or Fast DDS: the lock-step run of `robot` that they
// are added to. Recordings go to `out`. Each takes half a minute and refuses as run_over_dds does.

/// `farrier record` and `farrier monitor` with a page that is watched, in lock-step (bench.watched).
Result<Done> bench_watched(const robot::Robot& robot, const DdsRun& plain, const std::string& out,
                           report::Figures& figures);

/// `farrier record` of everything and `farrier monitor` with a page that is watched, beside a run in real time
/// (bench.record, bench.monitor); ten monitors that stand still, in its latency (bench.stopped_monitors).
Result<Done> bench_beside(const robot::Robot& robot, const DdsRun& plain, const std::string& out,
                          report::Figures& figures);

}  // namespace farrier::cli
