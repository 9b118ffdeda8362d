// The grey-box estimator's model against the plant's, and what it does with nonsense.

#include <gtest/gtest.h>

#include <limits>
#include <string>

#include "grey_box.hpp"
#include "tests/support/allocation_guard.hpp"

namespace farrier::estimation {
namespace grey_box_safety_test {

using namespace testing;

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
constexpr double kInfinity = std::numeric_limits<double>::infinity();

GreyBoxModel model() { return {plant::nominal_cylinder(), kHomePosition, 0.005}; }

Unknowns some_unknowns() {
  plant::JointPhysics physics = plant::nominal_physics(plant::nominal_cylinder(), cart(7.0));
  physics.coulomb = 30.0;
  physics.bias_force = -50.0;
  physics.leakage = 1e-13;
  return model().unknowns_of(physics);
}

TEST(GreyBoxModel, HasThePlantsRightHandSide) {
  const plant::JointEquations equations(plant::nominal_cylinder(), cart(7.0));
  const plant::JointPhysics physics = plant::nominal_physics(plant::nominal_cylinder(), cart(7.0));
  for (const Motion& at : {Motion(0.03, 0.2, 9e6, 12e6), Motion(0.05, -0.4, -2e5, 24e6), Motion(0.0801, 0.3, 3e6, -1e5),
                           Motion(-0.0001, -0.3, 3e6, 2e6)}) {
    for (const double current : {-0.004, 0.0, 0.01}) {
      const plant::IntegrationState expected =
          equations.derivative({at(0), at(1), at(2), at(3)}, equations.hold(current, 0.0));
      const Motion rate = model().rate(at, physics, current).value;
      // Both sum the same terms in another order.
      EXPECT_DOUBLE_EQ(rate(0), expected.position);
      EXPECT_NEAR(rate(1), expected.velocity, 1e-9 * std::abs(expected.velocity) + 1e-9);
      EXPECT_NEAR(rate(2), expected.compression_a_Pa, 1e-9 * std::abs(expected.compression_a_Pa) + 1e-3);
      EXPECT_NEAR(rate(3), expected.compression_b_Pa, 1e-9 * std::abs(expected.compression_b_Pa) + 1e-3);
    }
  }
}

TEST(GreyBoxModel, KnowsHowATicksEndDependsOnItsBeginningAndTheUnknowns) {
  // Central differences of both: their own error is of the order of the step squared.
  const Motion from(0.045, 0.1, 9e6, 12e6);
  const Unknowns unknowns = some_unknowns();
  Gradient step;
  step << 1e-7, 1e-5, 1e2, 1e2, 1e-4, 1e-4, 1e-2, 1.0, 1e-2, 1e-4, 1e-4, 1e-17;
  const GreyBoxModel::Passage passage = model().pass(from, unknowns, 0.003, 1e-3);
  const GreyBoxModel::Force force = model().load_cell_force(from, unknowns);
  const Motion size(1e-4, 1e-1, 1e6, 1e6);  // of what a tick does
  for (int i = 0; i < kGreyBoxStates; ++i) {
    Motion low = from, high = from;
    Unknowns less = unknowns, more = unknowns;
    (i < kMotions ? low(i) : less(i - kMotions)) -= step(i);
    (i < kMotions ? high(i) : more(i - kMotions)) += step(i);
    const Motion change =
        (model().pass(high, more, 0.003, 1e-3).motion - model().pass(low, less, 0.003, 1e-3).motion) / (2.0 * step(i));
    for (int j = 0; j < kMotions; ++j) {
      EXPECT_NEAR(passage.by(i, j), change(j), 1e-4 * std::abs(change(j)) + 1e-8 * size(j) / step(i)) << i << " " << j;
    }
    const double force_change =
        (model().load_cell_force(high, more).value - model().load_cell_force(low, less).value) / (2.0 * step(i));
    EXPECT_NEAR(force.by(i), force_change, 1e-4 * std::abs(force_change) + 1e-8 / step(i)) << i;
  }
}

TEST(GreyBox, RefusesSettingsOutOfRangeByName) {
  const auto refusal = [](const EstimatorParams& params, const JointScales& scales, const plant::LoadParams& load) {
    const auto made = GreyBoxEstimator::create(params, scales, plant::nominal_cylinder(), {load, load});
    return made ? std::string() : made.error().message;
  };
  const JointScales scales = rig_scales(kRigNoise);
  EXPECT_EQ(refusal({}, scales, cart(1.0)), "");
  EstimatorParams params;
  params.grey_box = GreyBoxParams{.mass_uncertainty = -1.0, .flow_error = kNaN};
  EXPECT_NE(refusal(params, scales, cart(1.0)).find("mass_uncertainty"), std::string::npos);
  EXPECT_NE(refusal(params, scales, cart(1.0)).find("flow_error"), std::string::npos);
  params = {};
  params.gate = GateKind::kPe;
  EXPECT_NE(refusal(params, scales, cart(1.0)).find("gate: none"), std::string::npos);
  EXPECT_NE(refusal({}, scales, cart(0.0)).find("mass above 0"), std::string::npos);
  JointScales still = scales;
  still.period_s = 0.0;
  EXPECT_NE(refusal({}, still, cart(1.0)).find("period"), std::string::npos);
}

TEST(GreyBox, LeavesItsEstimateAloneForSamplesThatAreNotFinite) {
  for (const double nonsense : {kNaN, kInfinity, -kInfinity, 1e300}) {
    for (int place = 0; place < 5; ++place) {
      Rig rig(plant::nominal_cylinder(), cart(20.0), kRigNoise);
      GreyBoxEstimator estimator = grey_box(kRigNoise);
      for (Tick k = 0; k < 60; ++k) {
        estimator.take(rig.next(Rig::rich(1, k, 5e-4)));
      }
      const ModelEstimate before = estimator.estimate();
      JointSample sample = rig.next(0.0);
      if (place < 3) {
        sample.state(place) = nonsense;
      } else if (place == 3) {
        sample.current_A = nonsense;
      } else {
        sample.phase = 2;
      }
      estimator.take(sample);
      const ModelEstimate after = estimator.estimate();
      EXPECT_TRUE(has_flag(after, EstimateFlag::kSampleRefused));
      EXPECT_EQ(after.a, before.a);
      EXPECT_EQ(after.b, before.b);
      EXPECT_EQ(plant::values_of(after.physics), plant::values_of(before.physics));
      EXPECT_EQ(plant::values_of(after.physics_error), plant::values_of(before.physics_error));
      estimator.take(rig.next(0.0));
      EXPECT_FALSE(has_flag(estimator.estimate(), EstimateFlag::kSampleRefused));
    }
  }
}

TEST(GreyBox, StaysFiniteWhateverFiniteSamplesSay) {
  GreyBoxEstimator estimator = grey_box(kRigNoise);
  const NoiseStream wild(1, "wild", "");
  for (Tick k = 0; k < 3000; ++k) {
    const double size = std::pow(10.0, 12.0 * wild.uniform(5 * k) - 4.0);
    JointSample sample{.tick = k, .state = {}, .current_A = size * wild.normal(5 * k + 1), .phase = 0};
    sample.state << size * wild.normal(5 * k + 2), size * wild.normal(5 * k + 3), size * wild.normal(5 * k + 4);
    estimator.take(sample);
  }
  const ModelEstimate estimate = estimator.estimate();
  EXPECT_TRUE(estimate.a.allFinite() && estimate.b.allFinite());
  for (const double value : plant::values_of(estimate.physics)) {
    EXPECT_TRUE(std::isfinite(value));
  }
  EXPECT_GE(estimate.validity, 0.0);
  EXPECT_LE(estimate.validity, 1.0);
}

TEST(GreyBox, AllocatesNothing) {
  Rig rig(plant::nominal_cylinder(), cart(20.0), kRigNoise);
  GreyBoxEstimator estimator = grey_box(kRigNoise);
  std::size_t allocations = 0;
  for (Tick k = 0; k < 300; ++k) {
    if (k == 150) {
      rig.becomes(cart(2.0));
    }
    const JointSample sample = rig.next(Rig::rich(1, k, 5e-4), k > 250 ? 1 : 0);
    const test::AllocationGuard guard;
    estimator.take(sample);
    (void)estimator.estimate();
    allocations += guard.allocations();
  }
  EXPECT_EQ(allocations, 0u);
}

}  // namespace grey_box_safety_test
}  // namespace farrier::estimation
