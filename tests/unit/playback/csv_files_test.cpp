#include "tools/playback/csv_files.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <sstream>

#include "tests/support/random_recording.hpp"
#include "tests/support/scratch_directory.hpp"

namespace farrier::playback {
namespace csv_files_test {

/// Three random samples of every topic, their texts ended.
void write_recording(const std::string& path) {
  const mcap::Text facts{{"robot", "hyq"}, {"configuration", "a: 1\nb: \"x\"\n"}};
  test::write_random_recording(path, facts, {5}, 3, [](auto& signal) {
    if constexpr (requires { signal.text; }) {
      signals::assign(signal.text, "lf_kfe: \"stale\", then\nsilent");
    }
    if constexpr (requires { signal.name; }) {
      signals::assign(signal.name, "joint_node lf");
    }
  });
}

std::string bytes_of(const std::string& path) {
  std::ostringstream bytes;
  bytes << std::ifstream(path, std::ios::binary).rdbuf();
  return bytes.str();
}

TEST(RecordingCsv, ThereAndBackIsTheSameFile) {
  const test::ScratchDirectory scratch;
  write_recording(scratch.file("run.mcap"));
  const auto there = to_csv(scratch.file("run.mcap"), scratch.file("csv"));
  ASSERT_TRUE(there.ok()) << there.error().message;
  EXPECT_EQ(there.value().samples, 3 * bus::kTopicCount);
  EXPECT_EQ(there.value().ending, "");
  const auto back = from_csv(scratch.file("csv"), scratch.file("back.mcap"));
  ASSERT_TRUE(back.ok()) << back.error().message;
  EXPECT_EQ(back.value().samples, 3 * bus::kTopicCount);
  EXPECT_EQ(bytes_of(scratch.file("back.mcap")), bytes_of(scratch.file("run.mcap")));
}

TEST(RecordingCsv, HasAColumnForEveryNumber) {
  const test::ScratchDirectory scratch;
  write_recording(scratch.file("run.mcap"));
  ASSERT_TRUE(to_csv(scratch.file("run.mcap"), scratch.file("csv")).ok());
  std::ifstream file(scratch.file("csv/joint_model_estimate.csv"));
  std::string header;
  std::getline(file, header);
  EXPECT_TRUE(header.starts_with("index,log_time_ns,publish_time_ns,joint,tick,measurements,phase,a[0],a[1],"))
      << header;
}

TEST(RecordingCsv, RefusesAFolderWithFilesAndOneWithout) {
  const test::ScratchDirectory scratch;
  write_recording(scratch.file("run.mcap"));
  ASSERT_TRUE(to_csv(scratch.file("run.mcap"), scratch.file("csv")).ok());
  const auto again = to_csv(scratch.file("run.mcap"), scratch.file("csv"));
  ASSERT_FALSE(again.ok());
  EXPECT_NE(again.error().message.find("not empty"), std::string::npos);
  std::filesystem::create_directory(scratch.file("empty"));
  const auto nothing = from_csv(scratch.file("empty"), scratch.file("back.mcap"));
  ASSERT_FALSE(nothing.ok());
  EXPECT_NE(nothing.error().message.find("metadata.json"), std::string::npos);
  EXPECT_FALSE(std::filesystem::exists(scratch.file("back.mcap")));
}

TEST(RecordingCsv, LeavesNothingHalfWrittenWhenItIsStopped) {
  const test::ScratchDirectory scratch;
  write_recording(scratch.file("run.mcap"));
  const auto stop = [](double) { return false; };
  const auto there = to_csv(scratch.file("run.mcap"), scratch.file("csv"), stop);
  ASSERT_FALSE(there.ok());
  EXPECT_EQ(there.error().message, recording::kInterrupted);
  EXPECT_TRUE(std::filesystem::is_empty(scratch.file("csv")));
  ASSERT_TRUE(to_csv(scratch.file("run.mcap"), scratch.file("csv")).ok());
  const auto back = from_csv(scratch.file("csv"), scratch.file("back.mcap"), stop);
  ASSERT_FALSE(back.ok());
  EXPECT_EQ(back.error().message, recording::kInterrupted);
  EXPECT_FALSE(std::filesystem::exists(scratch.file("back.mcap")));
}

TEST(RecordingCsv, NamesFileLineAndColumnOfWhatItCannotRead) {
  const test::ScratchDirectory scratch;
  write_recording(scratch.file("run.mcap"));
  ASSERT_TRUE(to_csv(scratch.file("run.mcap"), scratch.file("csv")).ok());
  const std::string path = scratch.file("csv/clock_tick.csv");
  std::string text = bytes_of(path);
  const std::size_t last_row = text.rfind('\n', text.size() - 2) + 1;
  const std::size_t clock = text.find(',', text.find(',', text.find(',', last_row) + 1) + 1) + 1;
  text.replace(clock, 1, "x");
  std::ofstream(path, std::ios::binary) << text;
  const auto back = from_csv(scratch.file("csv"), scratch.file("back.mcap"));
  ASSERT_FALSE(back.ok());
  EXPECT_NE(back.error().message.find("clock_tick.csv:4: column 4: 'x"), std::string::npos) << back.error().message;
  EXPECT_FALSE(std::filesystem::exists(scratch.file("back.mcap")));
}

}  // namespace csv_files_test
}  // namespace farrier::playback
