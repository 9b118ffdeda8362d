// Files of any writer, as the one reader of recordings gives them.

#include <gtest/gtest.h>

#include <fstream>

#include "recording/recording_file.hpp"
#include "report/figures/recording_facts.hpp"
#include "tests/cases/any_mcap.hpp"
#include "tests/support/scratch_directory.hpp"

namespace farrier::test {
namespace mcap_forms_test {

constexpr std::uint64_t kLarge = 3'000'000'000;  // bytes
constexpr std::uint16_t kMeasurement = static_cast<std::uint16_t>(bus::TopicId::kJointMeasurement);
constexpr std::uint16_t kForeign = 500;

/// Sequence numbers of the measurements in a file, and the reader that has come to its end.
struct Read {
  std::vector<std::uint32_t> ticks;
  std::string ending;
  std::string nothing;
  std::uint64_t damaged = 0, foreign = 0;
  recording::Timeline timeline;
  std::uint64_t elapsed_ns = 0;
};

class McapForms : public testing::Test {
 protected:
  McapForms() {
    every_tick_.resize(kTicks);
    for (std::uint32_t i = 0; i < kTicks; ++i) {
      every_tick_[i] = i;
    }
  }

  Read read(const AnyMcap& file) const {
    file.save(path_);
    auto reader = recording::RunFileReader::open(path_);
    EXPECT_TRUE(reader.ok());
    Read read;
    for (recording::Sample sample; reader.value().next(sample);) {
      if (sample.topic == bus::TopicId::kJointMeasurement) {
        read.ticks.push_back(sample.sequence);
      }
      EXPECT_GE(sample.elapsed_ns, read.elapsed_ns);
      read.elapsed_ns = sample.elapsed_ns;
    }
    read.ending = reader.value().ending();
    read.nothing = reader.value().nothing_of_farrier();
    read.damaged = reader.value().damaged_samples();
    for (const auto& [name, topic] : reader.value().foreign()) {
      read.foreign += topic.messages;
    }
    read.timeline = reader.value().timeline();
    return read;
  }
  void ends(AnyMcap& file) const {
    file.put_data_end();
    file.put_footer();
  }
  void expect_all(const AnyMcap& file) const {
    const Read all = read(file);
    EXPECT_EQ(all.ticks, every_tick_);
    EXPECT_EQ(all.ending, "");
  }
  std::vector<std::uint32_t> ticks(std::uint32_t from, std::uint32_t to) const {
    return {every_tick_.begin() + from, every_tick_.begin() + to};
  }

  static constexpr Tick kTicks = 1000;
  const ScratchDirectory scratch_;
  const std::string path_ = scratch_.file("file.mcap");
  const robot::Robot robot_ = leg();
  const std::vector<PlacedSample> samples_ = bench_samples(robot_, kTicks, kBegin_ns);
  std::vector<std::uint32_t> every_tick_;
};

TEST_F(McapForms, AreReadInEveryCompression) {
  for (const Packing packing :
       {Packing::kNone, Packing::kZstd, Packing::kZstdWithoutSize, Packing::kZstdFrames, Packing::kLz4}) {
    SCOPED_TRACE(static_cast<int>(packing));
    AnyMcap file = ordinary_file(robot_, samples_, packing);
    ends(file);
    expect_all(file);
  }
}

TEST_F(McapForms, MayHaveEmptyChunksAnywhere) {
  AnyMcap file;
  const auto put_empty_chunks = [&] {
    for (const Packing packing : {Packing::kNone, Packing::kZstd, Packing::kZstdWithoutSize, Packing::kLz4}) {
      file.close_chunk(packing);
    }
  };
  put_empty_chunks();
  file.put(channel_of(bus::TopicId::kJointMeasurement, kMeasurement));
  for (const PlacedSample& sample : samples_) {
    if (sample.topic == bus::TopicId::kJointMeasurement) {
      file.put(kMeasurement, sample);
    }
    if (sample.sequence == kTicks / 2) {
      file.close_chunk(Packing::kZstd);
      put_empty_chunks();
    }
  }
  file.close_chunk(Packing::kZstd);
  put_empty_chunks();
  ends(file);
  expect_all(file);
}

TEST_F(McapForms, MayHaveNoChunksAndNoDataEnd) {
  AnyMcap file;
  file.put(channel_of(bus::TopicId::kJointMeasurement, kMeasurement));
  for (const PlacedSample& sample : samples_) {
    if (sample.topic == bus::TopicId::kJointMeasurement) {
      file.put(kMeasurement, sample);
      file.close_loose();
    }
  }
  file.put_footer();
  expect_all(file);
}

TEST_F(McapForms, MayDefineAChannelAgain) {
  AnyMcap file;
  for (const PlacedSample& sample : samples_) {
    // The id of the measurements becomes that of another topic, and that of another program, in every chunk.
    if (sample.topic == bus::TopicId::kJointMeasurement) {
      file.put(channel_of(bus::TopicId::kJointMeasurement, 1));
      file.put(1, sample);
      file.put(mcap::Channel{.id = 1, .topic = "/tf", .message_encoding = "ros1"});
      file.put(1, sample);
    } else {
      file.put(channel_of(sample.topic, 1));
      file.put(1, sample);
    }
    file.close_chunk(Packing::kZstd);
  }
  ends(file);
  const Read all = read(file);
  EXPECT_EQ(all.ticks, every_tick_);
  EXPECT_EQ(all.ending, "");
  EXPECT_EQ(all.foreign, every_tick_.size());
}

TEST_F(McapForms, MayHaveLargeAttachmentsMetadataAndForeignMessagesWhichAreNotRead) {
  AnyMcap file = ordinary_file(robot_, {samples_.begin(), samples_.begin() + 500}, Packing::kZstd);
  file.put_attachment(kLarge);
  file.put_large_metadata(kLarge);
  file.put(mcap::Channel{.id = kForeign, .topic = "/camera", .message_encoding = "ros1"});
  file.close_loose();
  file.put_large_message(kForeign, kLarge);
  for (std::size_t i = 500; i < samples_.size(); ++i) {
    file.put(static_cast<std::uint16_t>(samples_[i].topic), samples_[i]);
  }
  file.close_chunk(Packing::kZstd);
  ends(file);
  expect_all(file);
  EXPECT_EQ(read(file).foreign, 1u);
}

TEST_F(McapForms, HaveTheirFactsAnywhere) {
  AnyMcap file;
  file.put(channel_of(bus::TopicId::kJointMeasurement, kMeasurement));
  file.put(kMeasurement, samples_.front());
  file.close_chunk(Packing::kZstd);
  file.put_attachment(kLarge);
  file.put_metadata({recording::kRunFacts, {{"robot", "someone"}}});
  ends(file);
  file.save(path_);
  const auto facts = mcap::find_metadata(path_, recording::kRunFacts);
  ASSERT_TRUE(facts.has_value());
  EXPECT_EQ(facts->values.at("robot"), "someone");
  EXPECT_FALSE(mcap::find_metadata(path_, "none").has_value());
}

TEST_F(McapForms, OfOtherProgramsAreNamedWithWhatTheyHold) {
  AnyMcap file;
  file.put(mcap::Schema{.id = 1, .name = "std_msgs/msg/String", .encoding = "ros2msg", .data = "string data"});
  file.put(mcap::Channel{.id = 0, .schema_id = 1, .topic = "/chatter", .message_encoding = "cdr"});
  for (std::uint32_t i = 0; i < 3; ++i) {
    file.put(mcap::Message{.channel_id = 0, .sequence = i, .log_time_ns = kBegin_ns, .data = {}});
  }
  file.close_chunk(Packing::kZstd);
  ends(file);
  const Read foreign = read(file);
  EXPECT_TRUE(foreign.ticks.empty());
  EXPECT_NE(foreign.nothing.find("nothing of Farrier"), std::string::npos) << foreign.nothing;
  EXPECT_NE(foreign.nothing.find("3 messages of /chatter (std_msgs/msg/String, cdr)"), std::string::npos)
      << foreign.nothing;
  AnyMcap both = ordinary_file(robot_, samples_, Packing::kZstd);
  both.put(mcap::Channel{.id = kForeign, .topic = "/chatter", .message_encoding = "cdr"});
  both.put(mcap::Message{.channel_id = kForeign, .sequence = 1, .data = {}});
  both.close_chunk(Packing::kZstd);
  ends(both);
  EXPECT_EQ(read(both).nothing, "");
}

TEST_F(McapForms, WithDamageAreReadBesidesIt) {
  AnyMcap file;
  file.put(channel_of(bus::TopicId::kJointMeasurement, kMeasurement));
  const auto put_ticks = [&](std::uint32_t from, std::uint32_t to) {
    for (const PlacedSample& sample : samples_) {
      if (sample.topic == bus::TopicId::kJointMeasurement && sample.sequence >= from && sample.sequence < to) {
        file.put(kMeasurement, sample);
      }
    }
  };
  put_ticks(0, 100);
  file.close_chunk(Packing::kZstd);
  put_ticks(100, 200);
  file.close_chunk(Packing::kZstd, 12345);  // a wrong CRC
  put_ticks(200, 300);
  file.chunk().number(static_cast<std::uint8_t>(mcap::Opcode::kMessage));
  file.chunk().number(std::uint64_t{1'000'000});  // the chunk ends in this message
  file.close_chunk(Packing::kZstdWithoutSize);
  file.put_large_chunk(kLarge);
  file.put(mcap::Message{.channel_id = 77, .data = {}});  // of a channel that is nowhere described
  put_ticks(300, kTicks);
  file.close_chunk(Packing::kNone);
  ends(file);
  const Read damaged = read(file);
  std::vector<std::uint32_t> rest = ticks(0, 100);
  const std::vector<std::uint32_t> behind = ticks(200, kTicks);
  rest.insert(rest.end(), behind.begin(), behind.end());
  EXPECT_EQ(damaged.ticks, rest);
  EXPECT_NE(damaged.ending.find("4 parts of the file are damaged and left out: first chunk 2: its CRC"),
            std::string::npos)
      << damaged.ending;
}

TEST_F(McapForms, WithDamagedSamplesAreReadBesidesThem) {
  std::vector<PlacedSample> samples = samples_;
  std::size_t cut = 0;
  std::vector<std::uint32_t> whole;
  for (PlacedSample& sample : samples) {
    if (sample.topic == bus::TopicId::kJointMeasurement) {
      if (sample.sequence % 100 == 50) {
        sample.cdr.resize(sample.cdr.size() - 4 * ++cut);
      } else {
        whole.push_back(sample.sequence);
      }
    }
  }
  AnyMcap file = ordinary_file(robot_, samples, Packing::kZstd);
  ends(file);
  const Read damaged = read(file);
  EXPECT_EQ(damaged.ticks, whole);
  EXPECT_EQ(damaged.damaged, cut);
  EXPECT_NE(damaged.ending.find("10 samples are damaged and left out: first joint/measurement with sequence 50"),
            std::string::npos)
      << damaged.ending;
}

TEST_F(McapForms, HaveAClockThatMayBeSet) {
  // From 1970 to 2023 and an hour back: the samples say a second in all.
  constexpr std::uint64_t kAfterStart_ns = 5'000'000'000;
  std::vector<PlacedSample> samples = bench_samples(robot_, kTicks, kAfterStart_ns);
  for (PlacedSample& sample : samples) {
    sample.log_time_ns += sample.sequence < 300 ? 0 : sample.sequence < 600 ? kBegin_ns : kBegin_ns - 3'600'000'000'000;
  }
  AnyMcap file = ordinary_file(robot_, samples, Packing::kZstd);
  ends(file);
  const Read stepped = read(file);
  EXPECT_EQ(stepped.ticks, every_tick_);
  EXPECT_EQ(stepped.ending, "");
  EXPECT_NEAR(static_cast<double>(stepped.elapsed_ns) * 1e-9, 1.0, 0.01);
  ASSERT_EQ(stepped.timeline.steps().size(), 2u);
  EXPECT_NEAR(stepped.timeline.steps()[0].by_s(), 1.7e9, 1.0);
  EXPECT_NEAR(static_cast<double>(stepped.timeline.steps()[0].at_ns) * 1e-9, 0.299, 0.01);
  EXPECT_NEAR(stepped.timeline.steps()[1].by_s(), -3600.0, 1.0);
  const std::string text = recording::to_string(stepped.timeline.steps()[0]);
  EXPECT_NE(text.find("from 1970-01-01T00:00:05Z to 2023-11-14T22:13:25Z"), std::string::npos) << text;
}

TEST_F(McapForms, MayHaveTheLargestTimesThereAre) {
  std::vector<PlacedSample> samples(samples_.begin(), samples_.begin() + 4);
  samples[0].log_time_ns = 0;
  samples[1].log_time_ns = ~std::uint64_t{0};
  samples[2].log_time_ns = 0;
  samples[3].log_time_ns = ~std::uint64_t{0} - 1;
  AnyMcap file = ordinary_file(robot_, samples, Packing::kZstd);
  ends(file);
  const Read extreme = read(file);
  EXPECT_EQ(extreme.timeline.step_count(), 3u);
  EXPECT_EQ(extreme.elapsed_ns, 0u);
  for (const recording::ClockStep& step : extreme.timeline.steps()) {
    EXPECT_FALSE(recording::to_string(step).empty());
  }
}

}  // namespace mcap_forms_test
}  // namespace farrier::test
