#include "supervisor/succession.hpp"

#include <algorithm>

namespace farrier::supervisor {

void Succession::heard(std::uint32_t authority, SteadyTime now) noexcept {
  if (leads_) {
    if (authority < authority_) {
      rewrite_until_ = now + kRewriteFor;  // a stronger writer that was replaced writes: readers may hear it alone
    }
  } else if (authority >= authority_) {
    authority_ = authority;
    heard_ = now;
  }
}

Duty Succession::step(std::uint32_t newest, SteadyTime now) noexcept {
  if (leads_) {
    if (newest > authority_) {
      leads_ = false;
      authority_ = newest;
      heard_ = now;
      return Duty::kStandDown;
    }
    if (now < rewrite_until_ && now >= next_rewrite_) {
      next_rewrite_ = now + kRewritePeriod;
      return Duty::kRewrite;
    }
    return Duty::kNone;
  }
  if (authority_ == 0 && newest == 0) {
    if (stands_by_) {
      return Duty::kNone;
    }
    leads_ = true;  // the first of a run
    authority_ = 1;
    return Duty::kNone;
  }
  if (heard_ == SteadyTime{} || newest > authority_) {
    authority_ = std::max(authority_, newest);
    heard_ = now;
  }
  if (now - heard_ <= kSilence) {
    return Duty::kNone;
  }
  leads_ = true;
  ++authority_;
  rewrite_until_ = now + kRewriteFor;
  next_rewrite_ = now + kRewritePeriod;
  return Duty::kTakeOver;
}

}  // namespace farrier::supervisor
