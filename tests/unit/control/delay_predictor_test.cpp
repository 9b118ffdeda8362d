// Prediction over a delay, on the model it predicts with.

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <vector>

#include "control/law/delay_predictor.hpp"
#include "tests/support/allocation_guard.hpp"
#include "tests/unit/control/models.hpp"

namespace farrier::control {
namespace delay_predictor_test {

using testing::kPeriodS;

DiscreteModel rig_model() {
  const testing::ContinuousModel model = testing::force_model(testing::fc1d(50.0));
  return discretise(model.a, model.b, kPeriodS);
}

/// A joint that is its model, whose currents act `ticks` after they are sent, with a change of force that no current
/// makes.
class Delayed {
 public:
  Delayed(const DiscreteModel& model, std::size_t ticks, double leak_N)
      : model_(model), ticks_(ticks), leak_N_(leak_N) {}

  Measurement now() const { return {x_[0], x_[1], x_[2]}; }
  void send(double current_A) {
    sent_A_.push_back(current_A);
    const double acting_A = sent_A_.size() > ticks_ ? sent_A_[sent_A_.size() - 1 - ticks_] : 0.0;
    x_ = model_.a * x_ + model_.b * acting_A;
    x_[2] += leak_N_;
  }

 private:
  DiscreteModel model_;
  std::size_t ticks_;
  double leak_N_;
  Eigen::Vector3d x_ = Eigen::Vector3d::Zero();
  std::vector<double> sent_A_;
};

double current_A(int k) { return 1e-3 * std::sin(0.07 * k) + 5e-4 * std::sin(0.31 * k); }

/// Largest error of the predicted force over ticks [from, 600), over the largest force.
double worst_error(const DiscreteModel& model, std::size_t extra, int loop, double leak_N, int from) {
  Delayed joint(model, extra + static_cast<std::size_t>(loop), leak_N);
  DelayPredictor predictor(static_cast<double>(extra) * kPeriodS, kPeriodS, loop);
  std::vector<double> predicted, measured;
  for (int k = 0; k < 600; ++k) {
    measured.push_back(joint.now().force);
    predicted.push_back(predictor.predict(model, joint.now()).force);
    predictor.sent(current_A(k));
    joint.send(current_A(k));
  }
  double worst = 0.0;
  double largest = 0.0;
  for (std::size_t k = static_cast<std::size_t>(from); k + extra < measured.size(); ++k) {
    worst = std::max(worst, std::abs(predicted[k] - measured[k + extra]));
    largest = std::max(largest, std::abs(measured[k]));
  }
  return worst / largest;
}

TEST(DelayPredictor, KnowsWhatTheJointWillMeasure) {
  for (const std::size_t extra : {1u, 3u, 7u, 20u}) {
    for (const int loop : {0, 1, 2}) {
      EXPECT_LT(worst_error(rig_model(), extra, loop, 0.0, 0), 1e-9) << extra << " ticks beside " << loop;
    }
  }
}

TEST(DelayPredictor, LearnsWhatTheJointDoesBesideItsModel) {
  for (const std::size_t extra : {1u, 3u, 7u}) {
    EXPECT_LT(worst_error(rig_model(), extra, 0, 2.0, 300), 0.01) << extra;
  }
}

TEST(DelayPredictor, MixesTheCurrentsOfADelayThatIsNoWholeTick) {
  const DiscreteModel model = rig_model();
  DelayPredictor predictor(2.25 * kPeriodS, kPeriodS, 0);
  for (const double sent_A : {1e-3, 2e-3, 4e-3}) {  // newest last
    predictor.sent(sent_A);
  }
  const Eigen::Vector3d first = model.b * (0.75 * 2e-3 + 0.25 * 1e-3);
  const Eigen::Vector3d second = model.a * first + model.b * (0.75 * 4e-3 + 0.25 * 2e-3);
  const Eigen::Vector3d third = 0.75 * second + 0.25 * (model.a * second + model.b * 4e-3);
  const Measurement ahead = predictor.predict(model, {0.0, 0.0, 0.0});
  EXPECT_NEAR(ahead.force, third[2], 1e-9 * std::abs(third[2]));
  EXPECT_NEAR(ahead.velocity, third[1], 1e-9 * std::abs(third[1]));
}

TEST(DelayPredictor, ExpectsTheReferenceToGoOnAsItDid) {
  DelayPredictor predictor(3.0 * kPeriodS, kPeriodS, 0);
  EXPECT_EQ(predictor.predict(100.0), 100.0);
  double ahead = 0.0;
  for (int k = 1; k < 60; ++k) {
    ahead = predictor.predict(100.0 + 2.0 * k);
  }
  EXPECT_NEAR(ahead, 100.0 + 2.0 * (59 + 3), 1e-6);
}

TEST(DelayPredictor, WithoutDelayGivesBackWhatItGets) {
  DelayPredictor predictor(0.0, kPeriodS, 1);
  EXPECT_FALSE(predictor.active());
  for (int k = 0; k < 5; ++k) {
    const Measurement same = predictor.predict(rig_model(), {0.1 * k, 0.2, 30.0 * k});
    EXPECT_EQ(same.position, 0.1 * k);
    EXPECT_EQ(same.velocity, 0.2);
    EXPECT_EQ(same.force, 30.0 * k);
    EXPECT_EQ(predictor.predict(7.0 * k), 7.0 * k);
    predictor.sent(1e-3);
  }
}

TEST(DelayPredictor, NeitherAllocatesNorKeepsWhatIsNotFinite) {
  const DiscreteModel model = rig_model();
  DelayPredictor predictor(1.0, kPeriodS, 2);  // beyond what it remembers: as long as that
  const test::AllocationGuard guard;
  const double infinite = std::numeric_limits<double>::infinity();
  for (const double wild : {1e308, infinite, std::numeric_limits<double>::quiet_NaN()}) {
    predictor.predict(model, {wild, wild, wild});
    predictor.predict(wild);
    predictor.sent(1e-3);
  }
  predictor.reset();
  for (int k = 0; k < 100; ++k) {
    ASSERT_TRUE(std::isfinite(predictor.predict(model, {0.0, 0.0, 1.0}).force));
    ASSERT_TRUE(std::isfinite(predictor.predict(1.0)));
    predictor.sent(0.0);
  }
  EXPECT_EQ(guard.allocations(), 0u);
}

}  // namespace delay_predictor_test
}  // namespace farrier::control
