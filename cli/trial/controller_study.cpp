#include "cli/trial/controller_study.hpp"

#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "cli/base/command.hpp"
#include "cli/trot/in_process.hpp"
#include "diagnosis/judge/diagnosis.hpp"
#include "participant/loop.hpp"
#include "report/diagnosis/diagnosis_result.hpp"
#include "report/diagnosis/diagnosis_text.hpp"
#include "report/figures/console.hpp"
#include "report/figures/outcome.hpp"
#include "report/figures/text_format.hpp"
#include "tools/offline/joint_recording.hpp"
#include "trials/hide.hpp"

namespace farrier::cli {
namespace {

constexpr double kMostSpread = 0.05;

/// Answer to the hidden joint's recording under one controller.
struct Answer {
  std::string verdict, name;  ///< the first effect; empty for none
  double value = NAN;         ///< of its first parameter
};

Result<Answer> answer_under(const robot::Robot& nominal, const TrialOptions& o, control::Kind kind, std::uint64_t seed,
                            const std::string& title, trials::HiddenEffect& what) {
  robot::Robot robot = nominal;
  for (robot::Joint& joint : robot.joints) {
    joint.kind = kind;
  }
  const robot::Robot world = trials::hide_effect(robot, seed, what);
  auto ran =
      run_in_process(robot, o, o.design.value(), o.trace_path, title, {.world = &world, .record_path = o.record_path});
  if (!ran) {
    return ran.error();
  }
  auto recorded = FARRIER_TRY(playback::RecordedRun::open(o.record_path));
  const robot::Joint& joint = *robot.find(what.joint);
  const diagnosis::Recording recording = offline::joint_recording(playback::read_measurements(recorded), robot, joint);
  if (!diagnosis::check_recording(recording, joint).empty()) {
    return Answer{.verdict = to_string(diagnosis::Verdict::kBadData), .name = {}};
  }
  const diagnosis::Judgement judgement = diagnosis::diagnose(recording, joint).judgement;
  Answer answer{.verdict = to_string(judgement.verdict), .name = {}};
  if (!judgement.effects.empty()) {
    answer.name = report::effect_name(judgement.effects.front().id);
    answer.value = report::shown(judgement.effects.front(), joint).numbers.front().value;
  }
  return answer;
}

/// True if all name the same effect.
bool same_name(const std::vector<Answer>& answers) {
  return std::ranges::all_of(answers,
                             [&](const Answer& one) { return !one.name.empty() && one.name == answers.front().name; });
}

/// Largest difference of two sizes over the mean of all.
double spread_of(const std::vector<Answer>& answers) {
  const auto [least, most] = std::ranges::minmax(answers, {}, &Answer::value);
  double sum = 0.0;
  for (const Answer& answer : answers) {
    sum += answer.value;
  }
  return (most.value - least.value) / std::abs(sum / static_cast<double>(answers.size()));
}

}  // namespace

int run_controller_study(const robot::Robot& nominal, const TrialOptions& o) {
  participant::install_signal_handlers();
  std::vector<std::vector<std::string>> rows{{"seed", "hidden", "controller", "verdict", "first named", "size"}};
  double same = 0.0, worst = 0.0;
  for (int i = 0; i < o.seeds; ++i) {
    const std::uint64_t seed = o.hide + static_cast<std::uint64_t>(i);
    std::vector<Answer> answers;
    for (const auto& [name, kind] : robot::kControllerKinds) {
      trials::HiddenEffect what;
      auto answer = answer_under(nominal, o, kind, seed, "trial " + std::to_string(seed) + ", " + name, what);
      if (!answer) {
        return fail("trial", std::string(name) + ": " + answer.error().message);
      }
      const std::string hidden = what.joint + " " + what.effect + " " + report::short_number(what.value) +
                                 (what.unit == "1" ? "" : " " + what.unit);
      rows.push_back({std::to_string(seed), hidden, name, answer.value().verdict, answer.value().name,
                      answer.value().name.empty() ? "" : report::short_number(answer.value().value)});
      answers.push_back(std::move(answer).value());
    }
    if (same_name(answers)) {
      ++same;
      worst = std::max(worst, spread_of(answers));
    }
  }
  std::fputs(report::aligned(rows, "").c_str(), stdout);
  report::Outcome outcome;
  outcome.command = "trial";
  outcome.run = report::run_info(nominal, o.seed);
  outcome.figures.add("hide.controllers.seeds", o.seeds);
  outcome.figures.add("hide.controllers.same_name", same, o.seeds);
  outcome.figures.add("hide.controllers.size_spread", worst, kMostSpread);
  std::fputs(report::console_text(outcome, report::wants_colour(STDOUT_FILENO)).c_str(), stdout);
  if (auto written = report::write_json(o.json_path, outcome); !written) {
    return fail("trial", written.error().message);
  }
  return outcome.passes() ? kPassed : kFailed;
}

}  // namespace farrier::cli
