// Times of recordings: every way in which samples can be uneven, told apart.

#include "recording.hpp"

namespace farrier::diagnosis {
namespace recording_times_test {

constexpr std::size_t kTime = 0;

class RecordingTimes : public RecordingFile {
 protected:
  /// Findings of a recording whose sample i is taken at time_of(i), s.
  std::vector<Finding> findings_at(const std::function<double(double)>& time_of, std::size_t samples = 2000) const {
    CsvFile file{.names = {"time_s", "position_m", "force_N", "velocity_m_s"}, .rows = {}};
    for (std::size_t i = 0; i < samples; ++i) {
      file.rows.push_back({CsvFile::number(time_of(static_cast<double>(i))), "0.04", "1", "0"});
    }
    return findings(file);
  }
};

TEST_F(RecordingTimes, MayRunFromAnyStartAtAnyPeriodOfAController) {
  for (const double period : {20e-6, 0.001, 1.0 / 3000.0, 0.05}) {
    const auto samples = static_cast<std::size_t>(std::max(500.0, std::ceil(1.0 / period)));
    for (const double start : {-5.0, 0.0, 0.123, 1000.0}) {
      EXPECT_EQ(summary(findings_at([&](double i) { return start + i * period; }, samples)), "") << period;
    }
  }
}

TEST_F(RecordingTimes, MayStrayByTwoPercent) {
  EXPECT_EQ(summary(findings_at([](double i) { return 0.001 * i + 9e-6 * std::sin(2.0 * i); })), "");
}

TEST_F(RecordingTimes, MayJitterUpToALimit) {
  EXPECT_EQ(summary(findings_at([](double i) { return 0.001 * i + (i == 500 || i == 900 ? 1e-4 : 0.0); })), "");
  const NoiseStream stream(3, "times", "jitter");
  const auto jitter = [&](double share) {
    return findings_at([&](double i) { return 0.001 * (i + share * stream.uniform(static_cast<Tick>(i))); });
  };
  EXPECT_EQ(summary(jitter(0.3)), "");
  const auto found = jitter(0.8);
  ASSERT_EQ(found.size(), 1u) << summary(found);
  EXPECT_EQ(found[0].what, "uneven_sampling");
  EXPECT_TRUE(mentions(found[0].text, "more than 20 %, up to which samples are interpolated")) << found[0].text;
}

TEST_F(RecordingTimes, MayComeFromACoarseClock) {
  EXPECT_EQ(summary(findings_at([](double i) { return std::round(i / 3.0) * 0.001; }, 3500)), "");
}

TEST_F(RecordingTimes, MayHaveGapsAroundALongStretch) {
  EXPECT_EQ(summary(findings_at([](double i) { return 0.001 * i + (i >= 700 ? 0.01 : 0.0); })), "");
  const auto found = findings_at([](double i) { return 0.001 * i + 0.01 * std::floor(i / 700.0); });
  ASSERT_EQ(summary(found), "gap@702");
  EXPECT_EQ(found[0].text,
            "lines 702 and 1402, time: 2 gaps before, up to 0.011 s where samples are 0.001 s apart; "
            "keep the longest part without one, or record without loss");
}

TEST_F(RecordingTimes, MayRepeatAndGoBackByAFewRows) {
  EXPECT_EQ(summary(findings_at([](double i) { return 0.001 * (i == 800 ? 799 : i == 1200 ? 1195 : i); })), "");
  EXPECT_EQ(summary(findings_at([](double i) { return 0.001 * (i == 1200 ? 1100 : i); })),
            "time_backwards@1202 gap@1203");
}

TEST_F(RecordingTimes, NameARecordingThatBeginsAgain) {
  const auto found = findings_at([](double i) { return 0.001 * std::fmod(i, 1000.0); });
  ASSERT_EQ(summary(found), "time_backwards@1002");
  EXPECT_TRUE(mentions(found[0].text, "keep one recording of several")) << found[0].text;
}

TEST_F(RecordingTimes, ThatAllAreTheSameOrRunBackwardsAreNamed) {
  EXPECT_EQ(summary(findings_at([](double) { return 7.0; })), "duplicate_time@3");
  EXPECT_EQ(summary(findings_at([](double i) { return -0.001 * i; })), "time_backwards@3");
}

TEST_F(RecordingTimes, InAnotherUnitAreNamed) {
  const auto milli = findings_at([](double i) { return i; });
  ASSERT_EQ(summary(milli), "wrong_units@2");
  EXPECT_EQ(milli[0].text,
            "line 2, time: samples are 1 s apart, beyond 2e-05 to 0.05 s; this looks like milliseconds "
            "(or a count of samples): divide by 1000");
  const auto micro = findings_at([](double i) { return 1000.0 * i; });
  ASSERT_EQ(summary(micro), "wrong_units@2");
  EXPECT_TRUE(mentions(micro[0].text, "this looks like microseconds: divide by 1000000")) << micro[0].text;
  const auto nano = findings_at([](double i) { return 1e6 * i; });
  EXPECT_TRUE(mentions(nano.at(0).text, "this looks like nanoseconds")) << nano[0].text;
  const auto minutes = findings_at([](double i) { return 0.001 / 60.0 * i; });
  EXPECT_EQ(summary(minutes), "wrong_units@2");
}

TEST_F(RecordingTimes, AreLongEnough) {
  EXPECT_EQ(summary(findings_at([](double i) { return 0.001 * i; }, 1000)), "");
  const auto brief = findings_at([](double i) { return 0.001 * i; }, 900);
  ASSERT_EQ(summary(brief), "too_short@0");
  EXPECT_EQ(brief[0].text, "the file holds 900 samples over 0.9 s; record at least 500 samples and 1 s");
  EXPECT_EQ(summary(findings_at([](double i) { return 0.02 * i; }, 400)), "too_short@0");
  EXPECT_EQ(summary(findings("time_s,position_m,force_N\n")), "too_short@0");
  EXPECT_EQ(summary(findings("time_s,position_m,force_N\n1,2,3\n")), "too_short@0");
}

TEST_F(RecordingTimes, AreFoundWrongTogetherWithCells) {
  CsvFile file = CsvFile::of(TestBench{}.recording());
  file.rows[10][kTime] = "x";
  file.rows[20][3] = "";
  file.rows.erase(file.rows.begin() + 100, file.rows.begin() + 200);
  std::swap(file.rows[500], file.rows[501]);
  EXPECT_EQ(summary(findings(file)), "not_a_number@12 empty_cell@22 gap@102 time_backwards@503");
}

}  // namespace recording_times_test
}  // namespace farrier::diagnosis
