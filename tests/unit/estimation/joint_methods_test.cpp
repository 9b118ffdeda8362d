// Every method behind every gate, as a joint's estimator: what all of them owe.

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <tuple>

#include "joint.hpp"
#include "tests/support/allocation_guard.hpp"

namespace farrier::estimation {
namespace joint_methods_test {

using namespace testing;

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// Every regression.
std::vector<EstimationMethod> every_method() {
  std::vector<EstimationMethod> methods;
  for (const auto& option : kEstimationMethods) {
    EstimatorParams params;
    params.method = option.value;
    if (params.regresses()) {
      methods.push_back(option.value);
    }
  }
  return methods;
}

const char* name(EstimationMethod method) { return farrier::name_of(kEstimationMethods, method); }

constexpr const char* kGateNames[] = {"none", "pe", "fft"};

using Choice = std::tuple<EstimationMethod, GateKind>;

std::string name_of(const ::testing::TestParamInfo<Choice>& info) {
  return std::string(name(std::get<0>(info.param))) + "_" + kGateNames[static_cast<int>(std::get<1>(info.param))];
}

class EveryMethod : public ::testing::TestWithParam<Choice> {
 protected:
  static EstimatorParams params() {
    EstimatorParams params;
    params.position = false;
    std::tie(params.method, params.gate) = GetParam();
    return params;
  }
};

void expect_same_model(const ModelEstimate& a, const ModelEstimate& b) {
  EXPECT_EQ(a.a, b.a);
  EXPECT_EQ(a.b, b.b);
  EXPECT_EQ(a.c, b.c);
  EXPECT_EQ(a.samples, b.samples);
}

// Sensors are exact and the joint is linear, so the start is the only error. Its share of the information is
// 1 / P_0 = 1e-5 against 3000 samples of (2e-3)^2 in the input. Samples inform less where the regressor's columns are
// alike.
TEST_P(EveryMethod, FindsALinearJointThatIsDithered) {
  JointEstimator estimates = estimator(params());
  const LinearModel truth = linear_joint(kStanceMass_kg);
  Joint joint(truth);
  feed(estimates, joint, 3000);
  const ModelEstimate estimate = estimates.estimate();
  constexpr double kFound = 0.02;  // of entries up to 1.5; the prior is off by 0.3
  EXPECT_LT(error(estimate, truth), kFound);
  EXPECT_GT(error(ModelEstimate{linear_joint(kSwingMass_kg).a, linear_joint(kSwingMass_kg).b}, truth), 10.0 * kFound);
  EXPECT_GT(estimate.validity, 0.9);
  EXPECT_FALSE(has(estimate, EstimateFlag::kNotExciting));
  EXPECT_TRUE((estimate.a_error.array() >= 0.0).all() && estimate.a_error.allFinite());
}

TEST_P(EveryMethod, LeavesOutASampleThatIsNotFiniteOrOutOfRangeAndSaysSo) {
  for (const double bad : {kNaN, kInfinity, 1e308}) {
    for (int field = 0; field < 4; ++field) {
      JointEstimator estimates = estimator(params());
      Joint joint(linear_joint(kStanceMass_kg));
      feed(estimates, joint, 500);
      const ModelEstimate before = estimates.estimate();
      ASSERT_GT(before.samples, 0u);
      JointSample sample = joint.next();
      (field < 3 ? sample.state(field) : sample.current_A) = bad;
      estimates.take(sample);
      EXPECT_TRUE(has(estimates.estimate(), EstimateFlag::kSampleRefused));
      expect_same_model(estimates.estimate(), before);
    }
  }
}

TEST_P(EveryMethod, DoesNotAllocateOnceItIsMade) {
  JointEstimator estimates = estimator(params(), scales(kHyqNoise));
  Joint joint(linear_joint(kStanceMass_kg));
  joint.measured_with(kHyqNoise);
  std::vector<JointSample> samples;
  for (int k = 0; k < 1500; ++k) {
    samples.push_back(joint.next(k / 300 % 2));
  }
  samples[700].state(1) = kNaN;
  double sum = 0.0;
  const test::AllocationGuard guard;
  for (const JointSample& sample : samples) {
    estimates.take(sample);
    sum += estimates.estimate().a(1, 1) + estimates.forgetting(sample.phase)(2);
  }
  EXPECT_EQ(guard.allocations(), 0u);
  EXPECT_TRUE(std::isfinite(sum));
}

TEST_P(EveryMethod, StaysFiniteWhateverItIsGiven) {
  JointEstimator estimates = estimator(params(), scales(kHyqNoise));
  Tick tick = 0;
  for (int k = 0; k < 10'000; ++k) {
    JointSample sample;
    tick += k % 997 == 0 ? 1 + k % 7 : 1;
    sample.tick = tick;
    const double size = std::pow(10.0, k / 100 % 61 - 30);
    sample.state = size * normal<3>(9, "state", k);
    sample.current_A = k % 13 == 0 ? 0.0 : size * normal<1>(9, "current", k)(0);
    sample.phase = k / 900 % 2;
    if (k % 211 == 0) {
      sample.state(k % 3) = k % 2 == 0 ? kNaN : 1e308;
    }
    estimates.take(sample);
    const ModelEstimate estimate = estimates.estimate();
    ASSERT_TRUE(estimate.a.allFinite() && estimate.b.allFinite() && estimate.c.allFinite()) << k;
    ASSERT_TRUE(estimate.a_error.allFinite() && estimate.b_error.allFinite()) << k;
    ASSERT_TRUE(estimate.validity >= 0.0 && estimate.validity <= 1.0) << k;
    ASSERT_TRUE(estimate.excitation >= 0.0 && std::isfinite(estimate.excitation)) << k;
  }
}

INSTANTIATE_TEST_SUITE_P(All, EveryMethod,
                         ::testing::Combine(::testing::ValuesIn(every_method()),
                                            ::testing::Values(GateKind::kNone, GateKind::kPe, GateKind::kFft)),
                         name_of);

// A joint at rest with exact sensors: nothing can be learnt, and the gate sees it.
TEST(Gate, LeavesOutWhatDoesNotExciteAndSaysSo) {
  for (const EstimationMethod method : every_method()) {
    for (const GateKind gate : {GateKind::kPe, GateKind::kFft}) {
      EstimatorParams params;
      params.position = false;
      params.method = method;
      params.gate = gate;
      JointEstimator estimates = estimator(params);
      Joint joint(linear_joint(kStanceMass_kg));
      feed(estimates, joint, 1000);
      EXPECT_FALSE(has(estimates.estimate(), EstimateFlag::kNotExciting));
      joint.dithered_with(0.0);
      feed(estimates, joint, 400);  // the window empties, the washout settles
      ASSERT_TRUE(has(estimates.estimate(), EstimateFlag::kNotExciting)) << name(method);
      const ModelEstimate before = estimates.estimate();
      feed(estimates, joint, 1000);
      EXPECT_TRUE(has(estimates.estimate(), EstimateFlag::kNotExciting));
      expect_same_model(estimates.estimate(), before);
      joint.dithered_with(kDither_A);
      feed(estimates, joint, 400);
      EXPECT_FALSE(has(estimates.estimate(), EstimateFlag::kNotExciting));
      EXPECT_GT(estimates.estimate().samples, before.samples);
    }
  }
}

TEST(EstimateFlag, SaysThatACovarianceIsAtItsBound) {
  for (const EstimationMethod method :
       {EstimationMethod::kRls, EstimationMethod::kAff, EstimationMethod::kKalman, EstimationMethod::kIv}) {
    EstimatorParams params;
    params.position = false;
    params.method = method;
    params.forgetting_factor = 0.9;
    params.kalman = RandomWalkParams{.parameter_drift = 1e4};
    JointEstimator estimates = estimator(params);
    Joint joint(linear_joint(kStanceMass_kg));
    joint.dithered_with(0.0);
    int limited = 0;
    for (int k = 0; k < 2000; ++k) {
      JointSample sample = joint.next();
      sample.state(2) += k % 2 == 0 ? 500.0 : -500.0;  // an error the model cannot explain, in one direction
      estimates.take(sample);
      limited += has(estimates.estimate(), EstimateFlag::kForgettingAtLimit) ? 1 : 0;
    }
    EXPECT_GT(limited, 500) << name(method);
  }
}

TEST(EstimateFlag, SaysWhichInstrumentWasRefused) {
  EstimatorParams params;
  params.position = false;
  params.method = EstimationMethod::kIv;
  params.operating_point_order = 0;
  JointEstimator estimates = estimator(params);
  Joint joint(linear_joint(kStanceMass_kg));
  int refused = 0;
  for (int k = 0; k < 500; ++k) {
    JointSample sample = joint.next();
    sample.state *= k > 300 ? -1.0 : 1.0;  // what is measured is the opposite of what the model says
    estimates.take(sample);
    refused += has(estimates.estimate(), EstimateFlag::kInstrumentRefused) ? 1 : 0;
  }
  EXPECT_GT(refused, 0);
}

// Where sensors are noisy and the state filter does not know by how much, least squares takes some of the pole away;
// instruments need not know.
TEST(InstrumentalVariable, IsLessBiasedThanLeastSquaresWhereTheNoiseIsNotKnown) {
  const LinearModel truth = linear_joint(kStanceMass_kg);
  const auto bias = [&](EstimationMethod method) {
    EstimatorParams params;
    params.position = false;
    params.method = method;
    params.forgetting_factor = 0.9999;
    JointEstimator estimates = estimator(params, scales(kNoNoise));
    Joint joint(truth);
    joint.measured_with(5.0 * kHyqNoise).dithered_with(10.0 * kDither_A);
    feed(estimates, joint, 20'000);
    return error(estimates.estimate(), truth);
  };
  const double least_squares = bias(EstimationMethod::kRls);
  const double instruments = bias(EstimationMethod::kIv);
  EXPECT_LT(instruments, 0.5 * least_squares) << instruments << " against " << least_squares;
}

// Hubacher (2014), 9.1.1: forgetting follows the error. Sensors are HyQ's, the valve is driven by 2 % of its opening.
TEST(AdaptiveForgettingOfAJoint, ForgetsWhenTheLoadChangesAndRemembersAgain) {
  constexpr double kDrive_A = 2e-4;
  constexpr int kWindow = 20;  // ticks over which a factor is averaged: noise alone moves it by some hundredths
  for (std::uint64_t seed = 1; seed <= 8; ++seed) {
    EstimatorParams params;
    params.method = EstimationMethod::kAff;
    JointEstimator estimates = estimator(params, scales(kHyqNoise));
    Joint joint(linear_joint(kSwingMass_kg), seed);
    joint.measured_with(kHyqNoise).dithered_with(kDrive_A);
    feed(estimates, joint, 2000);
    joint.becomes(linear_joint(kStanceMass_kg));
    int fell = 0;
    int back = 0;
    double sum = 0.0;
    for (int tick = 1; tick <= 400 && back == 0; ++tick) {
      estimates.take(joint.next());
      const double least = estimates.forgetting(0).minCoeff();
      fell = fell == 0 && least < 0.97 ? tick : fell;
      sum += least;
      if (tick % kWindow == 0) {
        back = fell > 0 && sum / kWindow > 0.99 ? tick : 0;
        sum = 0.0;
      }
    }
    EXPECT_GT(fell, 0) << seed;
    EXPECT_LE(fell, 20) << seed;
    EXPECT_GT(back, fell) << seed;
    EXPECT_LE(back, 200) << seed;
    RecordProperty("fell_" + std::to_string(seed), fell);
    RecordProperty("back_" + std::to_string(seed), back);
  }
}

}  // namespace joint_methods_test
}  // namespace farrier::estimation
