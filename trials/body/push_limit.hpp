#pragma once

#include <array>
#include <optional>
#include <span>
#include <vector>

#include "trials/body/trot_trial.hpp"

namespace farrier::trials {

/// Bounds on the impulse from one side at which half of the pushes fall.
struct PushLimit {
  const char* side;
  double fewer_Ns;                ///< largest tested impulse at which fewer than half fell
  std::optional<double> half_Ns;  ///< least tested impulse at which half fell or more; none up to the largest
};

/// Searches that impulse by bisection, for all sides at once: a round is one impulse per side at every phase of the
/// stride, so that its runs may go at the same time.
class PushLimitSearch {
 public:
  static constexpr const char* kTrial = "push_limit";
  static constexpr double kLargest_Ns = 480.0;  ///< of HyQ, 5.7 m/s; the first round
  static constexpr double kResolution_Ns = 7.5;

  /// The robot needs body and locomotion, and must outlive the search.
  explicit PushLimitSearch(const robot::Robot& robot);

  /// Cases of the next round; none: the search has ended.
  std::vector<TrotCase> next() const;

  /// Takes the rows of that round, in any order; a case without a row, or with a failure, counts as a fall.
  void take(std::span<const TrotRow> rows);

  /// After any number of rounds, in the order of kPushSides.
  std::vector<PushLimit> limits() const;

 private:
  /// In steps of kResolution_Ns.
  struct Interval {
    int fewer = 0;
    std::optional<int> half;
    bool ended() const noexcept { return half ? *half - fewer <= 1 : fewer > 0; }
    int next() const noexcept;
  };

  double impulse_Ns(int steps) const;

  const robot::Robot& robot_;
  std::array<Interval, kPushSides.size()> sides_{};
};

}  // namespace farrier::trials
