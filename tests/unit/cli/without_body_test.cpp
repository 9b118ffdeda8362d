#include <gtest/gtest.h>

#include "cli/base/command.hpp"
#include "cli/trial/body_trial.hpp"

namespace farrier::cli {
namespace without_body_test {

TEST(BodyTrialWithoutMuJoCo, IsRefusedByNameWithTheRemedy) {
  testing::internal::CaptureStderr();
  EXPECT_EQ(run_body_trials({}), kBadInput);
  EXPECT_EQ(testing::internal::GetCapturedStderr(),
            "farrier trial: trial body needs MuJoCo 2.2.2, and this build has none: install libmujoco-dev and build "
            "again, as ./farrier trial body does\n");
}

}  // namespace without_body_test
}  // namespace farrier::cli
