// Reading recordings: what is accepted, and that everything wrong is named with its place.

#include "recording.hpp"

namespace farrier::diagnosis {
namespace recording_test {

const Recording& made() {
  static const Recording recording = TestBench{}.recording();
  return recording;
}
CsvFile good() { return CsvFile::of(made()); }

constexpr std::size_t kTime = 0, kCurrent = 1, kPosition = 2, kVelocity = 3, kForce = 4;

TEST_F(RecordingFile, ReadsBackWhatWasRecorded) {
  const auto recording = read(good());
  ASSERT_TRUE(recording) << to_string(recording.error().findings, path_);
  const Recording& r = recording.value();
  EXPECT_EQ(r.source, std::filesystem::path(path_).filename());
  EXPECT_EQ(r.coordinates, Coordinates::kLinear);
  EXPECT_NEAR(r.period_s, 0.001, 1e-12);
  EXPECT_EQ(r.time_s, made().time_s);
  EXPECT_EQ(r.valve_current_A, made().valve_current_A);
  EXPECT_EQ(r.position, made().position);
  EXPECT_EQ(r.velocity, made().velocity);
  EXPECT_EQ(r.force, made().force);
  EXPECT_EQ(r.line, made().line);
  EXPECT_TRUE(r.pressure_a_Pa.empty() && r.pressure_b_Pa.empty() && r.supply_pressure_Pa.empty() && r.swing.empty());
  EXPECT_FALSE(r.velocity_derived);
  EXPECT_EQ(r.remarks, std::vector<std::string>{});
}

TEST_F(RecordingFile, ReadsARotaryMotor) {
  const Recording rotary = TestBench{.rotary = true}.recording();
  const auto recording = read(CsvFile::of(rotary));
  ASSERT_TRUE(recording) << to_string(recording.error().findings, path_);
  EXPECT_EQ(recording.value().coordinates, Coordinates::kRotary);
  EXPECT_EQ(recording.value().position, rotary.position);
  EXPECT_EQ(recording.value().force, rotary.force);
}

TEST_F(RecordingFile, ReadsOptionalColumnsInAnyOrder) {
  CsvFile file = good();
  file.add("swing", "1");
  file.add("supply_pressure_Pa", "16e6");
  file.add("pressure_b_Pa", "7e6");
  file.add("pressure_a_Pa", "8e6");
  std::reverse(file.names.begin(), file.names.end());
  for (auto& row : file.rows) {
    std::reverse(row.begin(), row.end());
  }
  const auto recording = read(file);
  ASSERT_TRUE(recording) << to_string(recording.error().findings, path_);
  EXPECT_EQ(recording.value().position, made().position);
  EXPECT_EQ(recording.value().pressure_a_Pa, std::vector<double>(2000, 8e6));
  EXPECT_EQ(recording.value().pressure_b_Pa, std::vector<double>(2000, 7e6));
  EXPECT_EQ(recording.value().supply_pressure_Pa, std::vector<double>(2000, 16e6));
  EXPECT_EQ(recording.value().swing, std::vector<std::uint8_t>(2000, 1));
}

TEST_F(RecordingFile, ToleratesWhatSpreadsheetsAndLoggersAdd) {
  CsvFile file = good();
  file.names[kForce] = " \"force_N\"";
  for (auto& row : file.rows) {
    row[kPosition] = " \"" + row[kPosition] + "\"\t";
    row[kForce] = row[kForce][0] == '-' ? row[kForce] : "+" + row[kForce];
  }
  const auto recording = read("\xef\xbb\xbf# logger 3\r\n\r\n# \"kfe\", 1 kHz\r\n" + file.text("\r\n") + "\r\n  \r\n");
  ASSERT_TRUE(recording) << to_string(recording.error().findings, path_);
  EXPECT_EQ(recording.value().position, made().position);
  EXPECT_EQ(recording.value().force, made().force);
  EXPECT_EQ(recording.value().line.front(), 5u);
  EXPECT_EQ(recording.value().remarks, std::vector<std::string>{});
}

TEST_F(RecordingFile, TakesTinyNumbersForZeroAndADateForTime) {
  CsvFile file = good();
  file.rows[3][kForce] = "1e-400";
  for (std::size_t i = 0; i < file.rows.size(); ++i) {
    file.rows[i][kTime] = CsvFile::number(1.7e9 + static_cast<double>(i) / 1000.0);  // 0.2 us of a double left
  }
  const auto recording = read(file);
  ASSERT_TRUE(recording) << to_string(recording.error().findings, path_);
  EXPECT_EQ(recording.value().force[3], 0.0);
  EXPECT_NEAR(recording.value().period_s, 0.001, 1e-9);
}

TEST_F(RecordingFile, RemarksOnColumnsItDoesNotRead) {
  CsvFile file = good();
  file.add("temperature", "warm");
  file.add("", "");
  file.add("presure_a_Pa", "1");
  file.add("pressure_b_bar", "1");
  const auto recording = read(file);
  ASSERT_TRUE(recording) << to_string(recording.error().findings, path_);
  EXPECT_EQ(recording.value().remarks,
            (std::vector<std::string>{"Column 'pressure_b_bar' is read as pressure_b_Pa, times 1e+05.",
                                      "Column 'temperature' is not read.", "A column without a name is not read.",
                                      "Column 'presure_a_Pa' is not read; did you mean pressure_a_Pa?"}));
}

TEST_F(RecordingFile, WithoutCurrentIsForTheLoadSideAlone) {
  CsvFile file = good();
  file.erase(kCurrent);
  const auto recording = read(file);
  ASSERT_TRUE(recording) << to_string(recording.error().findings, path_);
  EXPECT_TRUE(recording.value().valve_current_A.empty());
  ASSERT_EQ(recording.value().remarks.size(), 1u);
  EXPECT_TRUE(mentions(recording.value().remarks[0], "load side alone"));
}

TEST_F(RecordingFile, WithoutVelocityHasItDerived) {
  CsvFile file = good();
  file.erase(kVelocity);
  const auto recording = read(file);
  ASSERT_TRUE(recording) << to_string(recording.error().findings, path_);
  const Recording& r = recording.value();
  EXPECT_TRUE(r.velocity_derived);
  EXPECT_GT(r.derived_velocity_noise, 0.0);
  ASSERT_EQ(r.velocity.size(), r.position.size());
  double error = 0.0;
  for (std::size_t i = 0; i < r.velocity.size(); ++i) {
    error = std::max(error, std::abs(r.velocity[i] - TestBench::velocity(0.08, r.time_s[i])));
  }
  // Six standard deviations, and the ends, where a window reaches to one side and a slope is four times as uncertain.
  EXPECT_LT(error, 4 * 6 * r.derived_velocity_noise);
  ASSERT_EQ(r.remarks.size(), 1u);
  EXPECT_TRUE(mentions(r.remarks[0], "No velocity_m_s is recorded: it is derived from position_m")) << r.remarks[0];
}

TEST_F(RecordingFile, RejectsFilesThatAreNoRecordings) {
  const auto refusal = [](const std::string& path) {
    const auto recording = read_recording(path);
    return recording ? "accepted" : summary(recording.error().findings) + " " + recording.error().findings[0].text;
  };
  EXPECT_EQ(refusal("/nowhere/run.csv"),
            "unreadable@0 cannot read the file /nowhere/run.csv: No such file or directory");
  EXPECT_EQ(refusal("/"), "directory@0 cannot read the file /: it is a directory; name a CSV file");
  EXPECT_EQ(summary(findings("")), "empty@0");
  EXPECT_EQ(summary(findings("# nothing\n\n# else\n")), "empty@0");
  EXPECT_EQ(summary(findings(std::string("\x7f"
                                         "ELF\x02\x01\0\0\0",
                                         9))),
            "not_text@1");
  EXPECT_EQ(summary(findings(std::string("\xff\xfet\0i\0m\0e\0_\0s\0\n\0", 16))), "not_text@1");
  EXPECT_EQ(summary(findings(std::string(1'000'000, 'x'))), "not_text@1");
  EXPECT_EQ(summary(findings("time,place\n1,2\n")), "not_a_recording@1");
  EXPECT_EQ(summary(findings("0.1,0.2,0.3\n0.2,0.2,0.3\n")), "no_header@1");
  EXPECT_EQ(summary(findings("time_s;position_m;force_N\n0;1;2\n")), "too_short@0");
  EXPECT_EQ(summary(findings("time_s\tposition_m\tforce_N\n0\t1\t2\n")), "too_short@0");
}

TEST_F(RecordingFile, StopsAtALineWithoutEnd) {
  EXPECT_EQ(summary(findings(good().text() + std::string(1'000'000, '1') + "\n")), "not_text@2002");
}

TEST_F(RecordingFile, NamesEveryMissingColumn) {
  EXPECT_EQ(summary(findings("velocity_m_s\n1\n")), "missing_column@1 missing_column@1 missing_column@1");
  CsvFile file = good();
  file.names[kPosition] = "position_in";
  file.names[kForce] = "load";
  const auto found = findings(file);
  ASSERT_EQ(summary(found), "missing_column@1 missing_column@1");
  EXPECT_EQ(found[0].text, "line 1, column position_m is missing; 'position_in' may be meant: give it that name");
  EXPECT_EQ(found[1].text, "line 1, column force_N is missing; add it");
}

TEST_F(RecordingFile, RefusesColumnsTwiceAndOfBothKinds) {
  CsvFile twice = good();
  twice.add("force_N", "1");
  EXPECT_EQ(summary(findings(twice)), "duplicate_column@1");
  CsvFile mixed = good();
  mixed.names[kForce] = "torque_Nm";
  EXPECT_EQ(summary(findings(mixed)), "mixed_coordinates@1 missing_column@1");
}

TEST_F(RecordingFile, NamesEveryBadCellByKindAndColumn) {
  CsvFile file = good();
  for (const std::size_t row : {10, 20, 30, 40, 50}) {
    file.rows[row][kForce] = row == 30 ? "-inf" : "NaN";
  }
  file.rows[100][kForce] = "";
  file.rows[60][kPosition] = "0.04 m\x01";
  file.rows[70][kPosition] = "0x1p3";
  file.rows[80][kCurrent] = "1e999";
  file.rows[90][kTime] = "soon";
  const auto found = findings(file);
  EXPECT_EQ(summary(found), "nan@12 not_a_number@62 nan@82 not_a_number@92 empty_cell@102");
  EXPECT_EQ(found[0].text,
            "lines 12, 22, 32 and 2 more, column force_N: 5 values not finite (NaN or infinite); cut "
            "the recording there, or record again");
  EXPECT_EQ(found[1].text,
            "lines 62 and 72, column position_m: 2 cells that cannot be read as a number, first "
            "'0.04 m?'; write plain numbers with a decimal point");
  EXPECT_TRUE(mentions(found[4].text, "line 102, column force_N: 1 cell without a value")) << found[4].text;
}

TEST_F(RecordingFile, NamesRaggedRowsOnceAndFindsNoGapThere) {
  CsvFile file = good();
  file.rows[10].pop_back();
  file.rows[20].push_back("1");
  const auto found = findings(file);
  ASSERT_EQ(summary(found), "ragged_row@12");
  EXPECT_TRUE(mentions(found[0].text, "lines 12 and 22: 2 rows with another number of cells than the 5 of line 1"));
  const std::string whole = good().text();
  const auto cut = findings(whole.substr(0, whole.rfind(',')));
  ASSERT_EQ(summary(cut), "ragged_row@2001");
  EXPECT_TRUE(mentions(cut[0].text, "the last line is cut off: delete it"));
  CsvFile commas = good();
  for (auto& row : commas.rows) {
    std::replace(row[kPosition].begin(), row[kPosition].end(), '.', ',');
  }
  EXPECT_TRUE(mentions(findings(commas)[0].text, "with a decimal point, not a comma"));
}

TEST_F(RecordingFile, RejectsFlagsOtherThanZeroAndOne) {
  CsvFile file = good();
  file.add("swing", "0");
  file.rows[4].back() = "1";
  file.rows[5].back() = "2";
  file.rows[6].back() = "0.5";
  const auto found = findings(file);
  ASSERT_EQ(summary(found), "not_a_flag@7");
  EXPECT_TRUE(mentions(found[0].text, "lines 7 and 8, column swing: 2 values")) << found[0].text;
}

}  // namespace recording_test
}  // namespace farrier::diagnosis
