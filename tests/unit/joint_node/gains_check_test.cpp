#include <limits>

#include "signals/fields.hpp"
#include "tests/unit/joint_node/bench.hpp"
#include "wire_gains/wire_gains.hpp"

namespace farrier::joint_node {
namespace gains_check_test {

using namespace testing;
using signals::JointControllerGains;
using signals::Phase;

JointControllerGains good() { return gains_of(joint_named("lf_kfe"), Phase::kStance, 1); }

std::string refusal(const JointControllerGains& signal) {
  const auto checked = check_gains(signal, control::Kind::kLqr);
  return checked ? "accepted" : checked.error().message;
}

TEST(CheckGains, AcceptsTheDesignOfEveryJointForBothLoads) {
  for (const robot::Joint& joint : hyq().joints) {
    for (const plant::LoadParams& load : {joint.swing_load, joint.stance_load}) {
      EXPECT_EQ(refusal(wire_gains::pack_gains(joint.number, Phase::kStance, 1, 1, design(joint, load))), "accepted")
          << joint.name;
    }
  }
}

// One number after the other, those in arrays too.
struct Spoil {
  int wanted;
  double value;
  int seen{0};
  std::string spoilt{};

  template <class Field>
  void operator()(const char* name, Field& field) {
    if constexpr (std::is_same_v<Field, double>) {
      if (seen++ == wanted) {
        field = value;
        spoilt = name;
      }
    } else if constexpr (requires { field.size(); }) {
      for (double& element : field) {
        (*this)(name, element);
      }
    }
  }
};

TEST(CheckGains, RefusesEveryNumberThatIsNotFiniteByName) {
  constexpr int kNumbers = 6 + 2 + 4 + 9 + 3 + 9;  // gains, delay, scales, a, b, physics
  using Limits = std::numeric_limits<double>;
  for (const double value : {Limits::quiet_NaN(), Limits::infinity(), -Limits::infinity()}) {
    for (int number = 0; number < kNumbers; ++number) {
      JointControllerGains signal = good();
      Spoil spoil{number, value};
      signals::visit_fields(signal, spoil);
      EXPECT_EQ(refusal(signal), spoil.spoilt + " is not finite");
      EXPECT_EQ(spoil.seen, kNumbers) << "a field this test does not know";
    }
  }
}

TEST(CheckGains, RefusesADelayTheControllerCannotHold) {
  JointControllerGains signal = good();
  signal.delay_ticks = 3;
  EXPECT_EQ(refusal(signal), "delay_ticks is 3: give 0 to 2");
}

TEST(CheckGains, RefusesAPhaseThereIsNoSlotFor) {
  JointControllerGains signal = good();
  signal.phase = static_cast<signals::Phase>(2);
  EXPECT_EQ(refusal(signal), "phase is 2: give 0 (swing) or 1 (stance)");
}

TEST(CheckGains, RefusesAScaleThatIsNotPositive) {
  for (double JointControllerGains::*scale :
       {&JointControllerGains::position_scale_m_or_rad, &JointControllerGains::velocity_scale_m_s_or_rad_s,
        &JointControllerGains::force_scale_N_or_Nm, &JointControllerGains::current_scale_A}) {
    for (const double value : {0.0, -1.0}) {
      JointControllerGains signal = good();
      signal.*scale = value;
      EXPECT_EQ(refusal(signal), "a scale is not positive");
    }
  }
}

TEST(CheckGains, RefusesAnUnstableClosedLoop) {
  JointControllerGains signal = good();
  signal.k_force = -signal.k_force;
  EXPECT_EQ(refusal(signal).find("closed loop unstable for the model they came with: spectral radius "), 0u)
      << refusal(signal);
}

// The pole of the unused sum lies at one, by rounding on either side of it.
TEST(CheckGains, RefusesGainsWithoutIntegralAction) {
  for (double JointControllerGains::*part :
       {&JointControllerGains::k_integral, &JointControllerGains::integral_factor}) {
    for (const double value : {0.0, -1.0}) {
      JointControllerGains signal = good();
      signal.*part = value;
      EXPECT_EQ(refusal(signal), "no integral action");
    }
  }
}

// The thesis's LQR has no room for delay: 50 kg with two ticks has spectral radius 1.155.
TEST(CheckGains, RefusesGainsDesignedForLessDelayThanTheyAreFor) {
  JointControllerGains signal = good();
  signal.delay_ticks = 2;
  EXPECT_EQ(refusal(signal).find("closed loop unstable"), 0u) << refusal(signal);
}

TEST(CheckGains, RefusesCompliantGainsThatLeanOnThePosition) {
  JointControllerGains signal = good();
  ASSERT_EQ(signal.compliant, 1);
  signal.k_position = 1e6;
  EXPECT_EQ(refusal(signal).find("compliant gains with a position gain"), 0u) << refusal(signal);
}

}  // namespace gains_check_test
}  // namespace farrier::joint_node
