#pragma once

#include <gtest/gtest.h>

#include <chrono>
#include <cstdio>
#include <functional>
#include <string>

#include "cli/processes/pause_watch.hpp"

namespace farrier::test {

/// Checks that a run in real time has no problems. `run` returns its problems, a line each. The watch measures how long
/// this computer did nothing below the processes' bus threads. A run with problems during which the computer was
/// stopped is repeated some times. If it still has problems, the test is skipped.
inline void expect_undisturbed(const std::function<std::string(cli::PauseWatch&)>& run) {
  constexpr double kMayPause_ms = 15.0;
  constexpr int kMostRuns = 4;
  cli::PauseWatch pauses(runtime::kBusPriority - 1);
  for (int runs = 1;; ++runs) {
    const std::string problems = run(pauses);
    const double paused_ms = std::chrono::duration<double, std::milli>(pauses.longest()).count();
    std::printf("this computer stood still for at most %.0f ms\n%s", paused_ms, problems.c_str());
    if (problems.empty() || testing::Test::HasFailure()) {
      return;
    }
    if (paused_ms <= kMayPause_ms) {
      FAIL() << problems;
    }
    if (runs == kMostRuns) {
      GTEST_SKIP() << "this computer stands still again and again, at last for " << paused_ms
                   << " ms: what joints then do says nothing of the stack";
    }
  }
}

}  // namespace farrier::test
