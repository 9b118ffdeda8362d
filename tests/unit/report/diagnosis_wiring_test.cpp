#include "diagnosis.hpp"

#include <filesystem>
#include <fstream>
#include <sstream>

#include "report/diagnosis/diagnosis_page.hpp"

namespace farrier::report {
namespace diagnosis_wiring_test {

/// Page of a reversed force.
class WiringPage : public testing::OwnFolder {
 protected:
  std::string page(std::optional<diagnosis::WiringEvidence> evidence) const {
    diagnosis::Diagnosis d{};
    d.judgement.verdict = diagnosis::Verdict::kWiring;
    DiagnosisResult wrong{.diagnosis = d, .robot = robot_, .joint = robot_.joints[0], .recording = "run.csv"};
    wrong.wiring = {{.fault = {.kind = diagnosis::WiringKind::kReversed}, .columns = "force_N", .confidence = 0.997}};
    wrong.findings = {{"reversed", 0, "force_N is reversed: exchange its wires. Confidence 0.997."}};
    wrong.evidence = std::move(evidence);
    const Outcome outcome{.command = "diagnose", .figures = {}, .run = run_info(robot_, 0), .failures = {}};
    std::ostringstream text;
    text << std::ifstream(write_diagnosis_page(path_, wrong, outcome).value()).rdbuf();
    return text.str();
  }

 private:
  const robot::Robot robot_ = testing::rig();
};

TEST_F(WiringPage, HasTheColumnAndTheRemedyAndSaysWhyThereIsNoPicture) {
  const std::string html = page({});
  EXPECT_NE(html.find("<b>force_N</b></td><td>force_N is reversed: exchange its wires.</td><td>almost certain"),
            std::string::npos);
  EXPECT_NE(html.find("No picture: the level of force_N shows this fault, and no law over time does."),
            std::string::npos);
}

TEST_F(WiringPage, ShowsTheLawThatTheColumnBreaks) {
  diagnosis::LawOverTime sides;
  for (int i = 0; i < 1500; ++i) {
    sides.time_s.push_back(1e-3 * i);
    sides.right.push_back(100.0 * std::sin(0.02 * i));
    sides.left.push_back(-sides.right.back());
  }
  diagnosis::LawOverTime mended = sides;
  mended.left = mended.right;
  const std::string html = page(diagnosis::WiringEvidence{diagnosis::WiringLaw::kLoadByPosition, sides, mended});
  EXPECT_NE(html.find("force as measured, and as the position says by a law of the joint; below with the fault undone"),
            std::string::npos);
  EXPECT_TRUE(std::filesystem::exists(path_ + "/pictures/wiring.svg"));

  const std::string dead = page(diagnosis::WiringEvidence{diagnosis::WiringLaw::kLoadByPosition, sides, {}});
  EXPECT_NE(dead.find("with its numbers as near to the measurement as effects can bring them"), std::string::npos);
}

}  // namespace diagnosis_wiring_test
}  // namespace farrier::report
