#pragma once

#include "signals/signals.hpp"

namespace farrier::supervisor {

/// A decision with the values it copies from its estimate; the judge fills in the rest.
signals::JointUpdateDecision record_of(const signals::JointModelEstimate& estimate, Tick tick) noexcept;

/// Decides which decisions of a slot are news: accepted ones, and refusals of a design for another reason than the one
/// before. A deficient estimate is no news.
class UpdateNews {
 public:
  /// Takes a decision; true when it is news.
  bool take(signals::UpdateVerdict verdict) noexcept;
  /// Result of the last take().
  bool is_news() const noexcept { return is_news_; }

 private:
  signals::UpdateVerdict last_ = signals::UpdateVerdict::kAccepted;  // accepted or refused
  bool is_news_ = false;
};

}  // namespace farrier::supervisor
