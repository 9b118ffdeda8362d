#pragma once

#include <optional>
#include <vector>

#include "diagnosis/judge/diagnosis.hpp"
#include "diagnosis/separability/separability.hpp"

namespace farrier::diagnosis {

/// A column or an experiment that would tell an effect from those that explain the same. Empty: no column, and no experiment that was tried.
struct Remedy {
  std::optional<Channel> column;         ///< not recorded, and the effect shows there otherwise than they
  std::optional<Experiment> experiment;  ///< that would tell them apart
};

/// Two effects of usual size of which one explains what the other does to a recording.
struct Inseparable {
  plant::EffectId one, other;
  double left;  ///< smaller remainder of both ways round, over the noise that is expected
  Remedy remedy;
};

struct WhatCanBeTold {
  std::vector<EffectVisibility> effects;       ///< that the recorded columns may show
  std::vector<plant::EffectId> other_columns;  ///< effects that show on columns alone that were not recorded
  std::vector<Inseparable> pairs;              ///< the most alike first
};

/// An effect of a set, and what would tell it from others if this recording does not.
struct ToldMember {
  MemberVisibility seen;
  Remedy remedy;
};

/// Says before any verdict which effects a recording can show and tell apart: see effect_visibilities(). For a pair that it
/// does not tell apart, what would: a column that was not recorded, else an experiment (telling_experiment()). Refused recordings and those that move too little are the caller's business, as for diagnose().
WhatCanBeTold what_can_be_told(const Recording& recording, const robot::Joint& joint, const DiagnosisOptions& options);

/// Says the same of the effects of a set, each of its usual size: see member_visibilities(). `set` has no effect twice, and
/// effects of can_be_asked() alone.
std::vector<ToldMember> what_can_be_told(const Recording& recording, const robot::Joint& joint,
                                         const std::vector<plant::EffectId>& set, const DiagnosisOptions& options);

/// Effects that a set for what_can_be_told() may have: those that such a joint can have and its file does not.
std::vector<plant::EffectId> can_be_asked(const robot::Joint& joint);

}  // namespace farrier::diagnosis
