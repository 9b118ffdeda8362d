// Files nobody would write: whatever they hold, they are read or refused with a place.

#include <random>

#include "diagnosis/data/recording_check.hpp"
#include "diagnosis/data/trace_recording.hpp"
#include "recording.hpp"

namespace farrier::diagnosis {
namespace recording_fuzz_test {

constexpr std::uint32_t kSeed = 20140701;

class RecordingFuzz : public RecordingFile {
 protected:
  std::size_t below(std::size_t bound) { return bound == 0 ? 0 : random_() % bound; }

  void expect_place(const std::vector<Finding>& found, std::size_t lines, const std::string& text) {
    EXPECT_FALSE(found.empty()) << "refused without a reason, seed " << kSeed << "\n" << text;
    for (std::size_t i = 0; i < found.size(); ++i) {
      const Finding& finding = found[i];
      EXPECT_LE(finding.row, lines) << finding.text;
      EXPECT_TRUE(i == 0 || found[i - 1].row <= finding.row) << "not in the order of lines: " << summary(found);
      EXPECT_TRUE(finding.row == 0 ? mentions(finding.text, "the file")
                                   : mentions(finding.text, "line " + std::to_string(finding.row)) ||
                                         mentions(finding.text, "lines " + std::to_string(finding.row)))
          << finding.text;
      EXPECT_FALSE(finding.what.empty());
      for (const char c : finding.text) {
        EXPECT_TRUE(c >= ' ' && c <= '~') << "not printable: " << finding.text;
      }
    }
  }

  void expect_sound(const std::string& text) {
    const auto recording = read(text);
    const auto lines = static_cast<std::size_t>(std::count(text.begin(), text.end(), '\n')) + 1;
    if (!recording) {
      expect_place(recording.error().findings, lines, text);
      return;
    }
    ++accepted_;
    const Recording& r = recording.value();
    const std::size_t n = r.time_s.size();
    EXPECT_GE(n, kFewestSamples);
    EXPECT_TRUE(r.period_s >= 19e-6 && r.period_s <= 51e-3) << r.period_s;
    for (const auto* column : {&r.time_s, &r.position, &r.velocity, &r.force, &r.valve_current_A, &r.pressure_a_Pa,
                               &r.pressure_b_Pa, &r.supply_pressure_Pa}) {
      const bool needed = column == &r.time_s || column == &r.position || column == &r.velocity || column == &r.force;
      EXPECT_TRUE(column->size() == n || (column->empty() && !needed));
      EXPECT_TRUE(std::all_of(column->begin(), column->end(), [](double value) { return std::isfinite(value); }));
    }
    EXPECT_TRUE(r.swing.empty() || r.swing.size() == n);
    EXPECT_EQ(r.line.size(), n);
    for (const Finding& finding : check_recording(r, joint_)) {
      EXPECT_FALSE(finding.what.empty() || finding.text.empty());
      EXPECT_LE(finding.row, lines);
    }
  }

  std::mt19937 random_{kSeed};
  const robot::Joint joint_ = TestBench{}.joint();
  const std::string good_ = [] {
    CsvFile file = CsvFile::of(TestBench{.samples = 520, .period_s = 0.002}.recording());
    file.add("swing", "1");
    file.add("pressure_a_Pa", "8e6");
    return file.text();
  }();
  int accepted_ = 0;
};

TEST_F(RecordingFuzz, SurvivesRandomBytes) {
  for (int i = 0; i < 300; ++i) {
    std::string text(below(3000), '\0');
    for (char& c : text) {
      c = static_cast<char>(i % 2 == 0 ? below(256) : "0123456789.,\n-e\" "[below(17)]);
    }
    expect_sound(i % 3 == 0 ? "time_s,position_m,force_N\n" + text : text);
  }
  EXPECT_EQ(accepted_, 0);
}

TEST_F(RecordingFuzz, SurvivesChangedBytes) {
  const std::string alphabet = "0123456789.-+eE,;\"'# \t\r\nnaif_\x80\xff\x01" + std::string(1, '\0');
  for (int i = 0; i < 400; ++i) {
    std::string text = good_;
    // The header, where one byte changes most, as often as all the rest.
    const std::size_t reach = i % 2 == 0 ? 80 : text.size();
    for (std::size_t k = 0; k <= below(6); ++k) {
      const std::size_t at = below(reach);
      switch (below(3)) {
        case 0: text[at] = alphabet[below(alphabet.size())]; break;
        case 1: text.insert(at, 1, alphabet[below(alphabet.size())]); break;
        default: text.erase(at, 1 + below(5)); break;
      }
    }
    expect_sound(text);
  }
  EXPECT_GT(accepted_, 0) << "no mutation was harmless: the test does not reach the reader's far side";
}

TEST_F(RecordingFuzz, SurvivesRandomValues) {
  const std::vector<std::string> values = {"0",   "-1",  "1e308", "-1e308", "nan", "-inf", "1e-320", "",  "1e9",
                                           "0.5", "\"1", "\"\"",  "0x10",   "+1",  "+-1",  "1,2",    "-", "5e-324"};
  const CsvFile whole = CsvFile::of(TestBench{.samples = 520, .period_s = 0.002}.recording());
  for (int i = 0; i < 400; ++i) {
    CsvFile file = whole;
    // A whole column, or one cell.
    const std::size_t column = below(5);
    const std::string& value = values[below(values.size())];
    if (i % 2 == 0) {
      for (auto& row : file.rows) {
        row[column] = value;
      }
    } else {
      file.rows[below(file.rows.size())][column] = value;
    }
    expect_sound(file.text());
  }
  EXPECT_GT(accepted_, 0);
}

TEST_F(RecordingFuzz, SurvivesCutFiles) {
  for (int i = 0; i < 200; ++i) {
    expect_sound(good_.substr(0, below(good_.size())));
  }
}

TEST_F(RecordingFuzz, OfTracesNamesPlacesToo) {
  const robot::Robot robot = robot::load_shipped("hyq");
  std::string good = "tick,joint,position_m_or_rad,velocity_m_s_or_rad_s,force_N_or_Nm,pressure_a_Pa,pressure_b_Pa,"
                     "valve_current_A,actual_phase\n";
  for (int i = 0; i < 1100; ++i) {
    good += std::to_string(i) + ",lf_kfe,0.04,0,1,8e6,8e6,0," + std::to_string(i / 300 % 2) + "\n";
  }
  const std::string alphabet = "0123456789.-e,\"\nlfk_\xff";
  int accepted = 0;
  for (int i = 0; i < 300; ++i) {
    std::string text = good;
    text[below(i % 2 == 0 ? 120 : text.size())] = alphabet[below(alphabet.size())];
    std::ofstream(path_, std::ios::binary) << text;
    const auto recording = recording_of_trace(path_, robot, *robot.find("lf_kfe"));
    accepted += recording.ok() ? 1 : 0;
    if (!recording) {
      expect_place(recording.error().findings, 1200, "");
    }
  }
  EXPECT_GT(accepted, 0);
}

}  // namespace recording_fuzz_test
}  // namespace farrier::diagnosis
