#pragma once

#include <string>

#include "robot/robot.hpp"
#include "cli/processes/dds_run.hpp"
#include "report/figures/figures.hpp"

namespace farrier::cli {

/// What those who look on cost, over both vendors: `farrier record` of everything and `farrier monitor` with a page that
/// is watched, beside a run in real time (bench.record, bench.monitor); ten monitors that stand still, in its latency
/// (bench.stopped_monitors); recording and monitor in lock-step (bench.watched). `plain`: the lock-step run of `robot`
/// that they are added to. Recordings go to `out`. Takes a minute; refuses as run_over_dds does.
Result<Done> bench_onlookers(const robot::Robot& robot, const DdsRun& plain, const std::string& out,
                             report::Figures& figures);

}  // namespace farrier::cli
