#pragma once

#include <string>
#include <vector>

#include "plant/terms/active_effect.hpp"
#include "robot/robot.hpp"
#include "cli/trot/trot_options.hpp"
#include "report/diagnosis/hide_result.hpp"

namespace farrier::cli {

/// The command line of `farrier trial`: a recorded run of the gait, with an effect hidden in the simulated robot.
struct TrialOptions : TrotOptions {
  std::uint64_t hide = 1;    ///< seed of joint, effect and size
  bool controllers = false;  ///< the same effect under every kind of controller, in place of the suspects
  int seeds = 1;             ///< number of effects, hidden one at a time, from `hide` on
};

/// Makes `o.seeds` robots with an effect that only their sim_bridge knows, from seed `o.hide` on. Each trots and is
/// recorded, and every joint's recording is diagnosed against the nominal robot. The robot then trots again, with the
/// findings for the most suspected joint in every process's model.
class TrialStudy {
 public:
  /// `nominal` outlives the study. Recorded runs follow `o`; the runs for comparison are in process. `o` names its
  /// trace and its recording, and outlives the study as well.
  TrialStudy(const robot::Robot& nominal, const TrialOptions& o) : nominal_(nominal), o_(o) {}

  /// Refuses if a run does, with the seed, and when the user interrupts.
  Result<Done> run();

  const std::vector<report::HideTrial>& trials() const noexcept { return trials_; }
  /// Robot files with the effects found, one per seed with any.
  const std::vector<std::string>& models() const noexcept { return models_; }
  /// One per seed.
  const std::vector<std::string>& recordings() const noexcept { return recordings_; }
  bool long_enough() const noexcept { return long_enough_; }

 private:
  /// Stance NRMSE of every joint in a run that left its trace at `trace_path`.
  Result<std::vector<double>> stance_nrmse(RunOutcome& run, const std::string& trace_path);
  Result<Done> run(std::uint64_t seed, const std::vector<double>& nominal_nrmse);
  Result<std::vector<plant::ActiveEffect>> diagnose_all(const TrotOptions& run, report::HideTrial& trial);
  /// The robot file with the effect of `world`, for sim_bridge alone.
  Result<std::string> write_world(const robot::Robot& world, const std::string& joint) const;
  /// The robot with these effects, written to a file and loaded back.
  Result<robot::Robot> extend(const robot::Joint& joint, const std::vector<plant::ActiveEffect>& effects,
                              std::uint64_t seed);

  const robot::Robot& nominal_;
  const TrialOptions& o_;
  std::vector<report::HideTrial> trials_;
  std::vector<std::string> models_, recordings_;
  bool long_enough_ = true;
};

}  // namespace farrier::cli
