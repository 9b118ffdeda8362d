#include "thesis/study/claim.hpp"

#include <cmath>

namespace farrier::thesis {

const char* to_string(ClaimKind kind) noexcept {
  switch (kind) {
    case ClaimKind::kText:
      return "text";
    case ClaimKind::kProof:
      return "proof";
    case ClaimKind::kAim:
      return "aim";
  }
  return "";
}

const char* to_string(Verdict verdict) noexcept {
  switch (verdict) {
    case Verdict::kHolds:
      return "holds";
    case Verdict::kNeeds:
      return "needs";
    case Verdict::kRefuted:
      return "refuted";
    case Verdict::kFails:
      return "fails";
  }
  return "";
}

bool holds(const ClaimSpec& claim, double value) noexcept {
  if (!std::isfinite(value)) {
    return false;
  }
  switch (claim.relation) {
    case Relation::kAtMost:
      return value <= claim.bound;
    case Relation::kBelow:
      return value < claim.bound;
    case Relation::kAtLeast:
      return value >= claim.bound;
  }
  return false;
}

bool better(const ClaimSpec& claim, double a, double b) noexcept {
  if (!std::isfinite(a) || !std::isfinite(b)) {
    return std::isfinite(a) && !std::isfinite(b);
  }
  return claim.relation == Relation::kAtLeast ? a > b : a < b;
}

Verdict judge(const ClaimSpec& claim, double value, std::optional<double> under_condition) noexcept {
  if (!std::isfinite(value)) {
    return Verdict::kFails;
  }
  if (holds(claim, value)) {
    return Verdict::kHolds;
  }
  const auto& refutation = claim.refutation;
  if (refutation && value >= refutation->at_least && value <= refutation->at_most) {
    return Verdict::kRefuted;
  }
  const bool needs = claim.condition && under_condition && holds(claim, *under_condition);
  return needs ? Verdict::kNeeds : Verdict::kFails;
}

bool keeps_its_gap(const ClaimSpec& claim) noexcept {
  if (!claim.refutation) {
    return true;
  }
  const Refutation& range = *claim.refutation;
  const bool above = claim.relation != Relation::kAtLeast;  // a value above the bound violates it
  const double near = above ? range.at_least - claim.bound : claim.bound - range.at_most;
  const double far = above ? range.at_most - claim.bound : claim.bound - range.at_least;
  return std::isfinite(far) && near > 0.0 && near <= far && near >= kRefutationGap * far;
}

}  // namespace farrier::thesis
