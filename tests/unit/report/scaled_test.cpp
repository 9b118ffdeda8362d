// Diagnoses of recordings in scaled units: text, JSON, page.

#include <fstream>
#include <sstream>

#include <nlohmann/json.hpp>

#include "diagnosis.hpp"
#include "report/diagnosis/scaled_json.hpp"
#include "report/diagnosis/scaled_page.hpp"
#include "report/diagnosis/scaled_text.hpp"

namespace farrier::report {
namespace scaled_test {

using diagnosis::ScaledDiagnosis;
using diagnosis::Verdict;
using testing::id_of;

/// The scales of a joint whose valve is fully open at 2.
plant::Scales scales() {
  return {plant::ActuatorParams{.area_a = 1.0,
                                .area_b = 1.0,
                                .stroke = 1.0,
                                .line_volume_m3 = 1.0,
                                .bulk_modulus_Pa = 1.0,
                                .valve_gain = 1.0,
                                .valve_current_max_A = 2.0,
                                .supply_pressure_Pa = 1.0},
          {}};
}

ScaledDiagnosis saturated() {
  ScaledDiagnosis d{.judgement = {},
                    .scales = scales(),
                    .gain_before = -0.03,
                    .drift_before = -0.002,
                    .gain_after = -0.06,
                    .drift_after = 0.004,
                    .fit_before_percent = -16.64,
                    .fit_after_percent = 85.26,
                    .error = {1.2, 0.15, 6.0, 10.0},
                    .alone = {{id_of("input_delay"), {0.004}, 0.001, -14.0, false},
                              {id_of("flow_saturation"), {4.0}, 0.1, 85.26, true}},
                    .held_out_begin = 500,
                    .measured = {},
                    .before = {},
                    .after = {},
                    .remarks = {"Column 'pressure' is not read."}};
  d.judgement.verdict = Verdict::kEffects;
  d.judgement.effects = {{id_of("flow_saturation"), {4.0}, 0.1, 1.0, 0.99}};
  d.judgement.not_judged = {id_of("load_mass")};
  d.judgement.rounds = {{{id_of("flow_saturation"), {1.0, 0.8, 1.2, {}, {}, 1.0}, 4.0, 0.1, true}}, {}};
  for (int i = 0; i < 500; ++i) {
    d.measured.push_back(std::sin(0.02 * i));
    d.before.push_back(2.0 * d.measured.back());
    d.after.push_back(1.1 * d.measured.back());
  }
  return d;
}

class ScaledReport : public testing::OwnFolder {
 protected:
  static Outcome outcome(const ScaledResult& result) {
    Outcome made{.command = "diagnose", .figures = {}, .run = run_info(0), .failures = {}};
    made.finding = to_string(result.verdict());
    if (result.diagnosis != nullptr) {
      add_diagnosis(made.figures, *result.diagnosis);
    }
    return made;
  }
  static nlohmann::json json(const ScaledResult& result) {
    return nlohmann::json::parse(scaled_json(result, outcome(result)));
  }
  static ScaledResult result(const ScaledDiagnosis& d) { return {.diagnosis = &d, .recording = "arm.csv"}; }
  static ScaledResult bad() {
    return {.diagnosis = nullptr, .recording = "arm.csv", .findings = {{"missing_sample", 17, "samples are missing"}}};
  }
};

TEST_F(ScaledReport, NumbersLoseTheUnitsThatTheRecordingLacks) {
  const auto number = [](const char* effect, std::size_t place, double fitted) {
    return shown(plant::effect_info(id_of(effect)).parameters[place], fitted, scales(), Units::kScaled);
  };
  const auto saturation = number("flow_saturation", 0, 4.0);
  EXPECT_EQ(saturation.name, "saturation_current");
  EXPECT_DOUBLE_EQ(saturation.value, 0.5);
  const auto delay = number("input_delay", 0, 0.004);
  EXPECT_EQ(delay.name, "delay");
  EXPECT_EQ(delay.unit, "samples");
  EXPECT_DOUBLE_EQ(delay.value, 4.0);
  const auto rate = number("valve_dynamics", 0, 0.002);
  EXPECT_EQ(rate.name, "natural_frequency");
  EXPECT_EQ(rate.unit, "rad/sample");
  EXPECT_DOUBLE_EQ(rate.value, 0.5);
  EXPECT_EQ(number("valve_dynamics", 1, 0.7).unit, "1");
}

TEST_F(ScaledReport, JsonHasTheFormOfADiagnosisWithoutAJoint) {
  const ScaledDiagnosis d = saturated();
  const auto j = json(result(d));
  EXPECT_EQ(j["command"], "diagnose");
  EXPECT_EQ(j["verdict"], "effects");
  EXPECT_EQ(j["units"], "scaled");
  for (const char* none : {"robot", "joint", "experiment", "control", "extended_model"}) {
    EXPECT_TRUE(j.contains(none) && j[none].is_null()) << none;
  }
  EXPECT_EQ(j["effects"][0]["name"], "flow_saturation");
  EXPECT_DOUBLE_EQ(j["effects"][0]["value"].get<double>(), 0.5);
  EXPECT_LT(j["effects"][0]["low"].get<double>(), 0.5);
  EXPECT_GT(j["effects"][0]["high"].get<double>(), 0.5);
  EXPECT_EQ(j["not_judged"], nlohmann::json::parse(R"(["load_mass"])"));
  EXPECT_EQ(j["held_out"],
            nlohmann::json::parse(R"({"nrmse_before": 1.2, "nrmse_after": 0.15, "low": 6.0, "high": 10.0})"));
  EXPECT_EQ(j["model"]["gain_after"], -0.06);
  EXPECT_EQ(j["candidates"][0], nlohmann::json::parse(R"({"name": "input_delay", "parameter": "delay", "value": 4.0,
                                     "unit": "samples", "fit_percent": -14.0, "accepted": false})"));
  EXPECT_EQ(j["figures"][0],
            nlohmann::json::parse(R"({"name": "diagnose.fit_before_percent", "value": -16.64, "unit": "%"})"));
  EXPECT_EQ(j["figures"][1]["name"], "diagnose.fit_after_percent");
}

TEST_F(ScaledReport, JsonOfBadDataHasItsFindings) {
  const auto j = json(bad());
  EXPECT_EQ(j["verdict"], "bad_data");
  EXPECT_EQ(j["findings"][0]["what"], "missing_sample");
  EXPECT_EQ(j["findings"][0]["row"], 17);
  EXPECT_TRUE(j["held_out"].is_null());
  EXPECT_TRUE(j["figures"].empty());
}

TEST_F(ScaledReport, ConsoleTellsEveryEffectsFitAndTheModel) {
  const ScaledDiagnosis d = saturated();
  const std::string text = scaled_console(result(d));
  for (const char* part : {"position+ = position - 0.03 valve - 0.002", "position+ = position - 0.06 q(valve) + 0.004",
                           "-16.6 % before, 85.3 % after", "delay 4", "rejected", "the model lacks flow_saturation",
                           "could not show: load_mass", "diagnose: effects"}) {
    EXPECT_NE(text.find(part), std::string::npos) << part << "\n" << text;
  }
}

TEST_F(ScaledReport, ConsoleTellsWhatIsLeftAndWhatIsAlike) {
  ScaledDiagnosis d = saturated();
  d.judgement.verdict = Verdict::kUnknown;
  d.judgement.left[0] = {0.12, 0.006, 0.14};
  d.judgement.alternatives = {{id_of("flow_saturation"), id_of("valve_asymmetry")}};
  const std::string text = scaled_console(result(d));
  EXPECT_NE(text.find("0.12 rms are left, where the sensor's noise explains 0.006"), std::string::npos) << text;
  EXPECT_NE(text.find("does not tell flow_saturation from valve_asymmetry"), std::string::npos) << text;
}

TEST_F(ScaledReport, PageShowsThePicturesItNames) {
  const ScaledDiagnosis d = saturated();
  const auto page = write_scaled_page(path_, result(d), outcome(result(d)));
  ASSERT_TRUE(page.ok()) << page.error().message;
  std::ostringstream html;
  html << std::ifstream(page.value()).rdbuf();
  for (const char* name : {"pictures/position.svg", "pictures/round_1.svg"}) {
    EXPECT_NE(html.str().find(name), std::string::npos) << name;
    std::ostringstream picture;
    picture << std::ifstream(path_ + "/" + name).rdbuf();
    EXPECT_NE(picture.str().find("</svg>"), std::string::npos) << name;
  }
  EXPECT_NE(html.str().find("85.3 %"), std::string::npos);
  EXPECT_EQ(html.str().find("http"), std::string::npos);
}

TEST_F(ScaledReport, PageOfBadDataHasItsFindings) {
  const auto page = write_scaled_page(path_, bad(), outcome(bad()));
  ASSERT_TRUE(page.ok()) << page.error().message;
  std::ostringstream html;
  html << std::ifstream(page.value()).rdbuf();
  EXPECT_NE(html.str().find("row 17: samples are missing"), std::string::npos);
}

}  // namespace scaled_test
}  // namespace farrier::report
