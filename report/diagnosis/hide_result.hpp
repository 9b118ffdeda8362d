#pragma once

// Result of `farrier trial`: one trial for every seed.

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "core/result.hpp"
#include "report/figures/figures.hpp"

namespace farrier::report {

/// Diagnosis of one joint's recording.
struct JointVerdict {
  std::string joint;
  std::string verdict;               ///< diagnosis::to_string(Verdict)
  std::vector<std::string> effects;  ///< named, by name, the largest share of the gain first
  std::vector<std::string> tied;     ///< that the recording cannot separate from one of them
  double gain = 0.0;                 ///< held out: sum over the channels of ln(rms before / rms after)

  /// True if the diagnosis finds that the joint differs from its file.
  bool suspects() const;
};

struct HideTrial {
  std::uint64_t seed = 0;
  std::string joint, effect;     ///< hidden
  std::string parameter, unit;   ///< the effect's first
  double value = 0.0;            ///< of it
  std::vector<JointVerdict> verdicts;  ///< of every joint
  /// Stance NRMSE of the hidden joint: in the nominal world, in the hidden one, and there with the model that was found
  /// in every process's robot file. If nothing was found, the last is that of the hidden world.
  double nrmse_nominal = 0.0, nrmse_hidden = 0.0, nrmse_known = 0.0;

  /// The joint with the largest gain of those that are suspected; null for none.
  const JointVerdict* suspect() const;
  /// Joint and effect are named: the suspect is the hidden joint, and its first effect the hidden one.
  bool named() const;
  /// Named, or tied with what is.
  bool named_or_tied() const;
  /// Other joints that are suspected.
  std::size_t false_joints() const;
};

/// Bound on named trials: eleven of twelve.
double least_named(std::size_t trials);
/// Untouched joints that may be suspected: one in twelve trials.
double most_false_joints(std::size_t trials);
/// Number of trials from which on the model found must restore half of the tracking that the effects took.
inline constexpr std::size_t kSeedsForTracking = 12;

/// Adds hide.*; at least one trial.
void add_hide(Figures& figures, std::span<const HideTrial> trials);

/// Text for people: the hidden effects, a line per joint for one trial, a line per trial for several.
std::string hide_text(std::span<const HideTrial> trials);

/// Every joint of every trial as CSV with a header line. Refuses if the disk does not take all of it.
Result<Done> write_hide_csv(const std::string& path, std::span<const HideTrial> trials);

}  // namespace farrier::report
