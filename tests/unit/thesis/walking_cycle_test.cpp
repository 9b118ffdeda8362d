#include "thesis/rig/walking_cycle.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "plant/nominal.hpp"

namespace farrier::thesis {
namespace walking_cycle_test {

TEST(WalkingCycle, ValveSignalsStayWithinTheirOpening) {
  for (const bool rich : {false, true}) {
    double largest = 0.0;
    for (Tick k = 0; k < 4 * kSectionTicks; ++k) {
      largest = std::max(largest, std::abs(valve_signal(rich, kSmallOpening, 1, k)));
    }
    EXPECT_LE(largest, kSmallOpening * plant::kNominalCurrent_A);
    EXPECT_GT(largest, 0.8 * kSmallOpening * plant::kNominalCurrent_A);
  }
  EXPECT_EQ(valve_signal(true, 1.0, 1, 7), valve_signal(true, 1.0, 1, 7));
  EXPECT_NE(valve_signal(true, 1.0, 1, 7), valve_signal(true, 1.0, 2, 7));
}

TEST(WalkingCycle, TheMassOfAModelIsThatOfItsLoad) {
  for (const plant::LoadParams& load : walking_cycle()) {
    EXPECT_NEAR(load_mass_kg(cycle_model_of(plant::nominal_cylinder(), load).a) / load.mass, 1.0, 1e-6) << load.mass;
  }
  EXPECT_TRUE(std::isinf(load_mass_kg(Eigen::Matrix3d::Constant(std::nan("")))));
}

TEST(WalkingCycle, LoadsFollowOneAnotherAfterASectionEach) {
  const auto& loads = walking_cycle();
  const auto samples = drive(loads, true, kSmallOpening, 1);
  ASSERT_EQ(samples.size(), loads.size() * kSectionTicks);
  const auto first = drive(std::span(loads).first(1), true, kSmallOpening, 1);
  for (std::size_t k = 0; k < first.size(); ++k) {
    ASSERT_EQ(samples[k].state, first[k].state) << k;
  }
  EXPECT_LT(samples.front().state.norm(), 1e-9) << "at rest at home";
}

TEST(WalkingCycle, LeastSquaresFindTheMassOfASmallRichSignal) {
  const plant::LoadParams load = cycle_load(kHeavyLoad_kg);
  const auto samples = drive(std::span(&load, 1), true, kSmallOpening, 1);
  const auto models = identify(samples, 0.85);
  ASSERT_EQ(models.size(), samples.size());
  EXPECT_NEAR(load_mass_kg(models.front().a), kStartLoad_kg, 2.0) << "as it began";
  EXPECT_NEAR(load_mass_kg(models.back().a) / kHeavyLoad_kg, 1.0, 0.1);
}

}  // namespace walking_cycle_test
}  // namespace farrier::thesis
