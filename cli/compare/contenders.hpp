#pragma once

#include "run/inproc_run.hpp"
#include "robot/robot.hpp"
#include "report/compare/vary_result.hpp"

namespace farrier::cli {

/// The robot as the nodes of this contender know it: nominal, with the contender's kind of controller. Only adaptation
/// of linear gains needs the dither, so only that pays for it; who is told of actual touchdowns need not be early for
/// them. The grey box has the estimator section "greybox" of the file, the method's defaults where there is none.
robot::Robot believed_by(report::Contender contender, const robot::Robot& nominal);

/// Settings of the contender's run in `world`, which must outlive the run.
run::InprocRun run_of(report::Contender contender, const robot::Robot& world);

}  // namespace farrier::cli
