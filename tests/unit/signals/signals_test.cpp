#include <gtest/gtest.h>

#include <set>
#include <string>

#include "signals/fields.hpp"
#include "signals/signals.hpp"

namespace farrier::signals {
namespace signals_test {

TEST(Signals, TextWithoutItsEndIsReadToTheEndOfItsField) {
  Name name;
  name.fill('x');
  EXPECT_EQ(text_of(name), std::string(name.size(), 'x'));
  assign(name, "lf");
  EXPECT_EQ(text_of(name), "lf");
}

TEST(Signals, AreInvalidUntilFilledIn) {
  EXPECT_EQ(JointSensors{}.tick, kNoTick);
  EXPECT_EQ(JointCommand{}.tick, kNoTick);
  EXPECT_EQ(JointValveCommand{}.tick, kNoTick);
  EXPECT_EQ(JointControllerGains{}.effective_tick, kNoTick);
  EXPECT_EQ(JointControllerGains{}.generation, 0u) << "0 is never issued";
  EXPECT_EQ(SystemMode{}.epoch, 0u) << "0 is never issued";
  EXPECT_EQ(JointModelEstimate{}.tick, kNoTick);
  EXPECT_EQ(JointModelEstimate{}.validity, 0.0) << "not an estimate";
  EXPECT_EQ(JointModelEstimate{}.samples, 0u) << "nothing behind it";
  EXPECT_EQ(JointUpdateDecision{}.tick, kNoTick);
  EXPECT_EQ(JointUpdateDecision{}.generation, 0u) << "0 is never issued";
  EXPECT_EQ(JointValveCommand{}.state, JointState::kNull);
  EXPECT_EQ(SystemMode{}.mode, Mode::kIdle);
}

TEST(Signals, VisitEveryFieldOnceInWireOrder) {
  JointSensors sensors;
  std::vector<std::string> names;
  visit_fields(sensors, [&](const char* name, auto&) { names.emplace_back(name); });
  EXPECT_EQ(names,
            (std::vector<std::string>{"joint", "tick", "sample_time_ns", "position_m_or_rad", "velocity_m_s_or_rad_s",
                                      "force_N_or_Nm", "valve_command_tick", "required_generation", "required_epoch"}));
}

// The bytes of a struct's fields cannot exceed the struct, and with padding below 8 bytes a field nothing leaves out.
template <class Signal>
void expect_no_field_left_out(const char* name) {
  const Signal signal{};
  std::size_t bytes = 0, fields = 0;
  visit_fields(signal, [&](const char*, const auto& field) {
    bytes += sizeof field;
    ++fields;
  });
  EXPECT_LE(bytes, sizeof(Signal)) << name;
  EXPECT_GT(bytes + 8 * fields, sizeof(Signal)) << name;
}

TEST(Signals, ListTheFieldsTheyHave) {
#define FARRIER_EXPECT(Signal, file) expect_no_field_left_out<Signal>(#Signal);
  FARRIER_SIGNALS(FARRIER_EXPECT)
#undef FARRIER_EXPECT
}

TEST(Signals, CutATextThatDoesNotFitAndEndItWithZero) {
  Name name;
  assign(name, std::string(40, 'x'));
  EXPECT_EQ(text_of(name), std::string(name.size() - 1, 'x'));
}

TEST(Signals, ForgetTheOldTextBehindAShorterOne) {
  Name name;
  assign(name, "joint_node_lf_kfe");
  assign(name, "lab");
  EXPECT_EQ(text_of(name), "lab");
  for (std::size_t i = 3; i < name.size(); ++i) {
    EXPECT_EQ(name[i], '\0') << "equal names must be equal bytes on the wire";
  }
}

TEST(Signals, NameEveryValueOfTheirEnums) {
  EXPECT_STREQ(to_string(Phase::kSwing), "swing");
  EXPECT_STREQ(to_string(Phase::kStance), "stance");
  EXPECT_STREQ(to_string(Mode::kArmed), "armed");
  EXPECT_STREQ(to_string(JointState::kDamping), "damping");
  EXPECT_STREQ(to_string(Severity::kError), "error");
  EXPECT_STREQ(to_string(static_cast<Mode>(200)), "unknown mode");
}

TEST(Signals, NameEveryVerdictOfTheUpdateLogicDifferently) {
  std::set<std::string> names;
  constexpr int kVerdicts = static_cast<int>(UpdateVerdict::kDwelling) + 1;
  for (int verdict = 0; verdict < kVerdicts; ++verdict) {
    names.insert(to_string(static_cast<UpdateVerdict>(verdict)));
  }
  EXPECT_EQ(names.size(), static_cast<std::size_t>(kVerdicts));
  EXPECT_EQ(names.count("accepted"), 1u);
  EXPECT_EQ(names.count("unknown verdict"), 0u);
  EXPECT_STREQ(to_string(static_cast<UpdateVerdict>(kVerdicts)), "unknown verdict");
}

}  // namespace signals_test
}  // namespace farrier::signals
