#include <gtest/gtest.h>
#include <unistd.h>

#include <bit>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <limits>
#include <random>
#include <sstream>

#include "trace/trace.hpp"

namespace farrier::trace {
namespace trace_file_test {

const std::vector<std::string> kJoints{"lf_haa", "lf_hfe", "lf_kfe"};

class Trace : public ::testing::Test {
 protected:
  void TearDown() override { std::filesystem::remove(path_); }

  void write(const std::vector<TraceRow>& rows) const {
    auto writer = TraceWriter::create(path_, kJoints);
    ASSERT_TRUE(writer);
    for (const TraceRow& row : rows) {
      writer.value().write(row);
    }
    EXPECT_TRUE(writer.value().finish());
  }
  std::string text() const {
    std::ostringstream text;
    text << std::ifstream(path_).rdbuf();
    return text.str();
  }
  void replace(const std::string& text) const { std::ofstream(path_) << text; }
  std::string refusal() const {
    const auto rows = read_trace(path_, kJoints);
    return rows ? "accepted" : rows.error().message;
  }

  const std::string path_ = (std::filesystem::temp_directory_path() /
                             ("farrier_trace_" + std::to_string(::getpid()) + "_" +
                              ::testing::UnitTest::GetInstance()->current_test_info()->name() + ".csv"))
                                .string();
};

TraceRow row_of(double value, std::uint16_t joint = 1) {
  return {.tick = 12,
          .joint = joint,
          .position_m_or_rad = value,
          .velocity_m_s_or_rad_s = -value,
          .force_N_or_Nm = 3 * value,
          .pressure_a_Pa = 1e7 * value,
          .pressure_b_Pa = 1e6 * value,
          .force_reference_N_or_Nm = value / 3,
          .valve_current_A = value / 7,
          .external_force_N_or_Nm = value / 11,
          .load_mass_kg_or_kgm2 = value / 13,
          .phase = Phase::kStance,
          .actual_phase = Phase::kSwing,
          .state = signals::JointState::kTracking,
          .generation = 4'000'000'000u,
          .faults = 0x15,
          .command_age_ticks = 3};
}

void expect_equal_bits(double one, double other) {
  if (!(std::isnan(one) && std::isnan(other))) {
    EXPECT_EQ(std::bit_cast<std::uint64_t>(one), std::bit_cast<std::uint64_t>(other)) << one << " and " << other;
  }
}

void expect_equal(const TraceRow& one, const TraceRow& other) {
  EXPECT_EQ(one.tick, other.tick);
  EXPECT_EQ(one.joint, other.joint);
  expect_equal_bits(one.position_m_or_rad, other.position_m_or_rad);
  expect_equal_bits(one.velocity_m_s_or_rad_s, other.velocity_m_s_or_rad_s);
  expect_equal_bits(one.force_N_or_Nm, other.force_N_or_Nm);
  expect_equal_bits(one.pressure_a_Pa, other.pressure_a_Pa);
  expect_equal_bits(one.pressure_b_Pa, other.pressure_b_Pa);
  expect_equal_bits(one.force_reference_N_or_Nm, other.force_reference_N_or_Nm);
  expect_equal_bits(one.valve_current_A, other.valve_current_A);
  expect_equal_bits(one.external_force_N_or_Nm, other.external_force_N_or_Nm);
  expect_equal_bits(one.load_mass_kg_or_kgm2, other.load_mass_kg_or_kgm2);
  EXPECT_EQ(one.phase, other.phase);
  EXPECT_EQ(one.actual_phase, other.actual_phase);
  EXPECT_EQ(one.state, other.state);
  EXPECT_EQ(one.generation, other.generation);
  EXPECT_EQ(one.faults, other.faults);
  EXPECT_EQ(one.command_age_ticks, other.command_age_ticks);
}

TEST_F(Trace, ReadsBackTheBitsThatWereWritten) {
  std::mt19937_64 random(3);
  std::vector<TraceRow> rows;
  for (int i = 0; i < 500; ++i) {
    // Any finite double: random bits, exponents of all sizes.
    double value = std::bit_cast<double>(random());
    value = std::isfinite(value) ? value : 1.0;
    rows.push_back(row_of(value, static_cast<std::uint16_t>(i % 3)));
  }
  using Limits = std::numeric_limits<double>;
  for (const double value :
       {0.0, -0.0, 0.1, Limits::denorm_min(), Limits::max(), Limits::infinity(), Limits::quiet_NaN()}) {
    rows.push_back(row_of(value));
  }
  write(rows);
  const auto read = read_trace(path_, kJoints);
  ASSERT_TRUE(read) << read.error().message;
  ASSERT_EQ(read.value().size(), rows.size());
  for (std::size_t i = 0; i < rows.size(); ++i) {
    expect_equal(read.value()[i], rows[i]);
  }
}

TEST_F(Trace, HoldsTheWidestNumbersAndTheLongestNames) {
  TraceRow row = row_of(-2.2250738585072014e-308, 0);
  row.tick = std::numeric_limits<Tick>::max();
  row.generation = row.faults = row.command_age_ticks = std::numeric_limits<std::uint32_t>::max();
  const std::vector<std::string> names{std::string(64, 'n')};
  {
    auto writer = TraceWriter::create(path_, names);
    ASSERT_TRUE(writer);
    writer.value().write(row);
    EXPECT_TRUE(writer.value().finish());
  }
  const auto read = read_trace(path_, names);
  ASSERT_TRUE(read) << read.error().message;
  expect_equal(read.value().at(0), row);
}

TEST_F(Trace, GivesEqualBytesForEqualRows) {
  write({row_of(0.1), row_of(0.2)});
  const std::string first = text();
  write({row_of(0.1), row_of(0.2)});
  EXPECT_EQ(text(), first);
}

TEST_F(Trace, NamesJointsInsteadOfNumberingThem) {
  write({row_of(0.1, 2)});
  EXPECT_NE(text().find("\n12,lf_kfe,0.1,"), std::string::npos) << text();
}

TEST_F(Trace, RefusesAPathThatCannotBeWritten) {
  const auto writer = TraceWriter::create("/nowhere/at/all.csv", kJoints);
  ASSERT_FALSE(writer);
  EXPECT_NE(writer.error().message.find("/nowhere/at/all.csv: No such file"), std::string::npos)
      << writer.error().message;
}

TEST_F(Trace, RefusesAFileThatIsNotThere) { EXPECT_EQ(refusal(), path_ + ":1: not a trace of this version"); }

TEST_F(Trace, RefusesAnotherVersionsHeader) {
  replace("tick,joint,position\n");
  EXPECT_EQ(refusal(), path_ + ":1: not a trace of this version");
}

TEST_F(Trace, RefusesABrokenRowWithItsLine) {
  write({row_of(0.1), row_of(0.2), row_of(0.3)});
  const std::string good = text();
  const std::size_t second = good.find('\n', good.find('\n') + 1) + 1;  // start of line 3
  const std::size_t length = good.find('\n', second) - second;
  const std::string row = good.substr(second, length);
  const std::string at_line_3 = path_ + ":3: not a row of a trace";
  const auto with = [&](const std::string& broken) { return std::string(good).replace(second, length, broken); };
  const std::string fewer = row.substr(0, row.rfind(','));
  for (const std::string& broken :
       {std::string(), std::string("12"), fewer, row + ",0", "x" + row, row + "x",
        "12,lf_toe" + row.substr(row.find(',', 3)), std::string(row).replace(row.find("0.2"), 3, "0,2"),
        std::string(row).replace(row.find("0.2"), 3, "")}) {
    replace(with(broken));
    EXPECT_EQ(refusal(), at_line_3) << "'" << broken << "'";
  }
}

TEST_F(Trace, RefusesANumberThatDoesNotFitItsColumn) {
  write({row_of(0.1)});
  std::string changed = text();
  changed.replace(changed.find(",1,0,2,"), 7, ",256,0,2,");  // phase travels as one byte
  replace(changed);
  EXPECT_EQ(refusal(), path_ + ":2: not a row of a trace");
}

}  // namespace trace_file_test
}  // namespace farrier::trace
