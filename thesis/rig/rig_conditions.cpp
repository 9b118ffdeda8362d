#include "thesis/rig/rig_conditions.hpp"

#include <algorithm>
#include <utility>

namespace farrier::thesis {
namespace {

constexpr double kDataSheetOverRig = 4.0;  // K_v of Table A.1 over that of Table A.2

const Measured* find_measured(const StudyResult& result, std::string_view id) {
  const auto found = std::ranges::find(result.measured, id, &Measured::id);
  return found == result.measured.end() ? nullptr : &*found;
}

}  // namespace

robot::Robot under(Condition condition, robot::Robot rig) {
  robot::Joint& joint = rig.joints[0];
  switch (condition) {
    case Condition::kPerfectMeasurements:
      joint.noise = {};
      joint.sensors = {};
      break;
    case Condition::kDataSheetValve:
      joint.actuator.valve_gain *= kDataSheetOverRig;
      break;
    case Condition::kViscousFriction:
      std::erase_if(joint.effects,
                    [](const plant::ActiveEffect& has) { return has.id == plant::effect_id<plant::LoadFriction>(); });
      break;
    default:
      break;
  }
  return rig;
}

Result<StudyResult> measure_on(const robot::Robot& rig, std::span<const ClaimSpec> claims, const OnRig& measure) {
  StudyResult result = FARRIER_TRY(measure(rig));
  for (const ConditionSpec& condition : conditions()) {
    const auto is_its = [&](const ClaimSpec& claim) { return claim.condition == condition.condition; };
    if (std::ranges::none_of(claims, is_its)) {
      continue;
    }
    const StudyResult again = FARRIER_TRY(measure(under(condition.condition, rig)));
    bool needed = false;
    for (Measured& one : result.measured) {
      const auto claim =
          std::ranges::find_if(claims, [&](const ClaimSpec& spec) { return spec.id == one.id && is_its(spec); });
      const Measured* value = find_measured(again, one.id);
      if (claim != claims.end() && value != nullptr) {
        one.under_condition = value->value;
        needed = needed || judge(*claim, one.value, value->value) == Verdict::kNeeds;
      }
    }
    for (std::size_t i = 0; needed && i < again.pictures.size(); ++i) {
      result.pictures.push_back(again.pictures[i]);
      result.pictures.back().caption += std::string(". With ") + condition.name;
    }
  }
  return result;
}

}  // namespace farrier::thesis
