#include "cli/recording/rerun.hpp"

#include <cstdio>
#include <vector>

#include "participant/loop.hpp"
#include "cli/base/command.hpp"
#include "cli/base/long_work.hpp"
#include "tools/playback/rerun.hpp"
#include "report/figures/text_format.hpp"

namespace farrier::cli {
namespace {

std::string text_of(const std::optional<playback::Difference>& first) {
  if (!first) {
    return "-";
  }
  char numbers[80];
  std::snprintf(numbers, sizeof numbers, ": %.17g, now %.17g", first->recorded, first->now);
  return "tick " + std::to_string(first->tick) + ", " + first->field + numbers;
}

}  // namespace

int rerun_estimator(playback::RecordedRun& run, const std::string& path) {
  const auto rerun = playback::rerun_estimator(run, long_work("replay --rerun estimator"));
  if (participant::stop_requested()) {
    return participant::stop_status();
  }
  if (!rerun) {
    std::fprintf(stderr, "farrier replay: %s: %s\n", path.c_str(), rerun.error().message.c_str());
    return kBadInput;
  }
  std::vector<std::vector<std::string>> rows{
      {"joint", "measurements", "missing", "compared", "different", "first difference"}};
  std::uint64_t compared = 0, different = 0, missing = 0;
  for (const robot::Joint& joint : run.robot().joints) {
    const playback::RerunJoint& sum = rerun.value().joints[joint.number];
    rows.push_back({joint.name, std::to_string(sum.measurements), std::to_string(sum.missing),
                    std::to_string(sum.compared), std::to_string(sum.different), text_of(sum.first)});
    compared += sum.compared;
    different += sum.different;
    missing += sum.missing;
  }
  std::fputs(report::aligned(rows).c_str(), stdout);
  std::printf("%s: %llu estimates compared, %llu different\n", path.c_str(), static_cast<unsigned long long>(compared),
              static_cast<unsigned long long>(different));
  if (different > 0 && (rerun.value().first_tick > 0 || missing > 0)) {
    std::fputs(
        "The recorded estimators knew more than this file tells: it begins after the run, or lacks "
        "measurements.\n",
        stdout);
  }
  if (compared == 0) {
    return refuse("replay", path + " has no joint/measurement with joint/model_estimate: " +
                                (rerun.value().ending.empty() ? "record both" : rerun.value().ending));
  }
  if (!rerun.value().ending.empty()) {
    std::fprintf(stderr, "farrier replay: %s: %s\n", path.c_str(), rerun.value().ending.c_str());
    return kFailed;
  }
  return different == 0 ? kPassed : kFailed;
}

}  // namespace farrier::cli
