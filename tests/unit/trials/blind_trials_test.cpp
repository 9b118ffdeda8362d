// The rules of judgement on a few blind trials, and the arithmetic of their score. All trials: farrier diagnose
// --benchmark.

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <fstream>
#include <limits>
#include <set>

#include "diagnosis/model/sides_of_joint.hpp"
#include "tests/support/scratch_directory.hpp"
#include "trials/blind/outcomes_file.hpp"
#include "trials/blind/score.hpp"

namespace farrier::blind {
namespace blind_trials_test {

Outcome outcome(Kind kind, const char* hidden, const char* named, double confidence, double detectable = 1.0) {
  Outcome o;
  o.plan.kind = kind;
  if (*hidden != '\0') {
    o.plan.plan.hidden = {{hidden, 1}};
    o.answers = {{hidden, 1.0}};
  }
  o.detectable = detectable;
  o.verdict = *named != '\0' ? diagnosis::Verdict::kEffects : diagnosis::Verdict::kNone;
  if (*named != '\0') {
    o.named = {{named, 1.0, confidence}};
  }
  o.error_before = 3.0;
  o.error_after = 1.0;
  return o;
}

TEST(BlindScore, CountsWhatTheEffectChangedAndNotTheRest) {
  const Score s = score({outcome(Kind::kEffect, "valve_bias", "valve_bias", 1.0),
                         outcome(Kind::kEffect, "valve_bias", "", 1.0, 0.05),
                         outcome(Kind::kEffect, "valve_bias", "load_mass", 0.95)});
  EXPECT_EQ(s.trials, 3u);
  EXPECT_EQ(s.counted, 2u);
  EXPECT_DOUBLE_EQ(s.named, 0.5);
  EXPECT_DOUBLE_EQ(s.first_alone, 0.5);
  EXPECT_DOUBLE_EQ(s.confidently_wrong, 1.0 / 3.0);
  EXPECT_DOUBLE_EQ(s.median_gain, 3.0);
}

TEST(BlindScore, SetsThatTheirRecordingsSeparateAreCountedBesideAll) {
  const auto set = [](bool named, bool separable) {
    Outcome o = outcome(Kind::kSet, "valve_bias", "valve_bias", 0.9);
    o.plan.plan.hidden.push_back({"external_force", 1});
    if (named) {
      o.named.push_back({"external_force", 1.0, 0.9});
    }
    if (!separable) {
      o.inseparable = {"external_force"};
    }
    return o;
  };
  Outcome refused = set(false, true);
  refused.refused = kNotRun;
  const Score s = score({set(true, true), set(true, true), set(false, true), set(false, false), set(true, false),
                         refused, outcome(Kind::kEffect, "valve_bias", "", 0.0)});
  EXPECT_DOUBLE_EQ(s.sets_named.at(2), 0.6);
  EXPECT_EQ(s.separable.at(2), 3u);
  EXPECT_DOUBLE_EQ(s.separable_named.at(2), 2.0 / 3.0);
  EXPECT_EQ(s.separable.at(3), 0u);
  EXPECT_TRUE(std::isnan(s.separable_named.at(3)));
}

TEST(BlindScore, ASetOfTwoNamesTheEffectAndIsNotAlone) {
  Outcome o = outcome(Kind::kEffect, "valve_bias", "valve_asymmetry", 0.6);
  o.alternatives = {{"valve_asymmetry", "valve_bias"}};
  EXPECT_TRUE(named_or_in_pair(o));
  EXPECT_FALSE(first_alone(o));
  o.alternatives.emplace_back("valve_asymmetry", "supply_droop");
  EXPECT_FALSE(named_or_in_pair(o));
}

TEST(BlindScore, TheGainInControlIsTheMedianOfTrialsThatHaveOne) {
  Outcome none = outcome(Kind::kEffect, "load_friction", "load_friction", 1.0);
  Outcome less = outcome(Kind::kEffect, "valve_bias", "valve_bias", 1.0);
  Outcome more = outcome(Kind::kEffect, "valve_deadband", "valve_deadband", 1.0);
  less.control = {0.1, 0.1};
  more.control = {0.3, 0.1};
  EXPECT_EQ(score({none}).controlled, 0u);
  EXPECT_TRUE(std::isnan(score({none}).control_gain));
  const Score s = score({none, less, more, more});
  EXPECT_EQ(s.controlled, 3u);
  EXPECT_DOUBLE_EQ(s.control_gain, 3.0);
  EXPECT_DOUBLE_EQ(score_by_effect({none, less, more})["valve_bias"].control_gain, 1.0);
}

TEST(BlindScore, FalseAlarmsAreOfTrialsThatHideNothing) {
  const Score s = score({outcome(Kind::kNone, "", "", 0.0), outcome(Kind::kNone, "", "load_mass", 0.5)});
  EXPECT_DOUBLE_EQ(s.false_alarms, 0.5);
}

TEST(BlindTrials, AFewOfThemAreNamedAndNothingIsNamedWhereNothingIsHidden) {
  const robot::Robot rig = robot::load_robot(FARRIER_ROBOTS "fc1d.yaml").value();
  const robot::Robot legs = robot::load_robot(FARRIER_ROBOTS "hyq.yaml", {.without_effects = true}).value();
  const std::vector<const robot::Joint*> joints{&rig.joints.front(), &legs.joints.front()};
  std::vector<TrialPlan> plans;
  for (const char* name : {"valve_deadband", "load_friction", "force_sensor_gain", "velocity_filter_lag"}) {
    plans.push_back(
        {Kind::kEffect, plans.size() % 2, {90 + plans.size(), truth::Excitation::kRandomSteps, {{name, 2}}}});
  }
  plans.push_back({Kind::kNone, 0, {80, truth::Excitation::kMultisine, {}}});
  plans.push_back({Kind::kNone, 1, {81, truth::Excitation::kForceTracking, {}}});
  const auto outcomes = run_trials(plans, joints, 2, [](std::size_t, const Outcome&) { return true; });
  const Score s = score(outcomes);
  EXPECT_EQ(s.counted, 4u);
  EXPECT_DOUBLE_EQ(s.first_alone, 1.0) << confusion_page(outcomes);
  EXPECT_DOUBLE_EQ(s.within_tolerance, 1.0) << confusion_page(outcomes);
  EXPECT_DOUBLE_EQ(s.false_alarms, 0.0) << confusion_page(outcomes);
  EXPECT_GT(s.median_gain, 3.0);
}

TEST(BlindTrials, EffectsOfElectricJointsAreNamedAndNothingIsWhereNothingIsHidden) {
  const robot::Robot leg = robot::load_robot(FARRIER_ROBOTS "electric_leg.yaml").value();
  const robot::Robot go1 = robot::load_robot(FARRIER_ROBOTS "go1.yaml").value();
  const std::vector<const robot::Joint*> joints{&leg.joints.front(), &go1.joints.front()};
  const auto plan = [](Kind kind, std::size_t joint, std::vector<truth::Hidden> hidden) {
    return TrialPlan{kind, joint, {90, truth::Excitation::kMultisine, std::move(hidden), 4.0}};
  };
  const auto outcomes = run_trials({plan(Kind::kEffect, 0, {{"gear_friction", 1}}),
                                    plan(Kind::kEffect, 1, {{"cogging", 2}}), plan(Kind::kNone, 1, {})},
                                   joints, 2, [](std::size_t, const Outcome&) { return true; });
  const Score s = score(outcomes);
  EXPECT_EQ(s.counted, 2u);
  EXPECT_DOUBLE_EQ(s.first_alone, 1.0) << confusion_page(outcomes);
  EXPECT_DOUBLE_EQ(s.within_tolerance, 1.0) << confusion_page(outcomes);
  EXPECT_DOUBLE_EQ(s.false_alarms, 0.0) << confusion_page(outcomes);
}

TEST(BlindTrials, EveryEffectOfTheLibraryIsHiddenInElectricJointsThatCanHaveIt) {
  const robot::Robot leg = robot::load_robot(FARRIER_ROBOTS "electric_leg.yaml").value();
  const robot::Robot go1 = robot::load_robot(FARRIER_ROBOTS "go1.yaml").value();
  const std::vector<const robot::Joint*> joints{&leg.joints.front(), &go1.joints.front()};
  std::array<std::set<std::string>, 2> hidden;
  for (const TrialPlan& plan : all_electric_trials(joints, 1)) {
    if (plan.kind == Kind::kEffect) {
      hidden[plan.joint].insert(plan.plan.hidden.front().name);
    }
  }
  for (std::size_t joint = 0; joint < joints.size(); ++joint) {
    const auto sides = diagnosis::sides_of(*joints[joint]);
    for (plant::EffectId id = 0; id < plant::kNameableCount; ++id) {
      const diagnosis::ChannelMask shows = sides->channels(id);
      EXPECT_EQ(hidden[joint].contains(plant::effect_info(id).name), diagnosis::meet(shows, shows))
          << joint << " " << plant::effect_info(id).name;
    }
  }
}

TEST(BlindTrials, ConstantsOffTheirFileAreNoSecondEffectBesideALargeOne) {
  const robot::Robot legs = robot::load_robot(FARRIER_ROBOTS "hyq.yaml", {.without_effects = true}).value();
  const TrialPlan plan{Kind::kEffect, 0, {5003, truth::Excitation::kMultisine, {{"internal_leakage", 1}}}};
  const Outcome outcome = run_trial(plan, {&legs.joints.front()});
  ASSERT_EQ(outcome.named.size(), 1u) << outcome.named.back().name;
  EXPECT_EQ(outcome.named.front().name, "internal_leakage");
  EXPECT_LT(outcome.parameter_error, 0.1);
  EXPECT_GT(outcome.named.front().confidence, kConfident);
  EXPECT_LT(outcome.named.front().confidence, 1.0);
  ASSERT_TRUE(outcome.named.front().fit_error);
}

/// Runs a trial of the first joint of HyQ.
Outcome of_hyq(std::vector<truth::Hidden> hidden, std::uint64_t seed, truth::Excitation excitation,
               double duration_s = 8.0) {
  const robot::Robot legs = robot::load_robot(FARRIER_ROBOTS "hyq.yaml", {.without_effects = true}).value();
  const Kind kind = hidden.size() > 1 ? Kind::kSet : Kind::kEffect;
  return run_trial({kind, 0, {seed, excitation, std::move(hidden), duration_s}}, {&legs.joints.front()});
}

TEST(BlindTrials, AStopThatIsHitOnceIsNamedAlthoughOneHalfCannotShowIt) {
  const Outcome outcome = of_hyq({{"end_stop", 0}}, 200192, truth::Excitation::kForceTracking);
  EXPECT_TRUE(first_alone(outcome)) << confusion_page({outcome});
  EXPECT_EQ(outcome.verdict, diagnosis::Verdict::kEffects);
  EXPECT_LT(outcome.parameter_error, 0.02);
}

TEST(BlindTrials, ADelayBeforeAValveFarTooLargeIsNoSlowSpool) {
  const Outcome outcome = of_hyq({{"input_delay", 0}}, 200048, truth::Excitation::kForceTracking);
  EXPECT_TRUE(named_or_in_pair(outcome)) << confusion_page({outcome});
}

TEST(BlindTrials, AnOverlapIsSoughtAtTheSizeOfTheCurrentsThatFlow) {
  const Outcome outcome = of_hyq({{"valve_deadband", 0}}, 200002, truth::Excitation::kRandomSteps);
  EXPECT_TRUE(first_alone(outcome)) << confusion_page({outcome});
  EXPECT_LT(outcome.parameter_error, 0.1);
}

TEST(BlindTrials, AnOverlapAndABiasOfWhichNeitherExplainsTheForceAloneAreNamedTogether) {
  const Outcome outcome =
      of_hyq({{"valve_bias", 2}, {"valve_deadband", 2}}, 200304, truth::Excitation::kMultisine, 3.0);
  EXPECT_TRUE(all_named(outcome)) << confusion_page({outcome});
  EXPECT_EQ(outcome.named.size(), 2u);
  EXPECT_EQ(outcome.verdict, diagnosis::Verdict::kEffects);
  for (const Named& named : outcome.named) {
    EXPECT_LT(named.size_error.value(), 0.02) << named.name;
  }
}

TEST(BlindTrials, ASpringOfAnotherStiffnessThatHardensIsNamedAlthoughAFitDiverges) {
  const robot::Robot rig = robot::load_robot(FARRIER_ROBOTS "fc1d.yaml").value();
  const Outcome outcome = run_trial({Kind::kSet,
                                     0,
                                     {200335,
                                      truth::Excitation::kRandomSteps,
                                      {{"spring_hardening", 1}, {"internal_leakage", 2}, {"load_stiffness", 2}}}},
                                    {&rig.joints.front()});
  EXPECT_TRUE(all_named(outcome)) << confusion_page({outcome});
  for (const Named& named : outcome.named) {
    EXPECT_TRUE(std::isfinite(named.confidence)) << named.name;
  }
}

TEST(BlindTrials, AForceNamedForAnOffsetBesideSomethingUnexplainedIsNotSure) {
  const Outcome outcome = of_hyq({{"force_sensor_offset", 2}, {"valve_dynamics", 1}, {"air_entrainment", 1}}, 200324,
                                 truth::Excitation::kForceTracking);
  for (const Named& named : outcome.named) {
    EXPECT_TRUE(hides(outcome, named.name) || named.confidence < kConfident) << named.name << " " << named.confidence;
  }
}

TEST(BlindTrials, AHysteresisOfTheValveIsNamedAtEachOfItsSizes) {
  const robot::Robot rig = robot::load_robot(FARRIER_ROBOTS "fc1d.yaml").value();
  for (int magnitude = 0; magnitude < 3; ++magnitude) {
    const truth::Plan plan{200001, static_cast<truth::Excitation>(magnitude), {{"valve_hysteresis", magnitude}}, 4.0};
    const Outcome outcome = run_trial({Kind::kEffect, 0, plan}, {&rig.joints.front()});
    EXPECT_TRUE(first_alone(outcome)) << confusion_page({outcome});
    EXPECT_LT(outcome.parameter_error, 0.05) << magnitude;
  }
}

TEST(BlindTrials, ASetSaysBeforeItsDiagnosisWhatTheRecordingCannotSeparate) {
  const robot::Robot legs = robot::load_robot(FARRIER_ROBOTS "hyq.yaml", {.without_effects = true}).value();
  const auto inseparable = [&](std::vector<truth::Hidden> hidden) {
    const TrialPlan plan{Kind::kSet, 0, {200380, truth::Excitation::kMultisine, std::move(hidden), 2.0}};
    return run_trial(plan, {&legs.joints.front()}).inseparable;
  };
  // A spring that is slack away from the joint's middle pulls as a constant force does.
  EXPECT_EQ(inseparable({{"load_stiffness", 1}, {"external_force", 1}}), std::vector<std::string>{"external_force"});
  EXPECT_TRUE(inseparable({{"load_stiffness", 1}, {"valve_deadband", 1}}).empty());
}

TEST(BlindTrials, AfterAStopAreNotRunAndSaySo) {
  const robot::Robot rig = robot::load_robot(FARRIER_ROBOTS "fc1d.yaml").value();
  const std::vector<TrialPlan> plans(3, {Kind::kNone, 0, {80, truth::Excitation::kMultisine, {}}});
  const auto outcomes = run_trials(plans, {&rig.joints.front()}, 1, [](std::size_t, const Outcome&) { return false; });
  ASSERT_EQ(outcomes.size(), 3u);
  EXPECT_EQ(std::ranges::count(outcomes, std::string(), &Outcome::refused), 1);
  EXPECT_EQ(std::ranges::count(outcomes, kNotRun, &Outcome::refused), 2);
}

// The line of trial 1 does not say what its recording can separate, as those of earlier versions.
TEST(OutcomesFile, ReturnsTheOutcomesOfItsOriginAlsoAfterALineThatWasCutOff) {
  const test::ScratchDirectory scratch;
  const std::string path = scratch.file("figures.json.trials");
  const std::vector<TrialPlan> plans(3, {Kind::kEffect, 0, {80, truth::Excitation::kMultisine, {}}});
  Outcome first = outcome(Kind::kEffect, "load_mass", "load_mass", 0.5);
  first.parameter_error = std::numeric_limits<double>::infinity();
  first.alternatives = {{"load_mass", "load_friction"}};
  first.control = trials::TrackingGain{0.3, 0.1};
  first.inseparable = {"load_mass"};
  first.named.front().evidence.runner_up = 0.25;
  first.named.front().fit_error = 0.5;
  first.named.front().size_error = 0.125;
  ASSERT_TRUE(append_outcome(path, "this build", 0, first));
  std::ofstream(path, std::ios::app) << R"({"trial":1,"detect)";
  ASSERT_TRUE(append_outcome(path, "this build", 2, outcome(Kind::kEffect, "load_mass", "", 0.0)));
  ASSERT_TRUE(append_outcome(path, "another build", 1, first));
  std::ofstream(path, std::ios::app)
      << R"({"origin":"this build","trial":1,"detectable":1.0,"verdict":1,"parameter_error":0.0,"error_before":0.0,)"
      << R"("error_after":0.0,"cpu_s":1.0,"answers":[],"named":[],"alternatives":[]})"
      << "\n";
  const auto kept = read_outcomes(path, "this build", plans);
  ASSERT_EQ(kept.size(), 2u);
  const Outcome& back = kept.at(0);
  EXPECT_EQ(back.plan.kind, Kind::kEffect);
  EXPECT_EQ(back.answers.front().name, first.answers.front().name);
  EXPECT_EQ(back.named.front().confidence, first.named.front().confidence);
  EXPECT_EQ(back.named.front().evidence.runner_up, 0.25);
  EXPECT_EQ(back.named.front().fit_error, 0.5);
  EXPECT_EQ(back.named.front().size_error, 0.125);
  EXPECT_FALSE(kept.at(2).control);
  EXPECT_EQ(back.detectable, first.detectable);
  EXPECT_EQ(back.parameter_error, first.parameter_error);
  EXPECT_EQ(back.alternatives, first.alternatives);
  EXPECT_EQ(back.inseparable, first.inseparable);
  EXPECT_EQ(back.control->new_nrmse, 0.1);
  EXPECT_TRUE(kept.at(2).named.empty());
  EXPECT_TRUE(read_outcomes(scratch.file("no such file"), "this build", plans).empty());
}

}  // namespace blind_trials_test
}  // namespace farrier::blind
