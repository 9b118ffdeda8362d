#pragma once

#include "signals/signals.hpp"

namespace farrier::supervisor {

/// A decision with what it takes over from the estimate it is about; the rest is the judge's.
signals::JointUpdateDecision record_of(const signals::JointModelEstimate& estimate, Tick tick) noexcept;

/// Which decisions of a slot are news: those that are accepted, and refusals of a design for another reason than the one
/// before. What an estimate lacks is none.
class UpdateNews {
 public:
  /// Takes a decision; true when it is news.
  bool take(signals::UpdateVerdict verdict) noexcept;
  /// What the last take() said.
  bool is_news() const noexcept { return is_news_; }

 private:
  signals::UpdateVerdict last_ = signals::UpdateVerdict::kAccepted;  // accepted or refused
  bool is_news_ = false;
};

}  // namespace farrier::supervisor
