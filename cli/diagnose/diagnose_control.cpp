#include "cli/diagnose/diagnose_control.hpp"

#include "control/law/effect_compensation.hpp"
#include "trials/tracking_gain.hpp"
#include "robot/joint_effects.hpp"

namespace farrier::cli {

std::optional<report::ControlGain> control_gain(const robot::Robot& robot, const robot::Joint& joint,
                                                const diagnosis::Diagnosis& found) {
  const std::vector<plant::ActiveEffect> effects = diagnosis::found_effects(found, joint);
  std::string names;
  for (const plant::ActiveEffect& effect : effects) {
    if (control::is_compensated(effect.id)) {
      names += (names.empty() ? "" : ", ") + std::string(effect.info().name);
    }
  }
  const auto known = robot::with_effects(joint, effects);
  if (names.empty() || !known) {
    return std::nullopt;
  }
  const auto gain = trials::tracking_gain(known.value(), joint, known.value(), {.period_s = robot.period_s});
  return gain ? std::optional<report::ControlGain>({names, gain.value().old_nrmse, gain.value().new_nrmse})
              : std::nullopt;
}

}  // namespace farrier::cli
