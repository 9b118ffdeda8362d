// Hubacher (2014), 5.3 and 10.3: the four update logics on the load cycle of 7.5, and the switch between stance and
// flight.

#include <algorithm>
#include <cmath>

#include "control/design/switching.hpp"
#include "robot/joint_model.hpp"
#include "supervisor/slot_pair.hpp"
#include "thesis/studies/registry.hpp"
#include "trials/load_cycle.hpp"
#include "trials/update_logic_study.hpp"

namespace farrier::thesis {
namespace section5_update_studies {
namespace {

constexpr ClaimSpec kLogicClaims[] = {
    {"S5.3.least_designs", "5.3.1",
     "The advantages of this method (d) are that it minimizes the computational burden ...",
     "Controllers designed by (d) over the least of (a), (b) and (c), load cycle of Fig. 7.6: at most 1.", "1",
     Relation::kAtMost, 1.0},
    {"S5.3.appropriate", "5.3.1",
     "We give a short reasoning on why method (d) seems to be the most appropriate for our scenario.",
     "Largest NRMSE of a quarter by (d) over the least of the largest of (a), (b) and (c): 1.1.", "1",
     Relation::kAtMost, 1.1},
    {"S5.3.robust", "5.3",
     "... the controller designed for the previously estimated system will still be able to give satisfactory "
     "performance ...",
     "Gains accepted by (d) over estimates looked at: a tenth.", "1", Relation::kAtMost, 0.1}};

Result<StudyResult> run_logics(const StudyContext& context) {
  const auto rig = FARRIER_TRY(load(context, "fc1d.yaml"));
  const trials::LoadCycle cycle = FARRIER_TRY(trials::make_load_cycle(rig));
  double designs = 0.0, error = 0.0, accepted = 0.0;
  double other_designs = HUGE_VAL, other_error = HUGE_VAL;
  std::string designs_text = "designs", errors_text = "largest errors";
  Series work{"designs", {}, {}, Style::kPoints, 1};
  Series quality{"largest NRMSE of a quarter", {}, {}, Style::kPoints, 2};
  for (std::size_t i = 0; i < trials::kUpdateMethods.size(); ++i) {
    if (!keep_going(context, static_cast<double>(i) / static_cast<double>(trials::kUpdateMethods.size()))) {
      return stopped();
    }
    run::InprocRun settings;
    settings.ticks = cycle.begin.back();
    settings.seed = context.seed;
    settings.load_changes = cycle.changes;
    settings.grouping = run::Grouping::kOne;
    const trials::UpdateLogicRun run =
        FARRIER_TRY(trials::run_update_logic(cycle.robot, trials::kUpdateMethods[i], settings));
    double largest = 0.0;
    for (std::size_t quarter = 0; quarter < trials::kQuarters; ++quarter) {
      largest = std::max(largest, trials::quarter_error(cycle, run.rows, quarter));
    }
    const auto made = static_cast<double>(run.designs);
    if (trials::kUpdateMethods[i] == robot::UpdateMethod::kDistinctPoles) {
      designs = made;
      error = largest;
      accepted = static_cast<double>(run.accepted) / static_cast<double>(run.looks);
    } else {
      other_designs = std::min(other_designs, made);
      other_error = std::min(other_error, largest);
    }
    designs_text += number_as(" %.0f", made);
    errors_text += number_as(" %.3f", largest);
    work.x.push_back(static_cast<double>(i) + 1.0);
    work.y.push_back(made);
    quality.x.push_back(static_cast<double>(i) + 1.0);
    quality.y.push_back(largest);
  }
  StudyResult result;
  result.measured = {{"S5.3.least_designs", designs / other_designs, designs_text + " by (a) to (d)"},
                     {"S5.3.appropriate", error / other_error, errors_text + " by (a) to (d)"},
                     {"S5.3.robust", accepted, ""}};
  result.pictures = {
      {"Update logics on the load cycle: 1 to 4 are (a) to (d)",
       2,
       {{.title = "",
         .x_label = "logic",
         .y_label = "controllers designed",
         .log_y = true,
         .series = {std::move(work)}},
        {.title = "", .x_label = "logic", .y_label = "NRMSE", .log_y = true, .series = {std::move(quality)}}}}};
  return result;
}

constexpr const char* kSwitch =
    "The adaptive controller behavior shall be stable and robust against switching dynamics, that is, when the robot "
    "switches from a "
    "stance phase to a flight phase.";

constexpr ClaimSpec kSwitchClaims[] = {aim({"S10.3.dwell", "10.3", kSwitch,
                                            "Largest dwell time that a joint of hyq.yaml needs between the gains "
                                            "stored for its phases, over its shortest phase: 1.",
                                            "1", Relation::kAtMost, 1.0})};

Result<StudyResult> run_switch(const StudyContext& context) {
  const auto hyq = FARRIER_TRY(load(context, "hyq.yaml"));
  const int delay = hyq.loop_delay_lockstep;
  const int shortest = supervisor::shortest_phase_ticks(hyq);
  double common = 0.0, longest = 0.0;
  for (const robot::Joint& joint : hyq.joints) {
    const auto design = [&](const plant::LoadParams& load_of) {
      return control::design_lqr(robot::model_of(joint, load_of, hyq.period_s), joint.design.weights,
                                 joint.normalisation, joint.form, delay);
    };
    const auto stance = design(joint.stance_load);
    const auto swing = design(joint.swing_load);
    if (!stance || !swing) {
      return Error{joint.name + ": no gains for one of its phases"};
    }
    const control::SwitchingVerdict verdict =
        control::switching_verdict(stance.value().model, stance.value(), swing.value().model, swing.value(), delay);
    common += verdict.common ? 1.0 : 0.0;
    longest = std::max(longest, static_cast<double>(verdict.dwell_ticks));
  }
  StudyResult result;
  result.measured = {{"S10.3.dwell", longest / shortest,
                      number_as("%.0f ticks of ", longest) +
                          number_as("%.0f; a common quadratic Lyapunov function: ", shortest) +
                          number_as("%.0f joints", common)}};
  return result;
}

constexpr Study kStudies[] = {
    {"S5.3", "The four update logics", kLogicClaims, run_logics,
     "fc1d.yaml on the load cycle of Fig. 7.6: noise, probed valve, xi = 14, estimator and thresholds of the file."},
    {"S10.3", "Switching between stance and flight", kSwitchClaims, run_switch,
     "hyq.yaml, gains for its stance and swing loads, lock-step clock."}};

}  // namespace
}  // namespace section5_update_studies

std::span<const Study> section5_update() { return section5_update_studies::kStudies; }

}  // namespace farrier::thesis
