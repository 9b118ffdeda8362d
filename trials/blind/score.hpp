#pragma once

#include <map>
#include <string>
#include <vector>

#include "trials/blind/blind_trials.hpp"

namespace farrier::blind {

/// A trial counts when its hidden effects change the held-out error by more than this.
inline constexpr double kDetectable = 0.10;
inline constexpr double kParameterTolerance = 0.15;
inline constexpr double kConfident = 0.9;
inline constexpr std::size_t kLargestSet = 5;

/// True if such an effect is hidden.
bool hides(const Outcome& outcome, const std::string& name);

/// Distance of a value from the true one over the true one's distance from neutral.
double size_error(const plant::Parameter& parameter, double value, double truth, const plant::Scales& scales);

/// The hidden effect is named first and no other stands beside it as an alternative.
bool first_alone(const Outcome& outcome);
/// It is named first, or in a set of two that the recording does not tell apart.
bool named_or_in_pair(const Outcome& outcome);
/// A set is hidden whose effects the recording can separate.
bool separable_set(const Outcome& outcome);
/// Every hidden effect is among the named.
bool all_named(const Outcome& outcome);
/// An effect that is not hidden is named with more than kConfident.
bool confidently_wrong(const Outcome& outcome);

/// Shares over trials; a share of no trial is not a number.
struct Score {
  std::size_t trials = 0, counted = 0;  ///< counted: single effects that change the held-out error enough
  double named = 0.0, first_alone = 0.0, within_tolerance = 0.0;
  double false_alarms = 0.0;      ///< of trials with none
  double outside_unknown = 0.0;   ///< of detectable trials with an outside effect
  double outside_admitted = 0.0;  ///< unknown or cannot_separate, of detectable trials with an outside effect
  std::map<std::size_t, double> sets_named;  ///< all names, of detectable sets, by their size
  /// The same of the sets that their recordings can separate, and how many these are, detectable or not.
  std::map<std::size_t, double> separable_named;
  std::map<std::size_t, std::size_t> separable;
  double set_names_wrong = 0.0;  ///< of the names in these trials: no such effect is hidden
  double median_s = 0.0;         ///< processor time of a diagnosis
  /// Distance of a named value from the hidden one over its distance from neutral, of all names that are hidden; median.
  double median_size_error = 0.0;
  double confidently_wrong = 0.0;  ///< of all trials
  std::size_t controlled = 0;      ///< trials in which something was named that a controller can use
  double control_gain = 0.0;       ///< of those: tracking error without that knowledge over that with it, median
  double median_gain = 0.0;        ///< held-out error before over after, of detectable trials with an effect
};

Score score(const std::vector<Outcome>& outcomes);

/// Alarms among healthy robots: a verdict other than none for any joint of a robot is an alarm.
struct Alarms {
  std::size_t robots = 0, joints = 0;  ///< robots of which every joint was diagnosed, and all joints that were
  std::size_t alarms = 0, joint_alarms = 0;
  double rate_high = 0.0;  ///< upper end of the 95 % interval of the share of robots with an alarm (Wilson 1927)
  double median_s = 0.0;   ///< processor time of a joint's diagnosis
};

/// Alarms of trials in the order of robots of `joints` joints; the last robot may be incomplete.
Alarms alarms_of(const std::vector<Outcome>& outcomes, std::size_t joints);

/// Score of the single-effect trials of each effect.
std::map<std::string, Score> score_by_effect(const std::vector<Outcome>& outcomes);

/// Markdown table of hidden effects against those named first, and every trial that went wrong.
std::string confusion_page(const std::vector<Outcome>& outcomes);

}  // namespace farrier::blind
