#pragma once

#include "mcap/records.hpp"
#include "robot/robot.hpp"

namespace farrier::report {

/// Facts of a run in its recording: robot, configuration (effective, YAML) and its hash, period_s, version,
/// git_revision, contract.
mcap::Text recording_facts(const robot::Robot& robot);

}  // namespace farrier::report
