// Logs as other programs write them: each is read with what was done to it said, or refused with the nearest right form.

#include <functional>
#include <sstream>

#include "tests/unit/diagnosis/recording.hpp"

namespace farrier::diagnosis {
namespace csv_cases {

constexpr std::size_t kTime = 0, kCurrent = 1, kPosition = 2, kVelocity = 3, kForce = 4;

const Recording& made() {
  static const Recording recording = TestBench{.samples = 3000}.recording();
  return recording;
}
CsvFile good() { return CsvFile::of(made()); }

class CsvCase : public RecordingFile {
 protected:
  /// The recording of a file that must be read; `remark` is a part of one of its remarks.
  Recording accepted(const std::string& text, const std::string& remark, const std::string& joint = "") const {
    std::ofstream(path_, std::ios::binary) << text;
    auto recording = read_recording(path_, joint);
    EXPECT_TRUE(recording.ok()) << (recording ? "" : to_string(recording.error().findings, path_));
    if (!recording) {
      return {};
    }
    std::string remarks;
    for (const std::string& said : recording.value().remarks) {
      remarks += said + "\n";
    }
    EXPECT_NE(remarks.find(remark), std::string::npos) << remarks;
    return std::move(recording).value();
  }

  std::string refused(const std::string& text, const std::string& joint = "") const {
    std::ofstream(path_, std::ios::binary) << text;
    const auto recording = read_recording(path_, joint);
    return recording ? "accepted" : to_string(recording.error().findings, "log");
  }

  /// good() with sample i taken at time_of(i), and measured there.
  static std::string sampled_at(const std::function<double(std::size_t)>& time_of, std::size_t samples = 3000) {
    CsvFile file{.names = good().names, .rows = {}};
    for (std::size_t i = 0; i < samples; ++i) {
      const double t = time_of(i);
      const double v = TestBench::velocity(stroke(), t);
      file.rows.push_back({CsvFile::number(t), CsvFile::number(0.01), CsvFile::number(truth(t)), CsvFile::number(v),
                           CsvFile::number(1000.0 * v)});
    }
    return file.text();
  }
  static double stroke() {
    static const double of_joint = TestBench{}.joint().actuator.stroke;
    return of_joint;
  }
  static double truth(double t) { return TestBench::position(stroke(), t); }

  static double largest_error(const Recording& recording) {
    double error = 0.0;
    for (std::size_t i = 0; i < recording.time_s.size(); ++i) {
      error = std::max(error, std::abs(recording.position[i] - truth(recording.time_s[i])));
    }
    return error;
  }
  static double largest_unevenness(const Recording& recording) {
    double off = 0.0;
    for (std::size_t i = 1; i < recording.time_s.size(); ++i) {
      off = std::max(off, std::abs((recording.time_s[i] - recording.time_s[i - 1]) / recording.period_s - 1.0));
    }
    return off;
  }
};

TEST_F(CsvCase, NamesWithUnitsAreReadInTheirUnits) {
  CsvFile file = good();
  file.names = {"time [ms]", "Valve current (mA)", "position [mm]", "vel [m/s]", "Force [kN]"};
  for (auto& row : file.rows) {
    const auto scaled = [&](std::size_t column, double factor) {
      row[column] = CsvFile::number(std::stod(row[column]) * factor);
    };
    scaled(kTime, 1e3);
    scaled(kCurrent, 1e3);
    scaled(kPosition, 1e3);
    scaled(kForce, 1e-3);
  }
  const Recording recording = accepted(file.text(), "Column 'position [mm]' is read as position_m, times 0.001.");
  ASSERT_EQ(recording.position.size(), made().position.size());
  for (std::size_t i = 0; i < made().position.size(); ++i) {
    EXPECT_NEAR(recording.time_s[i], made().time_s[i], 1e-9);
    EXPECT_NEAR(recording.position[i], made().position[i], 1e-12);
    EXPECT_NEAR(recording.force[i], made().force[i], 1e-9);
    EXPECT_NEAR(recording.valve_current_A[i], made().valve_current_A[i], 1e-12);
  }
}

TEST_F(CsvCase, NanosecondsOfATimeOfDayAreRead) {
  CsvFile file = good();
  file.names[kTime] = "timestamp_ns";
  for (std::size_t i = 0; i < file.rows.size(); ++i) {
    file.rows[i][kTime] = std::to_string(1'700'000'000'000'000'000 + 1'000'000 * static_cast<long long>(i));
  }
  EXPECT_NEAR(accepted(file.text(), "read as time_s").period_s, 1e-3, 1e-9);
}

TEST_F(CsvCase, ARowOfUnitsIsTakenIntoTheNames) {
  std::string text = good().text();
  text.replace(0, text.find('\n') + 1, "Time,Current,Position,Velocity,Force\ns,A,m,m/s,N\n");
  EXPECT_EQ(accepted(text, "Column 'Position [m]' is read as position_m.").position, made().position);
}

TEST_F(CsvCase, NamesWithoutUnitsAreRefusedWithTheNearest) {
  std::string text = good().text();
  text.replace(0, text.find('\n'), "Time,Current,Position,Velocity,Force");
  EXPECT_EQ(
      refused(text),
      "log:1: line 1 names no column of a recording; begin with their names, such as time_s; perhaps time_s for "
      "'Time', valve_current_A for 'Current', position_m for 'Position', velocity_m_s for 'Velocity', force_N for "
      "'Force'\n");
  std::string one = good().text();
  one.replace(0, one.find('\n'), "time_s,valve_current_A,pos,velocity_m_s,force_N");
  EXPECT_EQ(refused(one), "log:1: line 1, column position_m is missing; 'pos' may be meant: give it that name\n");
}

TEST_F(CsvCase, SemicolonsAndDecimalCommasAreRead) {
  std::string text = good().text();
  std::ranges::replace(text, ',', ';');
  std::ranges::replace(text, '.', ',');
  const Recording recording = accepted(text, "Columns are separated by ';'.");
  EXPECT_EQ(recording.position, made().position);
  EXPECT_EQ(recording.time_s, made().time_s);
  std::string tabs = good().text();
  std::ranges::replace(tabs, ',', '\t');
  EXPECT_EQ(accepted(tabs, "Columns are separated by tabs.").position, made().position);
}

TEST_F(CsvCase, DecimalCommasBetweenCommasAreRefusedWithTheRemedy) {
  std::string text = good().text();
  const std::size_t rows = text.find('\n');
  std::replace(text.begin() + static_cast<std::ptrdiff_t>(rows), text.end(), '.', ',');
  EXPECT_NE(refused(text).find("write numbers with a decimal point, not a comma, or separate the columns with ';'"),
            std::string::npos)
      << refused(text);
}

TEST_F(CsvCase, LinesBeforeTheHeaderArePassedOver) {
  const std::string preamble = "\xEF\xBB\xBF% Logger 3.1\r\n// rig: fc1d\r\nStarted, 2026-11-29 12:03\r\nsep=,\r\n\r\n";
  const Recording recording = accepted(preamble + good().text("\r\n"), "The names of the columns are in line 6");
  EXPECT_EQ(recording.position, made().position);
  EXPECT_EQ(recording.line.front(), 7u);
}

TEST_F(CsvCase, ATrailingCommaIsHarmless) {
  std::string everywhere, below, above;
  std::istringstream lines(good().text());
  for (std::string line; std::getline(lines, line);) {
    everywhere += line + ",\n";
    below += line + (below.empty() ? "\n" : ",\n");
    above += line + (above.empty() ? ",\n" : "\n");
  }
  EXPECT_EQ(accepted(everywhere, "A column without a name is not read").position, made().position);
  EXPECT_EQ(accepted(below, "Rows end with a separator").position, made().position);
  EXPECT_EQ(accepted(above, "A column without a name is not read").position, made().position);
}

TEST_F(CsvCase, OneOfSeveralJointsIsReadByItsColumns) {
  CsvFile file = good();
  for (auto& name : file.names) {
    name = name == "time_s" ? name : "lf_kfe." + name;
  }
  file.add("lf_hfe.position_m", "0.01");
  file.add("lf_hfe.force_N", "1");
  EXPECT_EQ(accepted(file.text(), "Column 'lf_kfe.position_m' is read as position_m", "lf_kfe").position,
            made().position);
  EXPECT_EQ(accepted(file.text(), "", "lf_hfe").position, std::vector<double>(3000, 0.01));
  EXPECT_NE(
      refused(file.text(), "rf_kfe").find("columns of lf_kfe, lf_hfe, and none of rf_kfe; give --joint one of them"),
      std::string::npos)
      << refused(file.text(), "rf_kfe");
}

TEST_F(CsvCase, OneOfSeveralJointsIsReadByItsRows) {
  std::string text;
  std::istringstream lines(good().text());
  for (std::string line; std::getline(lines, line);) {
    text += text.empty() ? "joint," + line + "\n" : "lf_kfe," + line + "\nlf_hfe," + line + "\n";
  }
  EXPECT_EQ(accepted(text, "Rows of joint lf_kfe are read, not those of lf_hfe.", "lf_kfe").position, made().position);
  EXPECT_NE(refused(text, "rf_kfe").find("no rows of joint rf_kfe; it has lf_kfe, lf_hfe"), std::string::npos);
}

TEST_F(CsvCase, JitterIsInterpolatedWithItsErrorSaid) {
  const NoiseStream stream(7, "csv", "jitter");
  for (const double jitter : {0.01, 0.1}) {
    const std::string text = sampled_at(
        [&](std::size_t i) { return 1e-3 * (static_cast<double>(i) + jitter * stream.normal(static_cast<Tick>(i))); });
    const Recording recording = accepted(text, "the samples are interpolated to even times");
    EXPECT_NEAR(recording.period_s, 1e-3, 1e-6);
    EXPECT_LT(largest_unevenness(recording), 1e-6);
    EXPECT_GT(recording.position_error, 0.0);
    EXPECT_LT(largest_error(recording), 10.0 * recording.position_error) << jitter;
    EXPECT_LT(largest_error(recording), 1e-7) << "a tenth of the noise of HyQ's encoders";
  }
}

TEST_F(CsvCase, JitterOfTheStampsAloneLeavesTheValues) {
  const NoiseStream stream(8, "csv", "stamps");
  CsvFile file = CsvFile::of(TestBench{.samples = 3000, .noise = false}.recording());
  const std::vector<std::vector<std::string>> rows = file.rows;
  for (std::size_t i = 0; i < file.rows.size(); ++i) {
    const double off = 0.1 * stream.uniform(static_cast<Tick>(i));
    file.rows[i][kTime] = CsvFile::number(1e-3 * (static_cast<double>(i) + off));
  }
  const Recording recording = accepted(file.text(), "the stamps stray and not the samples");
  EXPECT_EQ(CsvFile::number(recording.position[1234]), rows[1234][kPosition]);
  EXPECT_EQ(recording.position_error, 0.0);
  EXPECT_NEAR(recording.period_s, 1e-3, 1e-6);
}

TEST_F(CsvCase, MoreJitterIsRefusedWithTheLimit) {
  const NoiseStream stream(9, "csv", "large jitter");
  const std::string text = sampled_at(
      [&](std::size_t i) { return 1e-3 * (static_cast<double>(i) + 0.6 * stream.uniform(static_cast<Tick>(i))); });
  EXPECT_NE(refused(text).find("(RMS), more than 20 %, up to which samples are interpolated"), std::string::npos)
      << refused(text);
}

TEST_F(CsvCase, AFewLostSamplesAreFilled) {
  const std::string text = sampled_at(
      [](std::size_t i) { return 1e-3 * static_cast<double>(i + (i >= 700 ? 2 : 0) + (i >= 1500 ? 1 : 0)); });
  const Recording recording = accepted(text, "3 samples missing in 2 places: filled by interpolation.");
  EXPECT_EQ(recording.time_s.size(), 3003u);
  EXPECT_LT(largest_error(recording), 1e-6);
}

TEST_F(CsvCase, OfADropOutTheLongestStretchIsTaken) {
  const std::string text =
      sampled_at([](std::size_t i) { return 1e-3 * static_cast<double>(i) + (i < 900 ? 0.0 : 0.5); });
  const Recording recording =
      accepted(text, "Samples are missing in 1 place, for up to 0.501 s: of 3000 samples the 2100 from line 902 on");
  EXPECT_EQ(recording.time_s.size(), 2100u);
  EXPECT_LT(largest_error(recording), 1e-9);
}

TEST_F(CsvCase, RepeatedRowsAreLeftOut) {
  CsvFile file = good();
  for (const std::size_t row : {200, 900, 901}) {
    file.rows.insert(file.rows.begin() + static_cast<std::ptrdiff_t>(row), file.rows[row]);
  }
  EXPECT_EQ(accepted(file.text(), "3 rows repeated with the same time and values: left out.").position,
            made().position);
}

TEST_F(CsvCase, MergedStampsAreTakenForEvenSamples) {
  for (const std::size_t group : {2, 8}) {
    CsvFile file = good();
    for (std::size_t i = 0; i < file.rows.size(); ++i) {
      const std::size_t stamped = i - i % group;
      file.rows[i][kTime] = CsvFile::number(1e-3 * static_cast<double>(stamped));
    }
    const Recording recording =
        accepted(file.text(), "Up to " + std::to_string(group) + " rows in a row have one time");
    EXPECT_EQ(recording.position, made().position);
    EXPECT_NEAR(recording.period_s, 1e-3, 1e-6);
  }
}

TEST_F(CsvCase, AFewRowsOutOfOrderAreSorted) {
  CsvFile file = good();
  std::swap(file.rows[400], file.rows[401]);
  std::swap(file.rows[1400], file.rows[1402]);
  EXPECT_EQ(accepted(file.text(), "the rows are sorted by their times").position, made().position);
}

TEST_F(CsvCase, TwoRecordingsInOneFileAreRefused) {
  CsvFile file = good();
  const auto rows = file.rows;
  file.rows.insert(file.rows.end(), rows.begin(), rows.end());
  EXPECT_NE(refused(file.text()).find("keep one recording of several"), std::string::npos) << refused(file.text());
}

}  // namespace csv_cases
}  // namespace farrier::diagnosis
