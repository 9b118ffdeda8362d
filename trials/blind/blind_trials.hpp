#pragma once

// Trials of the diagnosis against recordings in which an effect is hidden. The recordings come from trials/truth, which
// shares no equation with what is judged; the diagnosis gets the recording and the nominal joint and nothing else.

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "diagnosis/judge/diagnosis.hpp"
#include "trials/tracking_gain.hpp"
#include "trials/truth/truth.hpp"

namespace farrier::blind {

/// Kinds of hidden content in a trial.
enum class Kind { kNone, kEffect, kSet, kOutside };

struct TrialPlan {
  Kind kind;
  std::size_t joint;  ///< which of those that trials are made of
  truth::Plan plan;
};

struct Named {
  std::string name;
  double value, confidence;
  diagnosis::Evidence evidence = {};
  /// The fitted number: its calibrated deviation, that of the fit, and its distance from neutral.
  double deviation = 0.0, fit_deviation = 0.0, distance = 0.0;
  /// Where the effect is hidden: distance of the fitted number from the true one, and that of the value from the hidden
  /// one over the hidden one's distance from neutral.
  std::optional<double> fit_error = {}, size_error = {};
};

struct Outcome {
  TrialPlan plan;
  std::vector<truth::Answer> answers;
  /// By how much the hidden effects change the held-out error of the nominal model, its constants fitted: error with
  /// them over that without, less one; the largest over channels.
  double detectable = 0.0;
  /// Hidden effects of a set that the recording does not tell from the rest and from others, by their hidden sizes. It is known
  /// before the diagnosis (diagnosis::member_visibilities). Empty: the set is separable, or the trial has no set.
  std::vector<std::string> inseparable;
  diagnosis::Verdict verdict = diagnosis::Verdict::kNone;
  std::vector<Named> named;
  std::vector<std::pair<std::string, std::string>> alternatives;
  double parameter_error = 0.0;  ///< of the first named, when it is the hidden one: of its distance from neutral
  double error_before = 0.0, error_after = 0.0;
  double cpu_s = 0.0;  ///< of the diagnosis, on one thread
  /// Gain of a controller that knows the named effects, if it can use one of them (control::is_compensated) and the
  /// hidden ones are of the library. Both controllers control the nominal joint with the hidden effects. The headline
  /// parameter is that of the answer, others are as found, or else plant::default_value.
  std::optional<trials::TrackingGain> control;
  std::string refused;  ///< why the trial could not be made; empty: it was
};

/// The least seed of trials that calibrate confidences: tests of them have lower ones.
inline constexpr std::uint64_t kCalibrationSeed = 100001;

/// Every effect of the library at three magnitudes under three excitations, and 60 trials with none. Then sets of two to
/// five effects of medium and large size, and 36 trials with an effect outside the library. They are of `joints` joints in
/// turn. Their seeds are `seed` and the next ones.
std::vector<TrialPlan> all_trials(std::size_t joints, std::uint64_t seed);

/// The same of electric joints, each with every effect that it can have: 24 trials with none, 24 with sets of two to four,
/// and three with each effect outside the library.
std::vector<TrialPlan> all_electric_trials(const std::vector<const robot::Joint*>& joints, std::uint64_t seed);

/// Trials of `robots` robots with these joints in which nothing is hidden, robot by robot: each robot is off its file in its
/// own way. Their seeds are `seed` and the next ones, a multiple of the joints and one for each.
std::vector<TrialPlan> healthy_trials(std::size_t joints, std::size_t robots, std::uint64_t seed);

/// Returns the recording that the diagnosis gets of a truth's samples: current, position, velocity and force.
diagnosis::Recording recording_of(const truth::Samples& samples);

/// The first `count` of the trials in an order in which each stretch of them is spread over all, so that figures mean
/// something before the last; 0: all.
std::vector<TrialPlan> mixed(const std::vector<TrialPlan>& all, int count);

/// `joints` outlive the call; nominal ones.
Outcome run_trial(const TrialPlan& plan, const std::vector<const robot::Joint*>& joints);

/// Outcome::refused of a trial that was not begun.
inline constexpr const char* kNotRun = "not run";

/// Runs trials on `threads` threads. `done` gets each outcome with its index, by one thread at a time; if it returns false,
/// no other trial begins and the rest are kNotRun. A trial that throws a std::exception is refused.
std::vector<Outcome> run_trials(const std::vector<TrialPlan>& plans, const std::vector<const robot::Joint*>& joints,
                                int threads, const std::function<bool(std::size_t, const Outcome&)>& done);

}  // namespace farrier::blind
