#pragma once

#include <optional>
#include <vector>

#include "diagnosis/judge/diagnosis.hpp"
#include "diagnosis/judge/separability.hpp"

namespace farrier::diagnosis {

/// Two effects of usual size of which one explains what the other does to a recording.
struct Inseparable {
  plant::EffectId one, other;
  double left;                           ///< smaller remainder of both ways round, over the noise that is expected
  std::optional<Channel> column;         ///< not recorded, and only one of both shows there
  std::optional<Experiment> experiment;  ///< that would tell them apart
};

struct WhatCanBeTold {
  std::vector<EffectVisibility> effects;       ///< that the recorded columns may show
  std::vector<plant::EffectId> other_columns;  ///< effects that show on columns alone that were not recorded
  std::vector<Inseparable> pairs;              ///< the most alike first
};

/// Difference of two simulated joints, over a sensor's noise, from which an experiment tells them apart.
inline constexpr double kTellingDifference = 3.0;

/// Says before any verdict which effects a recording can show and tell apart: see effect_visibilities(). For a pair that it
/// does not tell apart, what would: a column that was not recorded, else an experiment (telling_experiment(), hydraulic joints
/// alone). Refused recordings and those that move too little are the caller's business, as for diagnose().
WhatCanBeTold what_can_be_told(const Recording& recording, const robot::Joint& joint, const DiagnosisOptions& options);

}  // namespace farrier::diagnosis
