#include "cli/trial/trial_study.hpp"

#include <filesystem>

#include "diagnosis/judge/diagnosis.hpp"
#include "trials/hide.hpp"
#include "participant/loop.hpp"
#include "cli/trot/in_process.hpp"
#include "cli/base/output_file.hpp"
#include "cli/base/progress.hpp"
#include "cli/trot/trot_run.hpp"
#include "tools/offline/joint_recording.hpp"
#include "core/replace_file.hpp"
#include "report/diagnosis/extended_model.hpp"
#include "report/trot/tracking.hpp"

namespace farrier::cli {
namespace {

Error of_seed(std::uint64_t seed, const Error& error) {
  return {"seed " + std::to_string(seed) + ": " + error.message};
}

report::JointVerdict verdict_of(const std::string& joint, const diagnosis::Judgement& judgement) {
  report::JointVerdict verdict{.joint = joint,
                               .verdict = to_string(judgement.verdict),
                               .effects = {},
                               .tied = {},
                               .gain = judgement.gain.log_ratio};
  for (const diagnosis::NamedEffect& effect : judgement.effects) {
    verdict.effects.emplace_back(plant::effect_info(effect.id).name);
  }
  for (const auto& [chosen, rival] : judgement.alternatives) {
    verdict.tied.emplace_back(plant::effect_info(rival).name);
  }
  return verdict;
}

}  // namespace

Result<std::vector<double>> TrialStudy::stance_nrmse(RunOutcome& run, const std::string& trace_path) {
  const auto tracking = FARRIER_TRY(tracking_of(nominal_, run, trace_path, o_.seed, nominal_.loop_delay_lockstep));
  long_enough_ = long_enough_ && report::long_enough(nominal_, tracking);
  std::vector<double> nrmse;
  for (const report::JointTracking& joint : tracking.joints) {
    nrmse.push_back(joint.stance.nrmse);
  }
  return nrmse;
}

/// Verdicts of every joint's recording; what was found of the most suspected joint.
Result<std::vector<plant::ActiveEffect>> TrialStudy::diagnose_all(const TrotOptions& run, report::HideTrial& trial) {
  auto recorded = FARRIER_TRY(playback::RecordedRun::open(run.record_path));
  const playback::Measurements measured = playback::read_measurements(recorded);
  std::vector<plant::ActiveEffect> found;
  Progress progress("trial, diagnosing", static_cast<Tick>(nominal_.joints.size()), "joint");
  for (const robot::Joint& joint : nominal_.joints) {
    if (participant::stop_requested()) {
      return Error{"interrupted"};
    }
    const diagnosis::Recording recording = offline::joint_recording(measured, nominal_, joint);
    if (const auto findings = diagnosis::check_recording(recording, joint); !findings.empty()) {
      trial.verdicts.push_back({.joint = joint.name,
                                .verdict = to_string(diagnosis::Verdict::kBadData),
                                .effects = {},
                                .tied = {},
                                .gain = 0.0});
    } else {
      const diagnosis::Diagnosis diagnosis = diagnosis::diagnose(recording, joint);
      trial.verdicts.push_back(verdict_of(joint.name, diagnosis.judgement));
      if (trial.suspect() == &trial.verdicts.back()) {
        found = diagnosis::found_effects(diagnosis, joint);
      }
    }
    progress.update(static_cast<Tick>(trial.verdicts.size()));
  }
  return found;
}

Result<std::string> TrialStudy::write_world(const robot::Robot& world, const std::string& joint) const {
  const auto model = FARRIER_TRY(report::extended_model(nominal_, *nominal_.find(joint), world.find(joint)->effects));
  const std::string path = o_.out + "/log/world.yaml";
  FARRIER_TRY(replace_file(path, model.text));
  return path;
}

Result<robot::Robot> TrialStudy::extend(const robot::Joint& joint, const std::vector<plant::ActiveEffect>& effects,
                                        std::uint64_t seed) {
  const auto model = FARRIER_TRY(report::extended_model(nominal_, joint, effects));
  const std::string path =
      o_.out + "/" + nominal_.name + "_" + joint.name + "_seed_" + std::to_string(seed) + "_extended.yaml";
  FARRIER_TRY(replace_file(path, model.text));
  auto loaded = robot::load_robot(path);
  if (!loaded) {
    return Error{config::to_string(loaded.error())};
  }
  models_.push_back(path);
  return std::move(loaded).value();
}

Result<Done> TrialStudy::run(std::uint64_t seed, const std::vector<double>& nominal_nrmse) {
  const std::string at = "trial " + std::to_string(seed);
  trials::HiddenEffect what;  // read only by the judgement, after the diagnosis
  const robot::Robot world = trials::hide_effect(nominal_, seed, what);
  const auto world_path = FARRIER_TRY(write_world(world, what.joint));
  TrotOptions recorded = o_;
  if (o_.seeds > 1) {
    const std::filesystem::path path = o_.record_path;
    recorded.record_path =
        path.parent_path() / (path.stem().string() + "_seed_" + std::to_string(seed) + path.extension().string());
  }
  recordings_.push_back(recorded.record_path);
  auto hidden = FARRIER_TRY(run_once(nominal_, recorded, at, {&world, world_path}));
  const auto hidden_nrmse = FARRIER_TRY(stance_nrmse(hidden, recorded.trace_path));
  report::HideTrial trial;
  trial.seed = seed;
  const auto found = FARRIER_TRY(diagnose_all(recorded, trial));
  const std::size_t number = nominal_.find(what.joint)->number;
  trial.joint = what.joint;
  trial.effect = what.effect;
  trial.parameter = what.parameter;
  trial.unit = what.unit;
  trial.value = what.value;
  trial.nrmse_nominal = nominal_nrmse[number];
  trial.nrmse_hidden = hidden_nrmse[number];
  trial.nrmse_known = trial.nrmse_hidden;
  if (!found.empty()) {
    const auto extended = FARRIER_TRY(extend(*nominal_.find(trial.suspect()->joint), found, seed));
    const std::string path = o_.out + "/trace_known.csv";
    auto ran =
        run_in_process(extended, o_, o_.design.value(), path, at + ", known", {.world = &world, .record_path = {}});
    if (!ran) {
      return ran.error();
    }
    const auto known = FARRIER_TRY(stance_nrmse(ran.value(), path));
    trial.nrmse_known = known[number];
  }
  trials_.push_back(std::move(trial));
  return Done{};
}

Result<Done> TrialStudy::run() {
  const std::string path = o_.out + "/trace_nominal.csv";
  auto ran = run_in_process(nominal_, o_, o_.design.value(), path, "trot, nominal");
  if (!ran) {
    return ran.error();
  }
  const auto nominal = FARRIER_TRY(stance_nrmse(ran.value(), path));
  for (std::uint64_t i = 0; i < static_cast<std::uint64_t>(o_.seeds); ++i) {
    if (auto trial = run(o_.hide + i, nominal); !trial) {
      return of_seed(o_.hide + i, trial.error());
    }
  }
  return Done{};
}

}  // namespace farrier::cli
