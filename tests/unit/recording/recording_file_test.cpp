#include "recording/recording_file.hpp"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <filesystem>
#include <thread>

#include "recording/background_writer.hpp"
#include "recording/loss_count.hpp"
#include "signals/cdr.hpp"
#include "tests/support/scratch_directory.hpp"

namespace farrier::recording {
namespace recording_file_test {

using bus::TopicId;

class RunFile : public testing::Test {
 protected:
  RunFileWriter create() {
    auto writer = RunFileWriter::create(path_, {{"robot", "hyq"}});
    EXPECT_TRUE(writer.ok());
    return std::move(writer).value();
  }

  /// A measurement at a tick, valid until the next.
  Sample measurement(Tick tick) {
    signals::to_cdr(signals::JointMeasurement{.joint = 3, .tick = tick, .force_N_or_Nm = 0.5 * static_cast<double>(tick)},
                    cdr_);
    return {.topic = TopicId::kJointMeasurement,
            .sequence = static_cast<std::uint32_t>(tick),
            .log_time_ns = 2000 + static_cast<std::uint64_t>(tick),
            .publish_time_ns = 1000 + static_cast<std::uint64_t>(tick),
            .cdr = cdr_};
  }

  /// Returns the ending that the reader states. Reading must give no sample.
  std::string ending_without_samples() const {
    auto reader = RunFileReader::open(path_);
    EXPECT_TRUE(reader.ok());
    Sample sample;
    EXPECT_FALSE(reader.value().next(sample));
    return reader.value().ending();
  }

  const test::ScratchDirectory scratch_;
  const std::string path_ = scratch_.file("run.mcap");
  std::vector<std::uint8_t> cdr_;
};

std::size_t index(TopicId topic) { return static_cast<std::size_t>(topic); }

TEST_F(RunFile, KeepsSamplesFactsAndWhatWasLost) {
  BackgroundWriter writer(create());
  for (Tick tick = 0; tick < 5000; ++tick) {
    ASSERT_TRUE(writer.offer(measurement(tick)));
  }
  TopicCounts lost{};
  lost[index(TopicId::kJointMeasurement)] = 7;
  ASSERT_TRUE(writer.finish(lost).ok());

  auto reader = RunFileReader::open(path_);
  ASSERT_TRUE(reader.ok()) << reader.error().message;
  Tick tick = 0;
  for (Sample sample; reader.value().next(sample); ++tick) {
    ASSERT_EQ(sample.topic, TopicId::kJointMeasurement);
    EXPECT_EQ(sample.log_time_ns, 2000u + static_cast<std::uint64_t>(tick));
    EXPECT_EQ(sample.publish_time_ns, 1000u + static_cast<std::uint64_t>(tick));
    signals::JointMeasurement measurement;
    ASSERT_TRUE(signals::from_cdr(sample.cdr, measurement));
    EXPECT_EQ(measurement.tick, tick);
    EXPECT_EQ(measurement.force_N_or_Nm, 0.5 * static_cast<double>(tick));
  }
  EXPECT_EQ(tick, 5000);
  EXPECT_EQ(reader.value().ending(), "");
  EXPECT_EQ(reader.value().metadata(kRunFacts).at("robot"), "hyq");
  EXPECT_EQ(reader.value().metadata(kLosses).at("joint/measurement"), "7");
  EXPECT_EQ(reader.value().metadata(kLosses).at("joint/sensors"), "0");
}

TEST_F(RunFile, CarriesTheIdlOfEveryTopic) {
  ASSERT_TRUE(create().finish({}).ok());
  auto file = mcap::Reader::open(path_);
  ASSERT_TRUE(file.ok());
  mcap::Message message;
  EXPECT_FALSE(file.value().next(message));
  EXPECT_EQ(file.value().channels().size(), bus::kTopicCount);
  for (const auto& [id, channel] : file.value().channels()) {
    const mcap::Schema& schema = file.value().schemas().at(channel.schema_id);
    EXPECT_EQ(schema.encoding, "omgidl");
    EXPECT_NE(schema.data.find("struct " + schema.name.substr(std::string("wire::").size()) + " {"), std::string::npos)
        << schema.data;
  }
}

TEST_F(RunFile, WithoutItsEndIsReadableUpToWhatWasWritten) {
  {
    BackgroundWriter writer(create());
    for (Tick tick = 0; tick < 100; ++tick) {
      writer.offer(measurement(tick));
    }
  }  // never finished
  EXPECT_FALSE(std::filesystem::exists(path_)) << "a file has its name once it is whole";
  auto reader = RunFileReader::open(path_while_written(path_));
  ASSERT_TRUE(reader.ok());
  int samples = 0;
  for (Sample sample; reader.value().next(sample);) {
    ++samples;
  }
  EXPECT_EQ(samples, 100);
  EXPECT_NE(reader.value().ending(), "");
  EXPECT_TRUE(reader.value().metadata(kLosses).empty());
}

TEST_F(RunFile, TakesTheNameOfAnEarlierOneWhenItIsWhole) {
  ASSERT_TRUE(create().finish({}).ok());
  RunFileWriter later = create();
  later.write(measurement(1));
  later.flush();
  EXPECT_EQ(ending_without_samples(), "") << "until then the earlier one is there";
  ASSERT_TRUE(later.finish({}).ok());
  EXPECT_FALSE(std::filesystem::exists(path_while_written(path_)));
  auto reader = RunFileReader::open(path_);
  ASSERT_TRUE(reader.ok());
  Sample sample;
  EXPECT_TRUE(reader.value().next(sample));
}

// A pipe that no process empties takes 64 KiB and then nothing, like a stalled disk.
TEST_F(RunFile, AStalledDiskCostsSamplesAndNeverTime) {
  ASSERT_EQ(::mkfifo(path_.c_str(), 0600), 0);
  const int reading = ::open(path_.c_str(), O_RDONLY | O_NONBLOCK);
  ASSERT_GE(reading, 0);
  constexpr Tick kOffered = 20000;
  constexpr std::size_t kMostWaiting = 100'000;
  BackgroundWriter writer(create(), kMostWaiting);
  Tick taken = 0;
  for (Tick tick = 0; tick < kOffered; ++tick) {
    taken += writer.offer(measurement(tick)) ? 1 : 0;
  }
  const std::uint64_t dropped = writer.dropped()[index(TopicId::kJointMeasurement)];
  EXPECT_GT(dropped, 0u);
  EXPECT_EQ(dropped + static_cast<std::uint64_t>(taken), static_cast<std::uint64_t>(kOffered));
  std::thread emptying([&] {  // so that it can end
    std::array<char, 65536> bytes;
    for (int empty = 0; empty < 100;) {
      const ssize_t count = ::read(reading, bytes.data(), bytes.size());
      empty = count > 0 ? 0 : empty + 1;
      std::this_thread::sleep_for(std::chrono::milliseconds(count > 0 ? 0 : 5));
    }
  });
  EXPECT_TRUE(writer.finish({}).ok());
  emptying.join();
  ::close(reading);
}

TEST(RunFileOnAFullDisk, SaysSoAndCountsWhatIsLost) {
  auto file = RunFileWriter::create("/dev/full", {});
  ASSERT_TRUE(file.ok());
  BackgroundWriter writer(std::move(file).value());
  std::vector<std::uint8_t> cdr;
  signals::to_cdr(signals::ClockTick{.tick = 1}, cdr);
  const Sample sample{.topic = TopicId::kClockTick, .cdr = cdr};
  EXPECT_NE(writer.failure(), "");  // its facts already did not fit
  EXPECT_FALSE(writer.offer(sample));
  EXPECT_EQ(writer.dropped()[index(TopicId::kClockTick)], 1u);
  const auto finished = writer.finish({});
  ASSERT_FALSE(finished.ok());
  EXPECT_NE(finished.error().message.find("/dev/full"), std::string::npos);
}

TEST_F(RunFile, OfAnotherVersionIsRefusedByNameAndNumber) {
  auto file = mcap::Writer::create(path_, "farrier", "farrier");
  ASSERT_TRUE(file.ok());
  const std::uint16_t channel = file.value().add_channel(
      {.topic = "joint/sensors", .message_encoding = "cdr", .metadata = {{"version", "999"}}});
  file.value().write(mcap::Message{.channel_id = channel, .data = {}});
  ASSERT_TRUE(file.value().finish().ok());
  EXPECT_NE(ending_without_samples().find("joint/sensors is of version 999"), std::string::npos);
}

TEST_F(RunFile, OfAnotherProgramHasNoSamples) {
  auto file = mcap::Writer::create(path_, "", "rosbag");
  ASSERT_TRUE(file.ok());
  const std::uint16_t channel = file.value().add_channel({.topic = "/tf", .message_encoding = "cdr"});
  file.value().write(mcap::Message{.channel_id = channel, .data = {}});
  ASSERT_TRUE(file.value().finish().ok());
  EXPECT_EQ(ending_without_samples(), "");
}

TEST_F(RunFile, TellsHowMuchOfItIsReadAndStopsWhenTold) {
  constexpr Tick kTicks = 100'000;
  {
    RunFileWriter writer = create();
    for (Tick tick = 0; tick < kTicks; ++tick) {
      writer.write(measurement(tick));
    }
    ASSERT_TRUE(writer.finish({}).ok());
  }
  const auto samples_until = [this](double stop, std::vector<double>& shares) {
    auto reader = RunFileReader::open(path_).value();
    reader.ask([&](double share) {
      shares.push_back(share);
      return share < stop;
    });
    Tick samples = 0;
    for (Sample sample; reader.next(sample);) {
      ++samples;
    }
    EXPECT_EQ(reader.ending(), samples == kTicks ? "" : kInterrupted);
    return samples;
  };
  std::vector<double> shares;
  EXPECT_EQ(samples_until(2.0, shares), kTicks);
  ASSERT_GT(shares.size(), 3u);
  EXPECT_TRUE(std::ranges::is_sorted(shares));
  EXPECT_GT(shares.front(), 0.0);
  EXPECT_GT(shares.back(), 0.9);
  EXPECT_LE(shares.back(), 1.0);
  std::vector<double> fewer;
  EXPECT_LT(samples_until(0.5, fewer), kTicks);
  EXPECT_LT(fewer.size(), shares.size());
}

TEST(LossCount, IsOfGapsPerKeyAndNotOfANewBeginning) {
  LossCount<signals::JointSensors> losses;
  for (const Tick tick : {10, 11, 14, 15}) {  // two are missing
    losses.heard({.joint = 1, .tick = tick});
  }
  losses.heard({.joint = 2, .tick = 100});
  losses.heard({.joint = 2, .tick = 102});  // one more
  losses.heard({.joint = 2, .tick = 0});    // another run
  losses.heard({.joint = 2, .tick = 1});
  losses.heard({.joint = 2});               // a probe
  EXPECT_EQ(losses.lost(), 3u);
}

}  // namespace recording_file_test
}  // namespace farrier::recording
