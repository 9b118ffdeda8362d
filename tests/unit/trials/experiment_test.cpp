// Experiments that a diagnosis proposes for causes it cannot separate, made with a generator that shares no code with it.

#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

#include "diagnosis/judge/diagnosis.hpp"
#include "trials/blind/blind_trials.hpp"
#include "trials/truth/electric_truth.hpp"

namespace farrier::truth {
namespace experiment_test {

constexpr double kPeriod_s = 1e-3;

/// A cause that a recording of a joint leaves tied with others.
struct Tied {
  const char* robot;
  const char* hidden;
  std::vector<const char*> others;
  std::uint64_t seed;
};

class TiedCauses : public testing::TestWithParam<Tied> {
 protected:
  TiedCauses() : robot_(robot::load_robot(std::string(FARRIER_ROBOTS) + GetParam().robot + ".yaml").value()) {}

  const robot::Joint& joint() const { return robot_.joints.front(); }

  diagnosis::Diagnosis diagnosed(double duration_s, const Command& command = {}) const {
    const Plan plan{GetParam().seed, Excitation::kMultisine, {{GetParam().hidden, 0}}, duration_s};
    const Samples samples = generate_electric(joint(), kPeriod_s, plan, command).value().samples;
    return diagnosis::diagnose(blind::recording_of(samples), joint(), {});
  }

  /// The experiment as its text asks for it: a current beside a hold amid the travel.
  Command command_of(const diagnosis::Experiment& experiment) const {
    const plant::ElectricParams& drive = *joint().electric;
    return [=, current_A = diagnosis::experiment_current_A(experiment, kPeriod_s)](double time_s, double position,
                                                                                   double velocity) {
      const auto k = std::lround(time_s / kPeriod_s);
      const double held_Nm =
          experiment.hold.stiffness * (position - 0.5 * drive.travel) + experiment.hold.damping * velocity;
      return (k < 0 ? 0.0 : current_A.at(static_cast<std::size_t>(k))) -
             held_Nm / (drive.gear_ratio * drive.torque_constant_Nm_A);
    };
  }

 private:
  robot::Robot robot_;
};

TEST_P(TiedCauses, AreToldApartByTheExperimentThatIsProposed) {
  const plant::EffectId hidden = plant::find_nameable(GetParam().hidden);
  const diagnosis::Diagnosis first = diagnosed(4.0);
  ASSERT_EQ(first.judgement.verdict, diagnosis::Verdict::kCannotSeparate);
  ASSERT_EQ(first.experiments.size(), GetParam().others.size());
  for (std::size_t i = 0; i < first.experiments.size(); ++i) {
    EXPECT_EQ(first.experiments[i].one, hidden);
    EXPECT_EQ(plant::effect_info(first.experiments[i].other).name, std::string(GetParam().others[i]));
    EXPECT_TRUE(first.experiments[i].tells()) << first.experiments[i].difference;
  }

  const diagnosis::Experiment& experiment = first.experiments.front();
  const diagnosis::Diagnosis second = diagnosed(experiment.duration_s, command_of(experiment));
  EXPECT_EQ(second.judgement.verdict, diagnosis::Verdict::kEffects);
  ASSERT_EQ(second.judgement.effects.size(), 1u);
  EXPECT_EQ(second.judgement.effects.front().id, hidden);
}

INSTANTIATE_TEST_SUITE_P(OfDrives, TiedCauses,
                         testing::Values(Tied{"go1", "torque_constant", {"load_mass"}, 1},
                                         Tied{"electric_leg", "rotor_inertia", {"current_lag", "input_delay"}, 2}),
                         [](const auto& tied) { return tied.param.robot + std::string("_") + tied.param.hidden; });

}  // namespace experiment_test
}  // namespace farrier::truth
