#include "diagnosis.hpp"

#include <fstream>
#include <limits>
#include <sstream>

#include <nlohmann/json.hpp>

#include "report/diagnosis/diagnosis_json.hpp"
#include "report/diagnosis/diagnosis_page.hpp"
#include "report/diagnosis/diagnosis_pictures.hpp"
#include "report/diagnosis/diagnosis_text.hpp"

namespace farrier::report {
namespace diagnosis_test {

using diagnosis::Diagnosis;
using diagnosis::Verdict;
using testing::diagnosis_of;
using testing::id_of;

std::string text_of(const std::string& path) {
  std::ostringstream text;
  text << std::ifstream(path).rdbuf();
  return text.str();
}

class DiagnosisReport : public testing::OwnFolder {
 protected:
  DiagnosisResult result(const Diagnosis& d) const {
    DiagnosisResult made{
        .diagnosis = d,
        .robot = robot_,
        .joint = robot_.joints[0],
        .recording = "run.csv",
        .period_s = 0.001,
        .model = d.judgement.effects.empty()
                     ? ModelOfDiagnosis{}
                     : ModelOfDiagnosis{"out/model.yaml", {}, diagnosis::ErrorRatio{0.4, 0.2, 1.5, 2.5}}};
    if (d.judgement.verdict == Verdict::kBadData) {
      made.findings = {{.what = "gap", .row = 17, .text = "run.csv lacks samples"},
                       {.what = "too_short", .row = 0, .text = "give a second at least"}};
    }
    return made;
  }
  Outcome outcome(const Diagnosis& d) const {
    Outcome made{.command = "diagnose", .figures = {}, .run = run_info(robot_, 0), .failures = {}};
    made.finding = to_string(d.judgement.verdict);
    add_diagnosis(made.figures, result(d));
    return made;
  }
  nlohmann::json json(const Diagnosis& d) const { return nlohmann::json::parse(diagnosis_json(result(d), outcome(d))); }
  std::string console(const Diagnosis& d) const { return diagnosis_console(result(d)); }

  /// The experiment and the pair it is for.
  static Diagnosis inseparable() {
    Diagnosis d = diagnosis_of(Verdict::kCannotSeparate);
    d.judgement.effects = {testing::two_effects()[0]};
    d.judgement.alternatives = {{id_of("load_friction"), id_of("load_damping")}};
    d.experiments = {{.one = id_of("load_friction"),
                      .other = id_of("load_damping"),
                      .excitation = "sine",
                      .amplitude_A = 0.002,
                      .frequency_Hz = 3.0,
                      .duration_s = 10.0,
                      .difference = 7.5}};
    return d;
  }
  static Diagnosis bad() {
    Diagnosis d{};
    d.judgement.verdict = Verdict::kBadData;
    return d;
  }
  static Diagnosis with_effects() {
    Diagnosis d = diagnosis_of(Verdict::kEffects);
    d.judgement.effects = testing::two_effects();
    d.judgement.not_judged = {id_of("valve_bias")};
    return d;
  }

  const robot::Robot robot_ = testing::rig();
};

TEST_F(DiagnosisReport, JsonHasTheCommonFormAndTheVerdictInItsPlace) {
  const auto j = json(with_effects());
  EXPECT_EQ(j["command"], "diagnose");
  EXPECT_EQ(j["verdict"], "effects");
  EXPECT_EQ(j["joint"], "fc1d");
  for (const char* part : {"figures", "run"}) {
    EXPECT_TRUE(j.contains(part)) << part;
  }
  EXPECT_EQ(j["figures"][0], nlohmann::json::parse(R"({"name": "diagnose.valve_and_oil.one_step_nrmse_before",
                                                       "value": 0.02, "unit": "1"})"));
  EXPECT_EQ(j["held_out"],
            nlohmann::json::parse(R"({"nrmse_before": 0.4, "nrmse_after": 0.1, "low": 3.5, "high": 4.5})"));
  EXPECT_EQ(j["extended_model"], "out/model.yaml");
  EXPECT_EQ(j["extended_model_held_out"]["nrmse_after"], 0.2);
  EXPECT_EQ(j["not_judged"], nlohmann::json::parse(R"(["valve_bias"])"));
  EXPECT_TRUE(j["experiment"].is_null());
  EXPECT_TRUE(j["control"].is_null());
  EXPECT_FALSE(j.contains("findings"));
}

TEST_F(DiagnosisReport, JsonHasEffectsByShareInTheUnitsOfTheFile) {
  const auto effects = json(with_effects())["effects"];
  ASSERT_EQ(effects.size(), 2u);
  const plant::Scales scales(robot_.joints[0].actuator, robot_.joints[0].swing_load);
  const double push = scales.of(plant::Scale::kForce);
  EXPECT_EQ(effects[0]["name"], "load_friction");
  EXPECT_EQ(effects[0]["parameter"], "coulomb_N");
  EXPECT_EQ(effects[0]["unit"], "N");
  EXPECT_NEAR(effects[0]["value"].get<double>(), 0.02 * push, 1e-9 * push);
  EXPECT_NEAR(effects[0]["low"].get<double>(), (0.02 - 1.96 * 0.001) * push, 1e-9 * push);
  EXPECT_NEAR(effects[0]["high"].get<double>(), (0.02 + 1.96 * 0.001) * push, 1e-9 * push);
  EXPECT_EQ(effects[0]["confidence"], 0.99);
  EXPECT_EQ(effects[0]["parameters"].size(), 3u);
  // Over the fitted number: a longer time is a lower frequency, and the interval is not symmetric.
  EXPECT_EQ(effects[1]["name"], "valve_dynamics");
  EXPECT_NEAR(effects[1]["value"].get<double>(), 1.0 / 0.004, 1e-9);
  EXPECT_NEAR(effects[1]["low"].get<double>(), 1.0 / (0.004 + 1.96 * 0.0002), 1e-9);
  EXPECT_NEAR(effects[1]["high"].get<double>(), 1.0 / (0.004 - 1.96 * 0.0002), 1e-9);
}

TEST_F(DiagnosisReport, RotaryJointsHaveTheirOwnNamesAndUnits) {
  const robot::Robot hyq = testing::hyq();
  const robot::Joint& hip = *hyq.find("lf_haa");
  ASSERT_TRUE(hip.rotary);
  const ShownEffect effect = shown(testing::two_effects()[0], hip);
  EXPECT_EQ(effect.numbers[0].name, "coulomb_Nm");
  EXPECT_EQ(effect.numbers[0].unit, "Nm");
  EXPECT_NEAR(effect.numbers[0].value, 0.02 * plant::Scales(hip.actuator, hip.swing_load).of(plant::Scale::kForce),
              1e-9);
}

TEST_F(DiagnosisReport, AnIntervalStaysWithinWhatItsParameterMayBe) {
  diagnosis::NamedEffect effect = testing::two_effects()[0];
  effect.deviation = 1.0;
  const ShownEffect wide = shown(effect, robot_.joints[0]);
  EXPECT_GT(wide.low, 0.0);
  EXPECT_TRUE(std::isfinite(wide.high));
}

TEST_F(DiagnosisReport, JsonHasThePairAndTheExperimentThatWouldTellItApart) {
  const auto j = json(inseparable());
  EXPECT_EQ(j["verdict"], "cannot_separate");
  EXPECT_EQ(j["alternatives"], nlohmann::json::parse(R"([["load_friction", "load_damping"]])"));
  EXPECT_EQ(j["experiment"]["excitation"], "sine");
  EXPECT_EQ(j["experiment"]["amplitude_A"], 0.002);
  EXPECT_EQ(j["experiments"].size(), 1u);
}

TEST_F(DiagnosisReport, ExperimentOfAnElectricJointIsATorqueBesideAHold) {
  Diagnosis d = inseparable();
  EXPECT_TRUE(json(d)["experiment"]["hold_stiffness_Nm_rad"].is_null());
  d.experiments.front().amplitude_Nm = 7.1;
  d.experiments.front().hold = {8.0, 0.6};
  const auto experiment = json(d)["experiment"];
  EXPECT_EQ(experiment["amplitude_Nm"], 7.1);
  EXPECT_EQ(experiment["hold_stiffness_Nm_rad"], 8.0);
  EXPECT_EQ(experiment["hold_damping_Nms_rad"], 0.6);
  EXPECT_EQ(experiment["text"],
            "a sine of the commanded torque of 7.1 Nm (0.002 A) at 3 Hz for 10 s, beside a hold amid the travel of 8 "
            "Nm/rad and 0.6 Nms/rad: they differ by 7.5 times a sensor's noise");
}

TEST_F(DiagnosisReport, SaysThatNoExperimentThatWasTriedTellsAPairApart) {
  Diagnosis d = inseparable();
  d.experiments.front().difference = 1.2;
  EXPECT_NE(console(d).find("this recording does not tell load_friction from load_damping; no sine and no steps of the "
                            "current that were tried would: they differ by 1.2 times a sensor's noise at most"),
            std::string::npos)
      << console(d);
}

TEST_F(DiagnosisReport, JsonOfBadDataHasItsFindingsAndNothingElse) {
  const auto j = json(bad());
  EXPECT_EQ(j["verdict"], "bad_data");
  EXPECT_EQ(j["findings"][0], nlohmann::json::parse(R"({"what": "gap", "row": 17, "text": "run.csv lacks samples"})"));
  EXPECT_TRUE(j["effects"].empty() && j["figures"].empty() && j["channels"].empty());
  EXPECT_TRUE(j["held_out"].is_null());
  EXPECT_TRUE(j["extended_model"].is_null());
}

TEST_F(DiagnosisReport, JsonHasTheGainOfControlWhereItWasMeasured) {
  const Diagnosis d = with_effects();
  DiagnosisResult measured = result(d);
  measured.control = ControlGain{"load_friction", 0.1, 0.05};
  Outcome with = outcome(d);
  with.figures = {};
  add_diagnosis(with.figures, measured);
  EXPECT_EQ(outcome(d).figures.find("diagnose.control.ratio"), nullptr);
  EXPECT_EQ(with.figures.find("diagnose.control.old_nrmse")->value, 0.1);
  EXPECT_EQ(with.figures.find("diagnose.control.new_nrmse")->value, 0.05);
  EXPECT_EQ(with.figures.find("diagnose.control.ratio")->value, 2.0);
  const auto j = nlohmann::json::parse(diagnosis_json(measured, with));
  EXPECT_EQ(j["control"], nlohmann::json::parse(R"({"effect": "load_friction", "old_nrmse": 0.1, "new_nrmse": 0.05})"));
  EXPECT_NE(diagnosis_console(measured).find("force control that knows load_friction: NRMSE 0.1 before, 0.05 after"),
            std::string::npos);
}

TEST_F(DiagnosisReport, NumbersThatAreNotFiniteAreNull) {
  Diagnosis d = diagnosis_of(Verdict::kNone);
  d.channels[0].before.free_running = std::numeric_limits<double>::infinity();
  d.judgement.left[0].nrmse = std::numeric_limits<double>::quiet_NaN();
  const auto j = json(d);
  EXPECT_TRUE(j["channels"][0]["left"]["nrmse"].is_null());
  EXPECT_NE(console(d).find("- -> 0.05"), std::string::npos) << console(d);
}

TEST_F(DiagnosisReport, ConsoleNamesTheEffectsWithTheirNumbersAndWhereTheModelIs) {
  const std::string text = console(with_effects());
  EXPECT_NE(text.find("cause: the model lacks load_friction and valve_dynamics"), std::string::npos) << text;
  EXPECT_NE(text.find("load_friction: coulomb_N "), std::string::npos) << text;
  EXPECT_NE(text.find("confidence 0.99, 67 % of the gain"), std::string::npos) << text;
  EXPECT_NE(text.find("this recording could not show: valve_bias"), std::string::npos) << text;
  EXPECT_NE(text.find("extended model: out/model.yaml"), std::string::npos) << text;
  EXPECT_NE(text.find("0.4 before, 0.1 after: the error is divided by 4 (95 %: 3.5 to 4.5)"), std::string::npos)
      << text;
  EXPECT_NE(text.find("jumps up where the sign changes of speed"), std::string::npos) << text;
  EXPECT_TRUE(text.ends_with("diagnose: effects\n")) << text;
}

TEST_F(DiagnosisReport, ConsoleSaysOfEveryOtherVerdictWhatToDo) {
  const std::string none = console(diagnosis_of(Verdict::kNone));
  EXPECT_NE(none.find("the model explains this recording"), std::string::npos) << none;
  EXPECT_EQ(none.find("extended model"), std::string::npos) << none.substr(none.find("cause"));
  EXPECT_TRUE(none.ends_with("diagnose: none\n"));
  const std::string alike = console(inseparable());
  EXPECT_NE(alike.find("does not tell load_friction from load_damping; what would: a sine of the current of 2 mA at 3 "
                       "Hz for 10 s"),
            std::string::npos)
      << alike;
  const std::string unknown = console(diagnosis_of(Verdict::kUnknown));
  EXPECT_NE(unknown.find("12 N rms are left, where the sensors' noise explains 3; NRMSE 0.3; strongest at 4 Hz"),
            std::string::npos)
      << unknown;
  const std::string still = console(diagnosis_of(Verdict::kNotExcited));
  EXPECT_NE(still.find("record again"), std::string::npos) << still;
  const std::string refused = console(bad());
  EXPECT_NE(refused.find("row 17: run.csv lacks samples (gap)"), std::string::npos) << refused;
  EXPECT_NE(refused.find("\n  give a second at least (too_short)"), std::string::npos) << refused;
}

TEST_F(DiagnosisReport, PageShowsEveryPictureItNamesAndNothingFromElsewhere) {
  Diagnosis d = with_effects();
  d.judgement.rounds = {{{id_of("load_friction"), {1.0, 0.8, 1.2, {}, {}, 1.0}, 0.02, 0.001, true},
                         {id_of("load_damping"), {0.1, -0.1, 0.2, {}, {}, 0.6}, 1.1, 0.1, false}},
                        {}};
  const auto page = write_diagnosis_page(path_, result(d), outcome(d));
  ASSERT_TRUE(page.ok()) << page.error().message;
  const std::string html = text_of(page.value());
  int pictures = 0;
  for (std::size_t at = 0; (at = html.find("<img src=\"", at)) != std::string::npos; ++pictures) {
    at += std::string("<img src=\"").size();
    const std::string name = html.substr(at, html.find('"', at) - at);
    EXPECT_NE(text_of(path_ + "/" + name).find("</svg>"), std::string::npos) << name;
  }
  EXPECT_EQ(pictures, 4);
  EXPECT_EQ(html.find("http"), std::string::npos);
  EXPECT_NE(html.find("class=\"verdict warn\">cause found<"), std::string::npos);
}

TEST_F(DiagnosisReport, PageOfBadDataOrOfEmptyChannelsHasNoPictures) {
  Diagnosis d = diagnosis_of(Verdict::kNone);
  const double nan = std::numeric_limits<double>::quiet_NaN();
  d.channels[0].measured = {nan, nan};
  d.channels[0].frequency_Hz.clear();
  d.channels[0].dependences.clear();
  for (const Diagnosis& one : {bad(), d}) {
    const auto page = write_diagnosis_page(path_, result(one), outcome(one));
    EXPECT_TRUE(page.ok()) << page.error().message;
  }
}

TEST_F(DiagnosisReport, PageBeginsWithThePartThatIsFaultyAndTheNextSteps) {
  Diagnosis d = inseparable();
  const auto page = write_diagnosis_page(path_, result(d), outcome(d));
  ASSERT_TRUE(page.ok());
  const std::string html = text_of(page.value());
  EXPECT_NE(html.find("several causes possible"), std::string::npos);
  const std::size_t steps = html.find("Next steps");
  ASSERT_NE(steps, std::string::npos);
  for (const char* const text : {"<b>load friction</b>", "load bearings", "one of several", "<b>load damping</b>"}) {
    EXPECT_LT(html.find(text), steps) << text;
  }
  EXPECT_NE(html.find("a sine of the current of 2 mA at 3 Hz", steps), std::string::npos);
}

}  // namespace diagnosis_test
}  // namespace farrier::report
