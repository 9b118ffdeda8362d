// farrier compare models: what the linear model in the load-cell force makes of the piston's mass.

#include <unistd.h>

#include <array>
#include <cmath>
#include <cstdio>
#include <numbers>

#include "cli/base/command.hpp"
#include "cli/base/installation.hpp"
#include "cli/compare/comparison.hpp"
#include "control/design/margins.hpp"
#include "estimation/poles.hpp"
#include "report/compare/models.hpp"
#include "report/figures/console.hpp"
#include "report/figures/text_format.hpp"
#include "robot/joint_model.hpp"
#include "trials/load_cycle.hpp"

namespace farrier::cli {
namespace {

using plant::PistonMass;
using report::ModelRow;

constexpr std::array kMasses_kg{trials::kLightMass_kg, 1.0, 2.5, trials::kHeavyMass_kg};

/// A way to count the piston's mass.
struct ModelForm {
  const char* name;
  PistonMass piston;
  bool massless;
};
constexpr std::array kForms{ModelForm{"exact", PistonMass::kCounted, false},
                            ModelForm{"thesis", PistonMass::kNeglected, false},
                            ModelForm{"massless_piston", PistonMass::kCounted, true}};

/// Frequency of the damped oscillation of a sampled model.
double resonance_Hz(const control::DiscreteModel& model, double period_s) {
  double largest = 0.0;
  for (const std::complex<double>& pole : estimation::poles<3>(model.a)) {
    largest = std::max(largest, std::arg(pole));
  }
  return largest / (2.0 * std::numbers::pi * period_s);
}

Result<ModelRow> row_of(const robot::Robot& rig, double mass_kg, const ModelForm& form) {
  robot::Joint joint = rig.joints[0];
  plant::LoadParams load = joint.swing_load;
  load.mass = mass_kg;
  const control::DiscreteModel exact = robot::model_of(joint, load, rig.period_s);
  if (form.massless) {
    joint.actuator.piston_mass = 0.0;
  }
  const control::DiscreteModel model = robot::model_of(joint, load, rig.period_s, {.piston = form.piston});
  const auto gains = control::design(model, joint.design, joint.normalisation, joint.form, 0, rig.period_s);
  if (!gains) {
    return Error{std::string("the rig with ") + report::short_number(mass_kg) +
                 " kg: " + control::to_string(gains.error())};
  }
  return ModelRow{.load_kg = report::short_number(mass_kg),
                  .form = form.name,
                  .resonance_Hz = resonance_Hz(model, rig.period_s),
                  .position_gain = gains.value().position,
                  .velocity_gain = gains.value().velocity,
                  .force_gain = gains.value().force,
                  .disk_margin = control::margins(exact, gains.value(), 0).disk};
}

Result<std::vector<ModelRow>> all_rows(const robot::Robot& rig) {
  std::vector<ModelRow> rows;
  for (const double mass_kg : kMasses_kg) {
    for (const ModelForm& form : kForms) {
      rows.push_back(FARRIER_TRY(row_of(rig, mass_kg, form)));
    }
  }
  return rows;
}

}  // namespace

int run_models(const robot::Robot&, const CompareOptions& options) {
  const auto rig = robot::load_robot(shipped_robot("fc1d.yaml"));
  if (!rig) {
    return fail("compare", config::to_string(rig.error()));
  }
  const auto rows = all_rows(rig.value());
  if (!rows) {
    return fail("compare", rows.error().message);
  }
  report::Outcome outcome;
  outcome.command = "compare";
  outcome.run = report::run_info(rig.value(), options.seed);
  report::add_models(outcome.figures, rows.value());
  if (auto written = report::write_json(options.json_path, outcome); !written) {
    return fail("compare", written.error().message);
  }
  std::printf("%s\nfigures: %s\n", report::models_text(rows.value()).c_str(), options.json_path.c_str());
  return kPassed;
}

}  // namespace farrier::cli
