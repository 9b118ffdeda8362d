#pragma once

// A claim of Hubacher (2014), and its verdicts.

#include <optional>

#include "thesis/study/conditions.hpp"

namespace farrier::thesis {

/// Relation of a measured value to a claim's bound.
enum class Relation { kAtMost, kBelow, kAtLeast };

/// The author of a claim. The kinds are counted apart.
enum class ClaimKind {
  kText,   ///< the thesis
  kProof,  ///< Farrier: a measurement that shows why a claim of the text is as it is
  kAim,    ///< Farrier: a property that the text wishes for and its own method lacks
};

enum class Verdict {
  kHolds,
  kNeeds,    ///< holds only under a condition that the text does not state
  kRefuted,  ///< contradicted by a proof that rests on no choice of ours
  kFails,
};

/// "text", "proof", "aim".
const char* to_string(ClaimKind kind) noexcept;
/// "holds", "needs", "refuted", "fails".
const char* to_string(Verdict verdict) noexcept;

/// Why a claim is false as printed, and the range of the value if the proof is right. A value elsewhere fails.
struct Refutation {
  const char* proof;  ///< or counter-example, as a sentence; it rests on nothing that Farrier chose
  double at_least;
  double at_most;
};

/// The least distance of a refutation's range from its claim's bound, over the distance of the range's far end.
inline constexpr double kRefutationGap = 0.25;

/// A number or relation, and what is measured for it.
struct ClaimSpec {
  const char* id;        ///< the figure's number and a name: "7.8.quarter_2"; "reproduce." before it names the figure
  const char* section;   ///< where it is said: "7.5", "Fig. 7.8"
  const char* sentence;  ///< the text's own words, shortened with "..."
  const char* claim;     ///< what is measured, and how it must relate to the bound, as a sentence
  const char* unit;      ///< of value and bound; "1" for ratios, counts and decisions (1 yes, 0 no)
  Relation relation;
  double bound;
  std::optional<Refutation> refutation = std::nullopt;
  std::optional<Condition> condition = std::nullopt;  ///< the study also measures the value under it
  ClaimKind kind = ClaimKind::kText;
  const char* tried = "";  ///< of a claim that fails: what was tried to make it hold, and what came of it
};

/// Our own claims, from their lines: proof({"9.11.lines", ...}).
constexpr ClaimSpec proof(ClaimSpec spec) {
  spec.kind = ClaimKind::kProof;
  return spec;
}
constexpr ClaimSpec aim(ClaimSpec spec) {
  spec.kind = ClaimKind::kAim;
  return spec;
}

/// A claim that is measured under a condition, too: needs(Condition::kPerfectMeasurements, {"9.7.rises", ...}).
constexpr ClaimSpec needs(Condition condition, ClaimSpec spec) {
  spec.condition = condition;
  return spec;
}

/// A claim that is known to fail: fails("what was tried", {"6.1.order", ...}).
constexpr ClaimSpec fails(const char* tried, ClaimSpec spec) {
  spec.tried = tried;
  return spec;
}

/// True if the claim's relation holds of `value`; false if that is not finite.
bool holds(const ClaimSpec& claim, double value) noexcept;

/// True if `a` is further from failing the claim than `b`. A value that is not finite is the worst.
bool better(const ClaimSpec& claim, double a, double b) noexcept;

/// A claim by its value, and by that under its condition if it has one. It holds when its relation does, else is refuted
/// when the value is where the refutation says, else needs its condition when the relation holds under that, else fails.
/// A value that is not finite fails.
Verdict judge(const ClaimSpec& claim, double value, std::optional<double> under_condition = std::nullopt) noexcept;

/// True if a refutation's range is finite, violates the bound and keeps kRefutationGap from it.
bool keeps_its_gap(const ClaimSpec& claim) noexcept;

}  // namespace farrier::thesis
