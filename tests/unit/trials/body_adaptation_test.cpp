#include <gtest/gtest.h>

#include "trials/body/compared_runs.hpp"

namespace farrier::trials {
namespace body_adaptation_test {

// Estimates of a coupled body are judged by the update logic, and those that are not valid become no gains.
TEST(BodyAdaptation, TakesNoGainsFromAnEstimateThatIsNotValid) {
  robot::Robot hyq = robot::load_robot(FARRIER_ROBOTS "hyq.yaml", {.on_ground = true}).value();
  for (robot::Joint& joint : hyq.joints) {
    joint.kind = control::Kind::kLqr;
  }
  TrotCase one = compared_cases(hyq, 1).front();
  one.judged_until_s = one.end_s = one.trot_s + 3.0;
  one.adapts = true;
  const TrotFigures figures = run_trot_case(hyq, one, Joints::kActuators).value().value();
  EXPECT_FALSE(figures.fell_s.has_value()) << *figures.fell_s;
  const AdaptationCounts counts = figures.adaptation.value();
  EXPECT_EQ(counts.estimates, 12 * static_cast<int>(one.end_s / hyq.period_s) / hyq.estimate_period_ticks);
  EXPECT_LT(counts.valid, counts.estimates / 2);
  EXPECT_EQ(counts.invalid_updates, 0);
  EXPECT_EQ(counts.gains_refused, 0);
}

}  // namespace body_adaptation_test
}  // namespace farrier::trials
