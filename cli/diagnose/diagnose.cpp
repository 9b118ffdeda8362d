// farrier diagnose: what a recording says is missing in the model of a joint.

#include <CLI/CLI.hpp>
#include <cstdio>
#include <filesystem>
#include <optional>

#include "core/text.hpp"
#include "diagnosis/judge/diagnosis.hpp"
#include "diagnosis/data/recording_check.hpp"
#include "diagnosis/data/trace_recording.hpp"
#include "participant/loop.hpp"
#include "robot/keys.hpp"
#include "cli/base/command.hpp"
#include "cli/diagnose/diagnose_benchmark.hpp"
#include "cli/diagnose/diagnose_control.hpp"
#include "cli/diagnose/diagnose_options.hpp"
#include "cli/diagnose/diagnose_scaled.hpp"
#include "cli/diagnose/diagnose_tell.hpp"
#include "cli/diagnose/diagnose_wiring.hpp"
#include "cli/diagnose/diagnose_wiring_trials.hpp"
#include "cli/base/installation.hpp"
#include "cli/base/long_work.hpp"
#include "cli/base/output_file.hpp"
#include "tools/offline/joint_recording.hpp"
#include "report/diagnosis/diagnosis_json.hpp"
#include "report/diagnosis/diagnosis_page.hpp"
#include "report/diagnosis/diagnosis_text.hpp"
#include "core/replace_file.hpp"
#include "report/diagnosis/extended_model.hpp"

namespace farrier::cli {
namespace {

namespace fs = std::filesystem;
using diagnosis::Diagnosis;
using diagnosis::Recording;

/// The joint that was asked for, or the robot's only one.
Result<const robot::Joint*> joint_of(const robot::Robot& robot, const std::string& name) {
  const std::string names = join(robot::joint_names(robot), ", ");
  if (name.empty()) {
    return robot.joints.size() == 1 ? Result<const robot::Joint*>(&robot.joints.front())
                                    : Error{robot.name + " has several joints: give --joint, one of " + names};
  }
  const robot::Joint* const joint = robot.find(name);
  return joint != nullptr ? Result<const robot::Joint*>(joint)
                          : Error{"--joint: " + robot.name + " has no joint '" + name + "'; it has " + names};
}

/// Reason why a recording cannot be judged.
struct Refusal {
  diagnosis::RecordingProblems problems;
  WiringOfRecording wiring = {};  ///< without answers: the data are bad
};

/// A recording, or what is wrong with it: its wiring before its data.
Result<Recording, Refusal> read(const DiagnoseOptions& o, const robot::Robot& robot, const robot::Joint& joint) {
  auto recording = playback::is_recording(o.recording)
                       ? offline::read_joint_recording(o.recording, joint.name, long_work("diagnose, reading"))
                   : diagnosis::is_trace(o.recording) ? diagnosis::recording_of_trace(o.recording, robot, joint)
                                                      : diagnosis::read_recording(o.recording, joint.name);
  if (!recording) {
    return Refusal{std::move(recording).error()};
  }
  recording = diagnosis::with_current(std::move(recording).value(), joint);
  if (auto wiring = wiring_of(o, robot, joint, recording.value()); !wiring.answers.empty()) {
    auto findings = diagnosis::wiring_findings(wiring.answers, recording.value(), joint);
    return Refusal{{std::move(findings), recording.value().remarks}, std::move(wiring)};
  }
  if (auto findings = diagnosis::check_recording(recording.value(), joint); !findings.empty()) {
    return Refusal{{std::move(findings), recording.value().remarks}};
  }
  return std::move(recording).value();
}

/// The robot that --model names, or without it the one a recording of farrier record is of. Refuses with all that is
/// wrong, a line each.
Result<robot::Robot> model_of(const DiagnoseOptions& o) {
  if (!o.model_path.empty()) {
    auto loaded = robot::load_robot(o.model_path);
    return loaded ? Result<robot::Robot>(std::move(loaded).value()) : Error{config::to_string(loaded.error())};
  }
  if (!playback::is_recording(o.recording)) {
    return Error{"farrier diagnose: give --model, the robot file of the machine that was recorded\n"};
  }
  auto run = playback::RecordedRun::open(o.recording, {}, long_work("diagnose, reading"));
  return run ? Result<robot::Robot>(run.value().robot()) : Error{"farrier diagnose: " + run.error().message + "\n"};
}

/// Files the command writes; empty for none.
struct Outputs {
  std::string json, page, model;
};

Outputs outputs_of(const DiagnoseOptions& o, const robot::Robot& robot, const robot::Joint& joint) {
  const auto in_out = [&](const std::string& name) { return o.out.empty() ? "" : (fs::path(o.out) / name).string(); };
  return {.json = o.json_path.empty() ? in_out("figures.json") : o.json_path,
          .page = in_out("index.html"),
          .model = in_out(robot.name + "_" + joint.name + "_extended.yaml")};
}

/// Writes the effects found into the file of the extended model, unless `path` is empty, and measures by the recording
/// what that file explains.
Result<report::ModelOfDiagnosis> write_model(const std::string& path, const robot::Robot& robot,
                                             const robot::Joint& joint, const Recording& recording,
                                             const Diagnosis& found) {
  report::ModelOfDiagnosis made;
  const std::vector<plant::ActiveEffect> effects = diagnosis::found_effects(found, joint);
  if (effects.empty()) {
    return made;
  }
  const auto model = FARRIER_TRY(report::extended_model(robot, joint, effects));
  made.left_out = model.left_out;
  if (!model.robot) {
    return made;
  }
  made.error = diagnosis::error_ratio(recording, joint, *model.robot->find(joint.name));
  if (!path.empty()) {
    const std::string head =
        "# " + robot.name + " with the effects that farrier diagnose found at joint " + joint.name + ".\n";
    FARRIER_TRY(replace_file(path, head + model.text));
    if (const auto again = robot::load_robot(path); !again) {
      return Error{"the extended model does not load: " + config::to_string(again.error())};
    }
    made.path = path;
  }
  return made;
}

int finish(const report::DiagnosisResult& result, const Outputs& outputs, const DiagnoseOptions& o) {
  const bool bad = report::is_refused(result);
  report::Outcome outcome;
  outcome.command = "diagnose";
  outcome.run = report::run_info(result.robot, 0);
  outcome.finding = diagnosis::to_string(result.diagnosis.judgement.verdict);
  report::add_diagnosis(outcome.figures, result);
  if (bad) {
    outcome.failures.push_back("the recording cannot be judged");
  }
  if (!outputs.json.empty()) {
    if (auto written = report::write_diagnosis_json(outputs.json, result, outcome); !written) {
      return fail("diagnose", written.error().message);
    }
  }
  if (bad) {
    std::fputs(diagnosis::to_string(result.findings, o.recording).c_str(), stderr);
    for (const std::string& remark : result.diagnosis.remarks) {
      std::fprintf(stderr, "%s: note: %s\n", o.recording.c_str(), remark.c_str());
    }
  } else {
    std::fputs(report::diagnosis_console(result).c_str(), stdout);
  }
  if (!o.out.empty()) {
    const auto page = report::write_diagnosis_page(o.out, result, outcome);
    if (!page) {
      return fail("diagnose", page.error().message);
    }
    std::printf("report: %s\n", page.value().c_str());
  }
  if (!outputs.json.empty()) {
    std::printf("figures: %s\n", outputs.json.c_str());
  }
  return bad ? kBadInput : kPassed;
}

int diagnose(const DiagnoseOptions& o) {
  if (o.units == Units::kScaled) {
    return diagnose_scaled(o);
  }
  if (o.wiring) {
    return o.recording.empty() && !o.benchmark
               ? run_wiring_benchmark(o.json_path, o.seed, o.trials, o.threads, robots_directory(),
                                      o.actuator == Actuator::kElectric)
               : refuse("diagnose", "--wiring makes its recordings: name none, and no --benchmark");
  }
  if (o.benchmark) {
    return o.recording.empty() ? run_diagnose_benchmark({.json_path = o.json_path,
                                                         .confusion_path = o.confusion_path,
                                                         .seed = o.seed,
                                                         .trials = o.trials,
                                                         .threads = o.threads,
                                                         .electric = o.actuator == Actuator::kElectric,
                                                         .healthy = o.healthy,
                                                         .calibration_path = o.calibration_path,
                                                         .go_on = o.go_on},
                                                        robots_directory())
                               : refuse("diagnose", "--benchmark makes its recordings: name none");
  }
  if (o.recording.empty()) {
    return refuse("diagnose", "name a recording; see 'farrier diagnose --help'");
  }
  const auto loaded = model_of(o);
  if (!loaded) {
    std::fputs(loaded.error().message.c_str(), stderr);
    return participant::stop_requested() ? participant::stop_status() : kBadInput;
  }
  const robot::Robot& robot = loaded.value();
  const auto joint = joint_of(robot, o.joint);
  if (!joint) {
    return refuse("diagnose", joint.error().message);
  }
  const auto set = asked_set(o.set, *joint.value());
  if (!set) {
    return refuse("diagnose", set.error().message);
  }
  std::optional<OutputDirectory> directory;
  if (!o.out.empty()) {
    auto claimed = OutputDirectory::claim(o.out);
    if (!claimed) {
      return refuse("diagnose", claimed.error().message);
    }
    directory.emplace(std::move(claimed).value());
  }
  const Outputs outputs = outputs_of(o, robot, *joint.value());
  if (const auto free = make_way({outputs.json, outputs.page, outputs.model}, {o.recording, o.model_path}); !free) {
    return refuse("diagnose", free.error().message);
  }
  const auto recording = read(o, robot, *joint.value());
  if (participant::stop_requested()) {
    return participant::stop_status();
  }
  if (!recording) {
    Diagnosis none{};
    const Refusal& refusal = recording.error();
    none.judgement.verdict =
        refusal.wiring.answers.empty() ? diagnosis::Verdict::kBadData : diagnosis::Verdict::kWiring;
    none.remarks = refusal.problems.remarks;
    return finish({.diagnosis = none,
                   .robot = robot,
                   .joint = *joint.value(),
                   .recording = o.recording,
                   .findings = refusal.problems.findings,
                   .wiring = refusal.wiring.answers,
                   .evidence = refusal.wiring.evidence},
                  outputs, o);
  }
  if (o.what_can_be_told) {
    return tell(recording.value(), robot, *joint.value(), set.value(), o, outputs.json);
  }
  const Diagnosis found = with_options(
      o.threads, [&](const auto& options) { return diagnosis::diagnose(recording.value(), *joint.value(), options); });
  const auto model = write_model(outputs.model, robot, *joint.value(), recording.value(), found);
  if (!model) {
    return fail("diagnose", model.error().message);
  }
  return finish({.diagnosis = found,
                 .robot = robot,
                 .joint = *joint.value(),
                 .recording = o.recording,
                 .period_s = recording.value().period_s,
                 .model = model.value(),
                 .control = control_gain(robot, *joint.value(), found)},
                outputs, o);
}

}  // namespace

std::function<int()> declare_diagnose(CLI::App& app) {
  auto options = std::make_shared<DiagnoseOptions>();
  declare(app, *options);
  return [options] { return diagnose(*options); };
}

}  // namespace farrier::cli
