#include "cli/diagnose/diagnose_wiring_trials.hpp"

#include <unistd.h>

#include <cstdio>

#include "cli/base/command.hpp"
#include "cli/base/output_file.hpp"
#include "cli/base/progress.hpp"
#include "cli/diagnose/diagnose_benchmark.hpp"
#include "participant/loop.hpp"
#include "report/figures/console.hpp"
#include "report/figures/outcome.hpp"
#include "report/figures/text_format.hpp"
#include "trials/wiring/wiring_trials.hpp"

namespace farrier::cli {
namespace {

constexpr double kFaultsNamed = 1;   // of the recordings with a fault
constexpr double kAnotherNamed = 0;  // likewise
constexpr double kFalselyNamed = 0;  // of the recordings without

void print_scores(const std::vector<wiring::KindScore>& scores) {
  std::vector<std::vector<std::string>> rows{{"fault", "recordings", "named first", "named", "another named"}};
  for (const wiring::KindScore& score : scores) {
    rows.push_back({score.name, std::to_string(score.recordings), std::to_string(score.first),
                    std::to_string(score.possible), std::to_string(score.wrong)});
  }
  std::fputs(report::aligned(rows, "").c_str(), stdout);
}

}  // namespace

int run_wiring_benchmark(const std::string& json_path, std::uint64_t seed, int trials, int threads,
                         const std::string& robots, bool electric) {
  participant::install_signal_handlers();
  if (!json_path.empty()) {
    if (auto free = make_way(json_path); !free) {
      return refuse("diagnose --wiring", free.error().message);
    }
  }
  const auto loaded = load_trial_robots(robots, electric);
  if (!loaded) {
    return refuse("diagnose --wiring", loaded.error().message);
  }
  const std::vector<const robot::Joint*> joints = loaded.value().joints();
  std::vector<const robot::Joint*> wired = joints;
  if (!electric) {
    wired.push_back(loaded.value().legs.find("lf_hfe"));
  }
  auto scores = wiring::run_wiring_trials(wired, seed);
  const auto of_robot = wiring::run_robot_wiring_trials(loaded.value().legs, seed);
  if (!scores || !of_robot) {
    return fail("diagnose --wiring", (scores ? of_robot : scores).error().message);
  }
  scores.value().insert(scores.value().end(), of_robot.value().begin(), of_robot.value().end() - 1);
  print_scores(scores.value());
  const wiring::KindScore& right_cables = of_robot.value().back();
  std::printf("%s: %d, of which %d had a fault named\n", right_cables.name.c_str(), right_cables.recordings,
              right_cables.wrong);
  std::fflush(stdout);
  const auto plans = blind::mixed(
      electric ? blind::all_electric_trials(joints, seed) : blind::all_trials(joints.size(), seed), trials);
  Progress bar("diagnose --wiring", static_cast<Tick>(plans.size()), "trials");
  std::size_t done = 0;
  const std::vector<std::string> alarms = wiring::false_alarms(plans, joints, threads, [&] {
    bar.update(static_cast<Tick>(++done));
    return !participant::stop_requested();
  });
  if (participant::stop_requested()) {
    return participant::stop_status();
  }
  double recordings = 0.0, first = 0.0, possible = 0.0, wrong = 0.0;
  for (const wiring::KindScore& score : scores.value()) {
    recordings += score.recordings;
    first += score.first;
    possible += score.possible;
    wrong += score.wrong;
  }
  report::Outcome outcome;
  outcome.command = "diagnose";
  outcome.run = report::run_info(loaded.value().rig, seed);
  for (const std::string& alarm : alarms) {
    outcome.failures.push_back(alarm);
  }
  outcome.figures.add("diagnose.wiring.recordings", recordings);
  outcome.figures.add("diagnose.wiring.named_first", first / recordings, kFaultsNamed);
  outcome.figures.add("diagnose.wiring.named", possible / recordings);
  outcome.figures.add("diagnose.wiring.another_named", wrong / recordings, kAnotherNamed);
  outcome.figures.add("diagnose.wiring.trials", static_cast<double>(plans.size()) + right_cables.recordings);
  outcome.figures.add("diagnose.wiring.false_alarms", static_cast<double>(alarms.size()) + right_cables.wrong,
                      kFalselyNamed);
  std::fputs(report::console_text(outcome, report::wants_colour(STDOUT_FILENO)).c_str(), stdout);
  if (!json_path.empty()) {
    if (auto written = report::write_json(json_path, outcome); !written) {
      return fail("diagnose --wiring", written.error().message);
    }
  }
  return outcome.passes() ? kPassed : kFailed;
}

}  // namespace farrier::cli
