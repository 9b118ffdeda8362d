#pragma once

// Conditions under which an estimate leads to new gains: the judging part of the update logics (a) to (d) of Hubacher
// (2014), Section 5.3.1. Each is a class with the same four functions, and Method one of them:
//
//   estimate ──▶ before_design() ──▶ design ──▶ after_design() ──▶ safe? ──▶ stored, accepted()

#include <variant>

#include "robot/sections/adaptation_section.hpp"
#include "signals/signals.hpp"
#include "supervisor/pole_set.hpp"

namespace farrier::supervisor {

/// Judged properties of a usable estimate: finite, of positive validity and valve gain.
struct Evidence {
  double prediction_error, whiteness;  ///< of the estimate
  bool valid;                          ///< enough for a design, validity_min
  PoleSet poles;
  double pole_distance;                ///< from those the acting gains are designed for
  double gain_ratio;                   ///< of the valve's gain to the one they are designed for, upper end
};

/// Duration for which a condition has held, by the ticks of the estimates.
class Held {
 public:
  explicit Held(int estimate_period_ticks) noexcept : period_ticks_(estimate_period_ticks) {}

  void again() noexcept { ticks_ = ticks_ < 0 ? 0 : ticks_ + period_ticks_; }
  void from_now() noexcept { ticks_ = 0; }
  void never() noexcept { ticks_ = kNever; }
  bool ever() const noexcept { return ticks_ != kNever; }
  /// Since the first estimate for which it held; kNever: not at present.
  int ticks() const noexcept { return ticks_; }

 private:
  static constexpr int kNever = -1;
  int period_ticks_;
  int ticks_ = kNever;
};

/// (a) A controller is designed for every estimate. It acts when its gains are bounded and have changed slowly from
/// estimate to estimate for converged_ticks. The norm of the state gains, the integral gain and the feed-forward are
/// judged separately.
class LimitedGains {
 public:
  LimitedGains(const robot::UpdateLogicParams& logic, int estimate_period_ticks, double estimate_period_s) noexcept;

  signals::UpdateVerdict before_design(const Evidence& evidence) noexcept;
  signals::UpdateVerdict after_design(const control::Gains& gains) noexcept;
  void accepted() noexcept {}
  void restart() noexcept { held_.never(); }
  int held_ticks() const noexcept { return held_.ticks(); }
  double spread() const noexcept { return 0.0; }

 private:
  struct Parts {
    Eigen::Vector3d state;
    double integral, feed_forward;
  };

  bool slow(const Parts& now) const noexcept;

  robot::UpdateLogicParams logic_;
  double estimate_period_s_;
  Held held_;
  Parts last_{};          // read when held_.ever()
  bool designed_ = true;  // for the last estimate
};

/// (b) The estimate has predicted the force to within prediction_error_max for converged_ticks, and for (c) with errors
/// of a whiteness of whiteness_min at least.
class PredictionError {
 public:
  PredictionError(const robot::UpdateLogicParams& logic, int estimate_period_ticks) noexcept;

  signals::UpdateVerdict before_design(const Evidence& evidence) noexcept;
  signals::UpdateVerdict after_design(const control::Gains&) noexcept { return signals::UpdateVerdict::kAccepted; }
  void accepted() noexcept {}
  void restart() noexcept { held_.never(); }
  int held_ticks() const noexcept { return held_.ticks(); }
  double spread() const noexcept { return 0.0; }

 private:
  robot::UpdateLogicParams logic_;
  Held held_;
};

/// (d) The estimate's poles are far from those designed for, or its valve gain is, and they have been steady for
/// converged_ticks (8.2.1, Fig. 8.8, F.2).
class DistinctPoles {
 public:
  DistinctPoles(const robot::UpdateLogicParams& logic, control::Form form, int estimate_period_ticks) noexcept;

  signals::UpdateVerdict before_design(const Evidence& evidence) noexcept;
  signals::UpdateVerdict after_design(const control::Gains&) noexcept { return signals::UpdateVerdict::kAccepted; }
  void accepted() noexcept { restart(); }
  void restart() noexcept { held_.never(); }
  int held_ticks() const noexcept { return held_.ticks(); }
  double spread() const noexcept { return spread_; }

 private:
  void follow(const PoleSet& poles) noexcept;

  robot::UpdateLogicParams logic_;
  control::Form form_;
  Held held_;
  PoleSet anchor_{};   // the poles' places when they began to count as steady
  double spread_ = 0;  // their largest distance from there
};

/// One slot's method. The call before_design() returns kAccepted if a controller shall be designed for the estimate.
/// The call after_design() returns kAccepted if the method lets the gains act. Call accepted() when they act, restart()
/// when the sample was no estimate. The result of held_ticks() is the time for which the method's condition has held,
/// -1 if it does not at present. The result of spread() is the poles' spread meanwhile, 0 for methods without poles.
using Method = std::variant<LimitedGains, PredictionError, DistinctPoles>;

Method make_method(const robot::UpdateLogicParams& logic, control::Form form, int estimate_period_ticks,
                         double estimate_period_s) noexcept;

}  // namespace farrier::supervisor
