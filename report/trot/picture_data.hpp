#pragma once

#include <span>
#include <string>
#include <utility>
#include <vector>

#include "core/result.hpp"
#include "gait/schedule.hpp"
#include "trace/trace.hpp"
#include "robot/robot.hpp"

namespace farrier::report {

/// Data of the pictures of one joint, in files beside them.
struct JointPictureData {
  double window_start_s = 0.0, window_end_s = 0.0;    ///< of the close look: three strides from the first judged tick
  double run_end_s = 0.0;
  std::vector<std::pair<double, double>> stance_s;    ///< planned stances within the window, from and to
  bool empty = true;                                  ///< no row within the window
};

/// Rows of each joint in the order of Robot::joints, each in the order of the trace.
std::vector<std::vector<const trace::TraceRow*>> rows_by_joint(const robot::Robot& robot,
                                                                std::span<const trace::TraceRow> rows);

/// Writes <stem>_window.dat (time s, reference, force, error) and <stem>_run.dat (time s, then lowest and highest
/// reference, lowest and highest error of each of a few hundred intervals of the whole run).
Result<JointPictureData> write_picture_data(const std::string& stem, const robot::Robot& robot,
                                            const gait::Schedule& schedule, const robot::Joint& joint,
                                            const std::vector<const trace::TraceRow*>& rows);

}  // namespace farrier::report
