// Evidence for faults of wiring, on recordings of the generator.

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <string>
#include <utility>

#include "diagnosis/wiring/wiring_evidence.hpp"
#include "trials/truth/electric_truth.hpp"
#include "trials/wiring/wiring_trials.hpp"

namespace farrier::diagnosis {
namespace wiring_evidence_test {

double rms(const std::vector<double>& values) {
  double sum = 0.0;
  for (const double value : values) sum += value * value;
  return std::sqrt(sum / static_cast<double>(values.size()));
}

/// Difference of both sides over the left one.
double apart(const LawOverTime& sides) {
  std::vector<double> difference;
  for (std::size_t i = 0; i < sides.left.size(); ++i) difference.push_back(sides.left[i] - sides.right[i]);
  return rms(difference) / rms(sides.left);
}

/// A joint of a robot under sines of its command.
class WiringEvidenceOf : public testing::TestWithParam<std::pair<const char*, const char*>> {
 protected:
  WiringEvidenceOf() : robot_(robot::load_robot(std::string(FARRIER_ROBOTS) + GetParam().first + ".yaml").value()) {}

  const robot::Joint& joint() const { return *robot_.find(GetParam().second); }

  Recording recorded() const {
    const truth::Plan plan{1, truth::Excitation::kMultisine, {}, 2.0};
    const truth::Trial trial = joint().electric ? truth::generate_electric(joint(), 1e-3, plan).value()
                                                : truth::generate(joint(), 1e-3, plan).value();
    Recording recording = wiring::recording_of(trial.samples, joint());
    recording.pressure_a_Pa = recording.pressure_b_Pa = {};
    return recording;
  }

  /// Evidence for the fault that is found in a recording.
  std::optional<WiringEvidence> evidence_of(const Recording& recording, WiringKind kind) const {
    const auto answers = find_wiring(recording, joint());
    if (answers.empty() || answers.front().fault.kind != kind) {
      ADD_FAILURE() << "the fault is not found";
      return std::nullopt;
    }
    return wiring_evidence(recording, joint(), answers.front().fault);
  }

 private:
  robot::Robot robot_;
};

TEST_P(WiringEvidenceOf, AReversedForceIsTheMirrorImageOfItsLaw) {
  Recording wrong = recorded();
  for (double& force : wrong.force) force = -force;
  const auto evidence = evidence_of(wrong, WiringKind::kReversed);
  ASSERT_TRUE(evidence);
  EXPECT_GT(apart(evidence->recorded), 1.5);
  EXPECT_LT(apart(evidence->mended), 0.2);
}

TEST_P(WiringEvidenceOf, ALateForceMeetsItsLawOnceItIsMoved) {
  Recording wrong = recorded();
  wrong.force.insert(wrong.force.begin(), 20, wrong.force.front());
  wrong.force.resize(wrong.position.size());
  const auto evidence = evidence_of(wrong, WiringKind::kLate);
  ASSERT_TRUE(evidence);
  EXPECT_LT(apart(evidence->mended), 0.25 * apart(evidence->recorded));
}

TEST_P(WiringEvidenceOf, ExchangedColumnsMeetTheirLawOnceTheyAreExchangedBack) {
  Recording wrong = recorded();
  std::swap(wrong.force, wrong.velocity);
  const auto evidence = evidence_of(wrong, WiringKind::kExchanged);
  ASSERT_TRUE(evidence);
  EXPECT_LT(apart(evidence->mended), 0.2);
  EXPECT_GT(apart(evidence->recorded), 0.5);
}

TEST_P(WiringEvidenceOf, ADeadVelocityStandsBesideAPositionThatMoves) {
  Recording wrong = recorded();
  for (double& velocity : wrong.velocity) velocity = 1e-3;
  const auto evidence = evidence_of(wrong, WiringKind::kDead);
  ASSERT_TRUE(evidence);
  EXPECT_EQ(evidence->law, WiringLaw::kKinematics);
  EXPECT_TRUE(evidence->mended.time_s.empty());
  EXPECT_NEAR(rms(evidence->recorded.left), 1e-3, 1e-9);
  EXPECT_GT(rms(evidence->recorded.right), 10.0 * 1e-3);
}

TEST_P(WiringEvidenceOf, ASupplyOfAnotherUnitHasNone) {
  const WiringFault fault{.kind = WiringKind::kScaled, .channel = WiredChannel::kSupply, .amount = 1e-5};
  EXPECT_FALSE(wiring_evidence(recorded(), joint(), fault));
}

INSTANTIATE_TEST_SUITE_P(Joints, WiringEvidenceOf,
                         testing::Values(std::pair{"electric_leg", "haa"}, std::pair{"go1", "lf_haa"},
                                         std::pair{"fc1d", "fc1d"}),
                         [](const auto& of) { return std::string(of.param.first); });

}  // namespace wiring_evidence_test
}  // namespace farrier::diagnosis
