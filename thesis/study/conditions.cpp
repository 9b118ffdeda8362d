#include "thesis/study/conditions.hpp"

#include <algorithm>

#include "core/ensure.hpp"

namespace farrier::thesis {
namespace {

constexpr ConditionSpec kConditions[] = {
    {Condition::kProbedValve, "probed valve",
     "A random binary signal of 0.25 % of the nominal current is added to the valve's current.",
     "6.3.1: white noise at the valve, of 5 % there; 7.5 mentions none"},
    {Condition::kLinearPlant, "linear plant",
     "The plant is the linear model that the gains are designed on, that of an extending valve, for both signs.",
     "3.3: the model (3.51) of the design; 7.3 does not say on which model its responses are simulated"},
    {Condition::kPerfectMeasurements, "perfect measurements", "Sensors give the truth at every tick, without filters.",
     "6.3: \"measurements are perfect\""},
    {Condition::kDataSheetValve, "the data sheet's valve",
     "The valve passes the flow of its data sheet, four times that which was fitted to the rig.",
     "Table A.1; Table A.2 fits a quarter, \"absolutely no meaning\""},
    {Condition::kViscousFriction, "viscous friction alone", "The cart has no dry friction.", "2.1, (2.5): d_l alone"},
};

}  // namespace

std::span<const ConditionSpec> conditions() noexcept { return kConditions; }

const ConditionSpec& spec_of(Condition condition) noexcept {
  const auto* const found = std::ranges::find(kConditions, condition, &ConditionSpec::condition);
  FARRIER_ENSURE(found != std::end(kConditions), "a condition without a line in conditions.cpp");
  return *found;
}

}  // namespace farrier::thesis
