// Recordings in scaled units are read, or refused with the line and the remedy.

#include <gtest/gtest.h>

#include <cstdio>
#include <filesystem>

#include "scaled.hpp"

namespace farrier::diagnosis {
namespace scaled_recording_test {

class ScaledRecordingFile : public ::testing::Test {
 protected:
  ~ScaledRecordingFile() override { std::filesystem::remove(path_); }

  template <class Row>
  Result<ScaledRecording, RecordingProblems> read(Row row) {
    testing::write(path_, recording_, row);
    return read_scaled_recording(path_);
  }
  /// The one finding of a file whose line `at` is another.
  Finding refused(std::size_t at, const std::string& line) {
    const auto read = this->read([&](std::size_t k, const std::string& whole) { return k == at ? line : whole; });
    EXPECT_FALSE(read.ok());
    if (read.ok() || read.error().findings.empty()) {
      return {};
    }
    EXPECT_EQ(read.error().findings.size(), 1u) << to_string(read.error().findings, path_);
    return read.error().findings.front();
  }

  ScaledRecording recording_ = testing::arm([](double opening) { return opening; });
  const std::string path_ = (std::filesystem::temp_directory_path() /
                             ("farrier_scaled_" + std::to_string(::testing::UnitTest::GetInstance()->random_seed()) +
                              ::testing::UnitTest::GetInstance()->current_test_info()->name() + ".csv"))
                                .string();
};

TEST_F(ScaledRecordingFile, IsReadAndOtherColumnsAreNamed) {
  const auto read = this->read([](std::size_t, const std::string& line) { return line; });
  ASSERT_TRUE(read.ok());
  ASSERT_EQ(read.value().valve.size(), recording_.valve.size());
  EXPECT_NEAR(read.value().valve[700], recording_.valve[700], 1e-6);
  EXPECT_NEAR(read.value().position[700], recording_.position[700], 1e-6);
  ASSERT_EQ(read.value().remarks.size(), 1u);
  EXPECT_NE(read.value().remarks[0].find("pressure"), std::string::npos);
}

TEST_F(ScaledRecordingFile, MayBeginWithAnyNumber) {
  EXPECT_TRUE(read([](std::size_t k, const std::string& line) {
                return std::to_string(k + 17) + line.substr(line.find(','));
              }).ok());
}

TEST_F(ScaledRecordingFile, IsRefusedForASampleThatIsMissing) {
  const Finding finding = refused(300, "");
  EXPECT_EQ(finding.what, "missing_sample");
  EXPECT_EQ(finding.row, 302u) << finding.text;
}

TEST_F(ScaledRecordingFile, IsRefusedForASampleThatIsThereTwice) {
  const auto read = this->read([](std::size_t k, const std::string& line) {
    return k == 300 ? line + "\n" + line : line;
  });
  ASSERT_FALSE(read.ok());
  EXPECT_EQ(read.error().findings[0].what, "duplicate_sample");
  EXPECT_EQ(read.error().findings[0].row, 303u);
}

TEST_F(ScaledRecordingFile, IsRefusedForSamplesThatGoBack) {
  const auto read = this->read([](std::size_t k, const std::string& line) {
    return k < 600 ? line : std::to_string(k - 600) + line.substr(line.find(','));
  });
  ASSERT_FALSE(read.ok());
  EXPECT_EQ(read.error().findings[0].what, "sample_backwards");
  EXPECT_EQ(read.error().findings[0].row, 602u);
}

TEST_F(ScaledRecordingFile, IsRefusedForTimesInPlaceOfNumbers) {
  const auto read = this->read([](std::size_t k, const std::string& line) {
    return std::to_string(1e-3 * static_cast<double>(k)) + line.substr(line.find(','));
  });
  ASSERT_FALSE(read.ok());
  EXPECT_EQ(read.error().findings[0].what, "not_whole");
  EXPECT_NE(read.error().findings[0].text.find("--model"), std::string::npos);
}

TEST_F(ScaledRecordingFile, IsRefusedForMissingOrInvalidValues) {
  EXPECT_EQ(refused(10, "10,nan,0.5,0.1").what, "nan");
  EXPECT_EQ(refused(10, "10,0.1,inf,0.1").what, "nan");
  EXPECT_EQ(refused(10, "10,,0.5,0.1").what, "empty_cell");
  EXPECT_EQ(refused(10, "10,open,0.5,0.1").what, "not_a_number");
  EXPECT_EQ(refused(10, "10,0.1,0.5").what, "ragged_row");
  EXPECT_EQ(refused(10, "10,nan,0.5,0.1").row, 12u);
}

TEST_F(ScaledRecordingFile, IsRefusedForAValveThatNeverMoves) {
  std::ranges::fill(recording_.valve, 0.25);
  const Finding finding = refused(0, "0,0.25,0.5,0.1");
  EXPECT_EQ(finding.what, "constant");
  EXPECT_NE(finding.text.find("column valve is 0.25"), std::string::npos) << finding.text;
}

TEST_F(ScaledRecordingFile, IsRefusedForAPositionThatRestsInOneHalf) {
  std::fill(recording_.position.begin() + 512, recording_.position.end(), 0.25);
  const auto read = this->read([](std::size_t, const std::string& line) { return line; });
  ASSERT_FALSE(read.ok());
  EXPECT_EQ(read.error().findings[0].what, "constant");
  EXPECT_EQ(read.error().findings[0].row, 514u);
  EXPECT_NE(read.error().findings[0].text.find("position is constant over the second half"), std::string::npos);
}

TEST_F(ScaledRecordingFile, IsRefusedForValuesFarFromTheOrderOfOne) {
  EXPECT_EQ(refused(10, "10,0.1,-1e7,0.1").what, "out_of_range");
  EXPECT_EQ(refused(10, "10,1e300,0.5,0.1").what, "out_of_range");
}

TEST_F(ScaledRecordingFile, IsRefusedWhenItIsTooShort) {
  const auto read = this->read([](std::size_t k, const std::string& line) { return k < 400 ? line : std::string(); });
  ASSERT_FALSE(read.ok());
  EXPECT_EQ(read.error().findings[0].what, "too_short");
  EXPECT_NE(read.error().findings[0].text.find("400 samples"), std::string::npos);
}

TEST_F(ScaledRecordingFile, IsRefusedWithoutItsColumns) {
  std::ofstream(path_) << "sample,position\n0,0.5\n";
  const auto read = read_scaled_recording(path_);
  ASSERT_FALSE(read.ok());
  EXPECT_EQ(read.error().findings.back().what, "missing_column");
  EXPECT_NE(read.error().findings.back().text.find("column valve"), std::string::npos);
  EXPECT_EQ(read_scaled_recording(path_ + ".not").error().findings[0].what, "unreadable");
}

}  // namespace scaled_recording_test
}  // namespace farrier::diagnosis
