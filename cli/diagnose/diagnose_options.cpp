#include "cli/diagnose/diagnose_options.hpp"

#include <CLI/CLI.hpp>

#include <map>

#include "cli/base/help.hpp"
#include "trials/blind/blind_trials.hpp"

namespace farrier::cli {
namespace {

const std::map<std::string, Units> kUnits{{"si", Units::kSi}, {"scaled", Units::kScaled}};

const std::map<std::string, Actuator> kActuators{{"hydraulic", Actuator::kHydraulic},
                                                 {"electric", Actuator::kElectric}};

}  // namespace

void declare(CLI::App& app, DiagnoseOptions& o) {
  app.add_option("recording", o.recording,
                 "CSV of one joint (time_s, position_m, force_N, where recorded valve_current_A, velocity_m_s, ...: "
                 "docs/diagnosis.md), a recording of farrier record, or a trace of farrier trot")
      ->type_name("<file>");
  add_choice(
      app, "--units", o.units, kUnits, "si|scaled",
      "of the recording; scaled: a CSV of sample, valve and position in units of its own, which needs no --model "
      "and is judged by what its valve does to its position")
      ->default_str("si");
  app.add_option("--model", o.model_path, "robot file of the machine that was recorded; it is only read")
      ->type_name("<file>")
      ->default_str("the robot that a recording of farrier record is of");
  app.add_option("--joint", o.joint, "joint of the recording; needed where the robot has several")->type_name("<name>");
  app.add_option("--out", o.out,
                 "directory for the report, its pictures and the extended model <robot>_<joint>_extended.yaml; without "
                 "it none is written")
      ->type_name("<dir>");
  app.add_option("--json", o.json_path, "where the diagnosis goes as JSON")
      ->type_name("<file>")
      ->default_str("figures.json in --out");
  app.add_flag("--what-can-be-told", o.what_can_be_told,
               "print which effects this recording can show, which it cannot tell apart and what would, in place of a "
               "verdict");
  app.add_option(
         "--set", o.set,
         "--what-can-be-told says of these effects, all in one joint, which of them this recording can separate, "
         "and what hides the others")
      ->delimiter(',')
      ->type_name("<effect>,...")
      ->needs("--what-can-be-told");
  app.add_flag("--benchmark", o.benchmark,
               "run blind trials in place of a recording: effects hidden in recordings by a generator that shares no "
               "code with the diagnosis; takes up to half an hour");
  auto* const actuator = add_choice(app, "--actuator", o.actuator, kActuators, "hydraulic|electric",
                                    "of the joints of --benchmark or --wiring")
                             ->default_str("hydraulic");
  app.add_flag(
         "--healthy", o.healthy,
         "--benchmark diagnoses every joint of healthy robots, hyq or go1, in place of hidden effects, and counts "
         "the robots with an alarm; --trials counts robots, 0: 300")
      ->needs("--benchmark");
  auto* const calibrate =
      app.add_option(
             "--calibrate", o.calibration_path,
             "--benchmark runs its trials twice, with other seeds, fits the map of confidences to them and writes it, "
             "as lib/diagnosis/confidence/confidence_hydraulic.def; its --seed is 100001 unless told, and not lower")
          ->type_name("<file>")
          ->needs("--benchmark")
          ->excludes("--healthy");
  app.add_flag(
      "--wiring", o.wiring,
      "put faults of wiring into recordings of the same generator in place of a recording, and count those named; "
      "then count those named in all blind trials of --benchmark, which have none");
  auto* const confusion =
      app.add_option("--confusion", o.confusion_path, "Markdown of what --benchmark hid and what it was taken for");
  auto* const seed = app.add_option("--seed", o.seed, "of the first trial of --benchmark or --wiring");
  auto* const trials =
      app.add_option("--trials", o.trials, "how many of the blind trials, the first in a mixed order; 0: all");
  confusion->type_name("<file>")->needs("--benchmark");
  seed->type_name("<n>")->capture_default_str();
  trials->check(between(0, 100000))->type_name("<n>")->capture_default_str();
  app.parse_complete_callback([seed, trials, actuator, calibrate, &o] {
    o.seed = calibrate->count() > 0 && seed->count() == 0 ? blind::kCalibrationSeed : o.seed;
    for (const CLI::Option* const option : {seed, trials, actuator}) {
      if (option->count() > 0 && !o.benchmark && !o.wiring) {
        throw CLI::RequiresError(option->get_name(), "--benchmark or --wiring");
      }
    }
  });
  app.add_flag("--continue", o.go_on,
               "--benchmark takes over the trials that an interrupted or shorter run of the same build and --seed kept "
               "beside "
               "--json")
      ->needs("--benchmark")
      ->needs("--json");
  app.add_option("--threads", o.threads, "candidates, or trials of --benchmark, that are fitted at a time")
      ->check(between(1, 64))
      ->type_name("<n>")
      ->capture_default_str();
}

}  // namespace farrier::cli
