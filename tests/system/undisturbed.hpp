#pragma once

#include <gtest/gtest.h>

#include <chrono>
#include <cstdio>
#include <functional>
#include <string>

#include "cli/processes/pause_watch.hpp"

namespace farrier::test {

/// Holds a run in real time to what it must do. `run` gives what is not as it must be, a line each; the watch sees how
/// long this computer did nothing below the processes' bus threads. A run that is not as it must be while the computer
/// stood still is made again some times, after which nothing is said of it.
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
