#pragma once

#include <span>
#include <string>

#include "core/result.hpp"
#include "robot/robot.hpp"
#include "report/figures/run_info.hpp"

namespace farrier::report {

/// Input of a picture of one joint's adaptation.
struct AdaptationPicture {
  const robot::Robot& robot;
  const robot::Joint& joint;
  std::span<const DecisionInfo> decisions;                    ///< of the run, all joints
  std::span<const signals::JointControllerGains> gains;       ///< likewise
  int loop_delay_ticks;
  Tick ticks;                                                 ///< of the run
};

/// True when the supervisor decided anything about the joint.
bool adapted(const AdaptationPicture& input);

/// Writes the data beside `stem` and adds commands to `script` that draw `output`; out_dir is gnuplot's working
/// directory. One panel shows velocity and force gain of both slots over time against those for the true loads. Another
/// shows the poles of every estimate decided on against those of the true loads. Refuses data that the disk does not
/// take, and a joint without a controller.
Result<Done> plot_adaptation(const AdaptationPicture& input, const std::string& out_dir, const std::string& stem,
                             const std::string& output, std::string& script);

}  // namespace farrier::report
