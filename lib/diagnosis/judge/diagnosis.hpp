#pragma once

#include <functional>
#include <string>
#include <vector>

#include "diagnosis/data/channel_report.hpp"
#include "diagnosis/judge/experiment.hpp"
#include "diagnosis/judge/judgement.hpp"
#include "diagnosis/data/recording.hpp"
#include "diagnosis/data/recording_check.hpp"
#include "plant/terms/active_effect.hpp"
#include "robot/robot.hpp"

namespace farrier::diagnosis {

struct Diagnosis {
  Judgement judgement;
  std::vector<ChannelReport> channels;
  std::vector<Experiment> experiments;
  double nrmse_before = 0.0, nrmse_after = 0.0;  ///< held out, the mean square over the judged channels
  double ratio_low = 1.0, ratio_high = 1.0;      ///< 95 % band of before / after
  std::vector<std::string> remarks;              ///< what was not judged and why, what the reader did
};

struct DiagnosisOptions {
  Rules rules;
  FitOptions fit;
  int threads = 2;                                            ///< >= 1
  std::function<void(double done)> progress = [](double) {};  ///< gets 0 to 1
};

/// Diagnoses a recording that read_recording and check_recording found nothing wrong with.
Diagnosis diagnose(const Recording& recording, const robot::Joint& joint, const DiagnosisOptions& options = {});

/// Held-out errors of a recording's joint as it was given and of the `extended` one, constants fitted within their band.
/// Both have the same sensors.
ErrorRatio error_ratio(const Recording& recording, const robot::Joint& given, const robot::Joint& extended,
                       const FitOptions& options = {});

/// Effects found, as the joint's section `effects` of a robot file has them.
std::vector<plant::ActiveEffect> found_effects(const Diagnosis& diagnosis, const robot::Joint& joint);

}  // namespace farrier::diagnosis
