#pragma once

// What `farrier trial` found: one trial for every seed.

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "core/result.hpp"
#include "report/figures/figures.hpp"

namespace farrier::report {

/// What the recording of one joint said.
struct JointVerdict {
  std::string joint;
  std::string verdict;               ///< diagnosis::to_string(Verdict)
  std::vector<std::string> effects;  ///< named, by name, the largest share of the gain first
  std::vector<std::string> tied;     ///< that the recording does not tell from one of them
  double gain = 0.0;                 ///< held out: sum over the channels of ln(rms before / rms after)

  /// It says that the joint is not as its file says.
  bool suspects() const;
};

struct HideTrial {
  std::uint64_t seed = 0;
  std::string joint, effect;     ///< hidden
  std::string parameter, unit;   ///< the effect's first
  double value = 0.0;            ///< of it
  std::vector<JointVerdict> verdicts;  ///< of every joint
  /// Stance NRMSE of the hidden joint: in the nominal world, in the hidden one, and there with the model that was found
  /// in everybody's robot file; the last is that of the hidden world where nothing was found.
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

/// Of twelve trials eleven are to be named.
double least_named(std::size_t trials);
/// Untouched joints that may be suspected: one in twelve trials.
double most_false_joints(std::size_t trials);
/// From so many trials on the model that was found must bring back half of the tracking that the effects took.
inline constexpr std::size_t kSeedsForTracking = 12;

/// Adds hide.*; at least one trial.
void add_hide(Figures& figures, std::span<const HideTrial> trials);

/// For people: what was hidden, a line per joint for one trial, a line per trial for several.
std::string hide_text(std::span<const HideTrial> trials);

/// Every joint of every trial as CSV with a header line. Refuses what the disk does not take.
Result<Done> write_hide_csv(const std::string& path, std::span<const HideTrial> trials);

}  // namespace farrier::report
