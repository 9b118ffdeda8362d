// The three tests every step has: no allocation, input that is not finite, bounded output.

#include <bit>
#include <cmath>
#include <limits>
#include <random>

#include "tests/support/allocation_guard.hpp"
#include "tests/unit/joint_node/bench.hpp"
#include "wire_gains/wire_gains.hpp"

namespace farrier::joint_node {
namespace standing_test {

using namespace testing;
using signals::JointState;
using signals::Phase;

void expect_bounded(const JointNode::Outputs& outputs, const robot::Joint& joint) {
  // Written so that a NaN fails.
  ASSERT_TRUE(std::abs(outputs.valve.valve_current_A) <= joint.actuator.valve_current_max_A)
      << outputs.valve.valve_current_A;
  ASSERT_TRUE(outputs.valve.force_reference_N_or_Nm <= joint.push_limit &&
              outputs.valve.force_reference_N_or_Nm >= -joint.pull_limit)
      << outputs.valve.force_reference_N_or_Nm;
}

/// Doubles of every size, with the odd one that is not a number.
class Numbers {
 public:
  explicit Numbers(std::uint64_t seed) : random_(seed) {}

  double any() {
    const double value = std::bit_cast<double>(random_());
    return random_() % 4 == 0 ? kExtremes[random_() % std::size(kExtremes)] : value;
  }
  double moderate(double size) { return std::uniform_real_distribution<double>(-size, size)(random_); }
  bool one_in(std::uint64_t n) { return random_() % n == 0; }

 private:
  using Limits = std::numeric_limits<double>;
  static constexpr double kExtremes[] = {Limits::quiet_NaN(),
                                         Limits::infinity(),
                                         -Limits::infinity(),
                                         Limits::max(),
                                         Limits::lowest(),
                                         Limits::denorm_min(),
                                         0.0,
                                         -0.0};
  std::mt19937_64 random_;
};

void shake(JointNode::Inputs& inputs, Numbers& numbers, bool extreme) {
  const auto draw = [&](double size) { return extreme ? numbers.any() : numbers.moderate(size); };
  inputs.sensors.position_m_or_rad = draw(0.2);
  inputs.sensors.velocity_m_s_or_rad_s = draw(5);
  inputs.sensors.force_N_or_Nm = draw(1e4);
  inputs.command.position_rad = draw(4);
  inputs.command.velocity_rad_s = draw(50);
  inputs.command.torque_ff_Nm = draw(500);
  inputs.command.stiffness_Nm_rad = std::abs(draw(1e3));
  inputs.command.damping_Nms_rad = std::abs(draw(50));
}

TEST(JointNode, StepDoesNotAllocate) {
  Bench bench = Bench::tracking();
  const auto update = gains_of(bench.joint, Phase::kStance, 3, 30);
  const control::Gains gains = wire_gains::unpack_gains(update);
  Numbers numbers(1);
  const test::AllocationGuard guard;
  bench.node.store_gains(update, gains);
  bench.announce(Phase::kSwing, 1, 20);
  for (int i = 0; i < 200; ++i) {
    shake(bench.inputs, numbers, i % 3 == 0);
    bench.inputs.command_age_s = i % 10 < 7 ? 0 : 0.01;
    bench.inputs.sensors_age_s = i % 50 < 45 ? 0 : 0.01;
    bench.step();
  }
  EXPECT_EQ(guard.allocations(), 0u);
}

TEST(JointNode, StaysBoundedWhenInputIsNotFinite) {
  for (const char* name : {"lf_kfe", "rh_hfe", "lf_haa"}) {
    Bench bench = Bench::tracking(name);
    Numbers numbers(2);
    for (int i = 0; i < 20'000; ++i) {
      shake(bench.inputs, numbers, true);
      // Finite sensors let the commands through.
      if (numbers.one_in(2)) {
        bench.inputs.sensors.position_m_or_rad = 0.5 * bench.joint.actuator.stroke;
        bench.inputs.sensors.velocity_m_s_or_rad_s = numbers.moderate(1);
        bench.inputs.sensors.force_N_or_Nm = numbers.moderate(1e3);
      }
      bench.inputs.sensors_age_s = numbers.one_in(20) ? numbers.any() : 0.0;
      bench.inputs.command_age_s = numbers.one_in(20) ? 0.01 : 0.0;
      expect_bounded(bench.step(), bench.joint);
    }
  }
}

TEST(JointNode, StaysBoundedWhenFiniteInputOverflows) {
  Bench bench = Bench::tracking();
  Numbers numbers(3);
  int tracked = 0;
  for (int i = 0; i < 20'000; ++i) {
    shake(bench.inputs, numbers, true);
    bench.inputs.sensors.position_m_or_rad = 0.5 * bench.joint.actuator.stroke;  // one it can have
    bench.inputs.sensors.force_N_or_Nm = bench.joint.push_limit;
    for (double* value : {&bench.inputs.sensors.velocity_m_s_or_rad_s, &bench.inputs.command.position_rad,
                          &bench.inputs.command.velocity_rad_s, &bench.inputs.command.torque_ff_Nm,
                          &bench.inputs.command.stiffness_Nm_rad, &bench.inputs.command.damping_Nms_rad}) {
      *value = std::isfinite(*value) ? *value : 1e308;
    }
    const auto outputs = bench.step();
    expect_bounded(outputs, bench.joint);
    tracked += outputs.valve.state == JointState::kTracking ? 1 : 0;
  }
  EXPECT_GT(tracked, 1000);
}

TEST(JointNode, TracksAgainAfterTheWorstOfInput) {
  Bench bench = Bench::tracking();
  const JointNode::Inputs calm = bench.inputs;
  Numbers numbers(4);
  for (int i = 0; i < 1000; ++i) {
    shake(bench.inputs, numbers, true);
    bench.step();
  }
  bench.inputs = calm;
  for (int good = 0; good < hyq().safety.recovery_samples; ++good) {
    bench.step();
  }
  EXPECT_EQ(bench.state(), JointState::kTracking);
}

TEST(JointNode, StaysBoundedUnderRandomInput) {
  for (const robot::Joint& joint : hyq().joints) {
    Bench bench = Bench::tracking(joint.name);
    Numbers numbers(joint.number);
    for (int i = 0; i < 2000; ++i) {
      shake(bench.inputs, numbers, false);
      expect_bounded(bench.step(), joint);
    }
  }
}

}  // namespace standing_test
}  // namespace farrier::joint_node
