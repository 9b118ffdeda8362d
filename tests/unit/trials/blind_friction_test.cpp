// Blind trials of dry friction on the load: a level one, and one that swings with the position.

#include <gtest/gtest.h>

#include "trials/blind/blind_trials.hpp"
#include "trials/blind/score.hpp"

namespace farrier::blind {
namespace blind_friction_test {

Outcome outcome_of(const char* effect, int magnitude, std::size_t joint) {
  const robot::Robot rig = robot::load_robot(FARRIER_ROBOTS "fc1d.yaml").value();
  const robot::Robot legs = robot::load_robot(FARRIER_ROBOTS "hyq.yaml", {.without_effects = true}).value();
  const truth::Plan plan{200213, truth::Excitation::kMultisine, {{effect, magnitude}}, 5.0};
  return run_trial({Kind::kEffect, joint, plan}, {&rig.joints.front(), &legs.joints.front()});
}

TEST(BlindFriction, ThatSwingsWithThePositionIsNamedWithItsMean) {
  for (std::size_t joint = 0; joint < 2; ++joint) {
    const Outcome outcome = outcome_of("position_dependent_friction", 1, joint);
    EXPECT_TRUE(first_alone(outcome)) << confusion_page({outcome});
    EXPECT_EQ(outcome.verdict, diagnosis::Verdict::kEffects);
    EXPECT_LT(outcome.parameter_error, 0.1) << joint;
  }
}

TEST(BlindFriction, ThatIsLevelIsNoWave) {
  const Outcome outcome = outcome_of("load_friction", 2, 0);
  EXPECT_TRUE(first_alone(outcome)) << confusion_page({outcome});
  EXPECT_TRUE(outcome.alternatives.empty()) << confusion_page({outcome});
  EXPECT_GT(outcome.named.front().confidence, kConfident);
}

}  // namespace blind_friction_test
}  // namespace farrier::blind
