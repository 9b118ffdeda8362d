#include "thesis/study/conditions.hpp"

#include <algorithm>

#include "core/ensure.hpp"

namespace farrier::thesis {
namespace {

constexpr ConditionSpec kConditions[] = {
    {Condition::kStrongFilters, "strong filters",
     "Position, velocity and force pass filters of the first order at 20 Hz before they reach the estimator.",
     "10.2: \"We used a rather aggressive filter\", without a number"},
};

}  // namespace

std::span<const ConditionSpec> conditions() noexcept { return kConditions; }

const ConditionSpec& spec_of(Condition condition) noexcept {
  const auto* const found = std::ranges::find(kConditions, condition, &ConditionSpec::condition);
  FARRIER_ENSURE(found != std::end(kConditions), "a condition without a line in conditions.cpp");
  return *found;
}

}  // namespace farrier::thesis
