// Faults of data that can be read, each put into good data and found again; and good data of many kinds left alone.

#include "diagnosis/data/recording_check.hpp"

#include "diagnosis/data/derive_velocity.hpp"
#include "recording.hpp"

namespace farrier::diagnosis {
namespace recording_check_test {

struct Case {
  Recording recording;
  robot::Joint joint;

  explicit Case(const TestBench& bench = {}) : recording(bench.recording()), joint(bench.joint()) {}
  std::vector<Finding> findings() const { return check_recording(recording, joint); }
  std::string found() const { return summary(findings()); }
  double supply() const { return joint.actuator.supply_pressure_Pa; }
};

void scale(std::vector<double>& values, double factor, double offset = 0.0) {
  for (double& value : values) {
    value = factor * value + offset;
  }
}

void clip(std::vector<double>& values, double low, double high) {
  for (double& value : values) {
    value = std::clamp(value, low, high);
  }
}

TEST(RecordingCheck, LeavesGoodRecordingsAlone) {
  for (const bool rotary : {false, true}) {
    for (const bool noise : {false, true}) {
      for (const double period : {0.0002, 0.001, 0.004}) {
        Case good({.samples = 6000, .period_s = period, .rotary = rotary, .noise = noise});
        EXPECT_EQ(good.found(), "") << rotary << noise << period << to_string(good.findings(), "");
        good.recording.pressure_a_Pa.clear();
        good.recording.pressure_b_Pa.clear();
        good.recording.supply_pressure_Pa.clear();
        good.recording.valve_current_A.clear();
        DerivedVelocity derived = derive_velocity(good.recording.position, period);
        good.recording.velocity = std::move(derived.velocity);
        good.recording.velocity_derived = true;
        EXPECT_EQ(good.found(), "") << rotary << noise << period << to_string(good.findings(), "");
      }
    }
  }
}

TEST(RecordingCheck, LeavesAJointThatStandsToOthers) {
  Case still;
  Recording& r = still.recording;
  const NoiseStream stream(5, "still", "force");
  for (std::size_t i = 0; i < r.position.size(); ++i) {
    r.position[i] = 0.04;  // an encoder's count
    r.velocity[i] = 0.0;
    r.force[i] = 100.0 + stream.normal(static_cast<Tick>(i));
    r.pressure_a_Pa[i] = r.pressure_b_Pa[i] = 0.5 * still.supply();
    r.valve_current_A[i] = 1e-4 * (i % 20 < 10 ? 1.0 : -1.0);  // dither
  }
  EXPECT_EQ(still.found(), "");
  r.force.assign(r.force.size(), 100.0);
  r.valve_current_A.assign(r.force.size(), 0.0);
  EXPECT_EQ(still.found(), "") << "nothing moves";
}

TEST(RecordingCheck, LeavesARestBeforeTheMotionAlone) {
  Case rest({.samples = 4000});
  Recording& r = rest.recording;
  const auto lowest = std::min_element(r.position.begin(), r.position.end());
  const auto low = static_cast<std::size_t>(lowest - r.position.begin());
  for (auto* values : {&r.position, &r.velocity, &r.force, &r.pressure_a_Pa, &r.pressure_b_Pa}) {
    std::fill(values->begin(), values->begin() + static_cast<long>(low), (*values)[low]);
  }
  EXPECT_EQ(rest.found(), "");
}

TEST(RecordingCheck, LeavesCoarseSensorsAlone) {
  Case coarse;
  for (double& value : coarse.recording.position) {
    value = 2e-5 * std::round(value / 2e-5);
  }
  for (double& value : coarse.recording.velocity) {
    value = 5e-3 * std::round(value / 5e-3);
  }
  for (double& value : coarse.recording.force) {
    value = 2.0 * std::round(value / 2.0);
  }
  EXPECT_EQ(coarse.found(), "");
}

TEST(RecordingCheck, KnowsACylinderFromAMotor) {
  Case rotary({.rotary = true});
  EXPECT_EQ(summary(check_recording(rotary.recording, TestBench{}.joint())), "wrong_coordinates@0");
}

TEST(RecordingCheck, NamesTheUnitItLooksLike) {
  const auto found_after = [](bool rotary, auto&& change) {
    Case wrong({.rotary = rotary});
    change(wrong.recording);
    const auto findings = wrong.findings();
    return findings.size() == 1 && findings[0].what == "wrong_units" ? findings[0].text : to_string(findings, "found");
  };
  const double degrees = 180.0 / std::numbers::pi;
  EXPECT_TRUE(mentions(found_after(false, [](Recording& r) { scale(r.position, 1e3); }), "looks like millimetres"));
  EXPECT_TRUE(mentions(found_after(false, [](Recording& r) { scale(r.position, 1e3, -40); }), "like millimetres"));
  EXPECT_TRUE(mentions(found_after(false, [](Recording& r) { scale(r.position, 1e2); }), "looks like centimetres"));
  EXPECT_TRUE(mentions(found_after(false, [](Recording& r) { scale(r.position, 1e6); }), "looks like micrometres"));
  EXPECT_TRUE(mentions(found_after(false, [](Recording& r) { scale(r.position, 7e4); }), "no unit fits: give m"));
  EXPECT_TRUE(mentions(found_after(true, [&](Recording& r) { scale(r.position, degrees); }), "looks like degrees"));
  EXPECT_TRUE(mentions(found_after(false, [](Recording& r) { scale(r.velocity, 1e3); }), "millimetres per second"));
  EXPECT_TRUE(mentions(found_after(true, [&](Recording& r) { scale(r.velocity, degrees); }), "degrees per second"));
  EXPECT_TRUE(mentions(found_after(false, [](Recording& r) { scale(r.force, 1e-3); }), "looks like kilonewtons"));
  EXPECT_TRUE(mentions(found_after(false, [](Recording& r) { scale(r.force, 1e3); }), "no unit fits: give N"));
  EXPECT_TRUE(mentions(found_after(false, [](Recording& r) { scale(r.valve_current_A, 1e3); }), "milliamperes"));
  EXPECT_TRUE(mentions(found_after(false, [](Recording& r) { scale(r.valve_current_A, 1e4); }), "percent of full"));
  EXPECT_TRUE(mentions(found_after(false, [](Recording& r) { scale(r.valve_current_A, 1e6); }), "microamperes"));
  for (const auto& [factor, name] : {std::pair{1e-5, "looks like bar"}, {1e-6, "megapascals"}, {1e-3, "kilopascals"},
                                     {1.0 / 6894.757, "pounds per square inch"}}) {
    for (auto Recording::*channel :
         {&Recording::pressure_a_Pa, &Recording::pressure_b_Pa, &Recording::supply_pressure_Pa}) {
      const std::string text = found_after(false, [&, factor = factor](Recording& r) { scale(r.*channel, factor); });
      EXPECT_TRUE(mentions(text, name)) << text;
    }
  }
}

TEST(RecordingCheck, NamesSeveralWrongUnitsTogether) {
  Case wrong;
  scale(wrong.recording.position, 1e3);
  scale(wrong.recording.velocity, 1e3);
  scale(wrong.recording.force, 1e-3);
  scale(wrong.recording.valve_current_A, 1e3);
  scale(wrong.recording.pressure_a_Pa, 1e-5);
  EXPECT_EQ(wrong.found(), "wrong_units@0 wrong_units@0 wrong_units@0 wrong_units@0") << "velocity waits for position";
}

TEST(RecordingCheck, FindsNoKilonewtonsInALoadThatIsNextToNothing) {
  Case light;
  light.joint.swing_load.damping = light.joint.stance_load.damping = 1.0;
  scale(light.recording.force, 1.0 / 500.0);
  EXPECT_EQ(light.found(), "");
}

TEST(RecordingCheck, NamesPositionsOutsideTheStroke) {
  Case spike;
  spike.recording.position[700] = 0.0825;
  spike.recording.position[900] = -0.002;
  const auto found = spike.findings();
  ASSERT_EQ(summary(found), "out_of_range@702");
  EXPECT_EQ(found[0].text, "lines 702 and 902, column position_m: 2 values outside the stroke, 0 to 0.08 m (-0.002 to "
                           "0.0825); count from the fully retracted end, or correct the stroke in the robot file");
  spike.recording.position[700] = 0.0815;  // 1.9 % beyond
  spike.recording.position[900] = -0.0015;
  EXPECT_EQ(spike.found(), "");
  Case centred;
  scale(centred.recording.position, 1.0, -0.04);
  EXPECT_EQ(centred.found().substr(0, 13), "out_of_range@");
}

TEST(RecordingCheck, ComparesVelocityWithPosition) {
  Case turned;
  scale(turned.recording.velocity, -1.0);
  EXPECT_EQ(turned.found(), "wrong_sign@0");
  Case scaled;
  scale(scaled.recording.velocity, 5.0);
  EXPECT_EQ(scaled.found(), "inconsistent@0");
  Case other;
  other.recording.velocity = TestBench{.samples = 2000, .period_s = 0.00137}.recording().velocity;
  EXPECT_EQ(other.found(), "inconsistent@0");
  Case biased;
  scale(biased.recording.velocity, 1.1, 0.05);
  EXPECT_EQ(biased.found(), "");
}

TEST(RecordingCheck, NamesSaturatedSensors) {
  Case force;
  const double most = *std::max_element(force.recording.force.begin(), force.recording.force.end());
  clip(force.recording.force, -1e9, 0.6 * most);
  const auto found = force.findings();
  ASSERT_EQ(found.size(), 1u) << to_string(found, "");
  EXPECT_EQ(found[0].what, "saturated");
  EXPECT_GT(found[0].row, 1u);
  EXPECT_TRUE(mentions(found[0].text, "column force_N: ") && mentions(found[0].text, "at its highest value"));
  Case both;
  clip(both.recording.force, -0.5 * most, 0.5 * most);
  EXPECT_EQ(both.findings().size(), 2u) << "one for either end";
  Case position;
  clip(position.recording.position, 0.026, 1.0);
  EXPECT_EQ(position.findings().at(0).what, "saturated");
  Case velocity;
  clip(velocity.recording.velocity, -0.1, 1e9);
  EXPECT_EQ(velocity.findings().at(0).what, "saturated");
  Case pressure;
  clip(pressure.recording.pressure_b_Pa, 0.0, 0.5 * pressure.supply());
  EXPECT_EQ(pressure.findings().at(0).what, "saturated");
}

TEST(RecordingCheck, LeavesCavitationAndEndStopsAlone) {
  Case cavitation;
  scale(cavitation.recording.pressure_b_Pa, 1.0, -0.5 * cavitation.supply());
  clip(cavitation.recording.pressure_b_Pa, 0.0, 1e9);
  EXPECT_EQ(cavitation.found(), "");
  Case stopped;  // the force changes while the piston stands at its end
  for (std::size_t i = 0; i < 2000; ++i) {
    double& position = stopped.recording.position[i];
    position += 0.025;
    stopped.recording.velocity[i] *= position < 0.08 ? 1.0 : 0.0;
    position = std::min(position, 0.08);
  }
  EXPECT_EQ(stopped.found(), "");
}

TEST(RecordingCheck, NamesAValveThatIsAlwaysFullOpen) {
  Case open;
  scale(open.recording.valve_current_A, 20.0);
  clip(open.recording.valve_current_A, -0.01, 0.01);
  ASSERT_EQ(open.findings().size(), 1u) << to_string(open.findings(), "");
  EXPECT_EQ(open.findings()[0].what, "saturated");
  Case sometimes;
  scale(sometimes.recording.valve_current_A, 1.5);
  clip(sometimes.recording.valve_current_A, -0.01, 0.01);
  EXPECT_EQ(sometimes.found(), "");
}

TEST(RecordingCheck, NamesFrozenSensors) {
  for (auto Recording::*channel : {&Recording::position, &Recording::velocity, &Recording::force,
                                   &Recording::pressure_a_Pa, &Recording::pressure_b_Pa}) {
    Case frozen;
    std::vector<double>& values = frozen.recording.*channel;
    values.assign(values.size(), values[0]);
    EXPECT_EQ(frozen.found(), "frozen@0") << to_string(frozen.findings(), "");
  }
  Case supply;
  supply.recording.supply_pressure_Pa.assign(2000, supply.supply());
  supply.recording.valve_current_A.assign(2000, 0.001);
  EXPECT_EQ(supply.found(), "");
  Case all;  // but for the current
  for (auto* values : {&all.recording.position, &all.recording.velocity, &all.recording.force,
                       &all.recording.pressure_a_Pa, &all.recording.pressure_b_Pa}) {
    values->assign(2000, 0.5 * (values == &all.recording.position ? 0.08 : 1e7));
  }
  EXPECT_EQ(all.findings().size(), 6u) << "and a force that is none: " << to_string(all.findings(), "");
}

TEST(RecordingCheck, NamesASensorThatStopsForAWhile) {
  Case held;
  std::fill(held.recording.force.begin() + 500, held.recording.force.begin() + 800, held.recording.force[500]);
  const auto found = held.findings();
  ASSERT_EQ(summary(found), "frozen@502");
  EXPECT_TRUE(mentions(found[0].text, "line 502, column force_N: 300 samples at an unchanging value")) << found[0].text;
}

}  // namespace recording_check_test
}  // namespace farrier::diagnosis
