#pragma once

// Conditions under which claims hold that the text states without them. At most six serve all claims, each from the text
// or a data sheet, and none serves one claim alone. Tests enforce both.

#include <cstddef>
#include <span>

namespace farrier::thesis {

inline constexpr std::size_t kMostConditions = 6;

/// A line of conditions.cpp for each.
enum class Condition {
  kProbedValve,
  kLinearPlant,
  kPerfectMeasurements,
  kDataSheetValve,
  kViscousFriction,
};

struct ConditionSpec {
  Condition condition;
  const char* name;     ///< a word or two, as a verdict names it: "strong filters"
  const char* meaning;  ///< what the run has that the text does not state, as a sentence
  const char* source;   ///< the section of the text, or the data sheet, that gives it
};

std::span<const ConditionSpec> conditions() noexcept;
const ConditionSpec& spec_of(Condition condition) noexcept;

}  // namespace farrier::thesis
