// Every command that reads a recording, on files of other writers, with damage, and of clocks that were set.

#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/wait.h>

#include <csignal>
#include <filesystem>
#include <fstream>
#include <thread>

#include "tests/system/farrier_command.hpp"
#include "recording/recording_file.hpp"
#include "report/figures/recording_facts.hpp"
#include "tests/cases/any_mcap.hpp"

namespace farrier::test {
namespace recording_commands_test {

using namespace std::chrono_literals;
using nlohmann::json;

constexpr std::uint64_t kAfterStart_ns = 5'000'000'000;
constexpr rlim_t kMostMemory_bytes = 3'000'000'000;
constexpr const char* kDomain = "97";  // of no run

const std::string& joint() { return leg().joints.front().name; }

void put_end(AnyMcap& file) {
  file.put_data_end();
  file.put_footer();
}

/// The file of another writer: foreign topics, an empty chunk, large parts, and what the run was behind everything.
AnyMcap foreign_form(const std::vector<PlacedSample>& samples) {
  AnyMcap file;
  file.close_chunk(Packing::kZstdWithoutSize);
  file.put(mcap::Channel{.id = 900, .topic = "/tf", .message_encoding = "cdr"});
  for (const bus::TopicSpec& topic : bus::topics()) {
    file.put(channel_of(topic.id, static_cast<std::uint16_t>(topic.id)));
  }
  for (std::size_t i = 0; i < samples.size(); ++i) {
    file.put(static_cast<std::uint16_t>(samples[i].topic), samples[i]);
    file.put(mcap::Message{.channel_id = 900, .log_time_ns = samples[i].log_time_ns, .data = {}});
    if (i % 200 == 0) {
      file.close_chunk(i % 400 == 0 ? Packing::kZstdFrames : Packing::kLz4);
    }
  }
  file.close_chunk(Packing::kZstdWithoutSize);
  file.put_attachment(6'000'000'000);
  file.put_metadata({recording::kRunFacts, report::recording_facts(leg())});
  put_end(file);
  return file;
}

class RecordingCommands : public testing::Test {
 protected:
  static Surroundings with_little_memory() {
    return {FARRIER_COMMAND, [] {
              const rlimit limit{kMostMemory_bytes, kMostMemory_bytes};
              ::setrlimit(RLIMIT_AS, &limit);
            }};
  }
  int run(const std::vector<std::string>& arguments) { return run_farrier(arguments, &output_, with_little_memory()); }
  bool said(const std::string& text) const { return output_.find(text) != std::string::npos; }

  /// Opens the page of a recording; true when it is served.
  void expect_page(const std::string& remark) {
    FarrierCommand page({"monitor", "--open", path_, "--web", "0"}, with_little_memory());
    EXPECT_TRUE(page.says("http://", 20s)) << page.output();
    EXPECT_NE(page.output().find(remark), std::string::npos) << page.output();
    page.signal(SIGHUP);
    EXPECT_EQ(page.wait(5s), 128 + SIGHUP);
  }

  const ScratchDirectory scratch_;
  const std::string path_ = scratch_.file("run.mcap");
  std::string output_;
};

TEST_F(RecordingCommands, ReadTheFileOfAnotherWriter) {
  constexpr Tick kTicks = 3000;
  foreign_form(bench_samples(leg(), kTicks, kBegin_ns)).save(path_);
  ASSERT_EQ(run({"info", path_, "--json"}), 0) << output_;
  const json info = json::parse(output_);
  EXPECT_EQ(info.at("topics").at("joint/measurement").at("samples"), kTicks);
  EXPECT_EQ(info.at("foreign").at("/tf").at("encoding"), "cdr");
  EXPECT_EQ(run({"info", path_}), 0) << output_;
  EXPECT_TRUE(said("/tf")) << output_;
  EXPECT_EQ(run({"convert", path_, scratch_.file("csv")}), 0) << output_;
  EXPECT_TRUE(said(std::to_string(kTicks + kTicks / 20) + " samples")) << output_;
  EXPECT_EQ(run({"identify", path_}), 0) << output_;
  EXPECT_TRUE(said(joint())) << output_;
  EXPECT_NE(run({"diagnose", path_, "--joint", joint()}), 2) << output_;
  EXPECT_FALSE(said("does not say of which robot")) << output_;
  EXPECT_EQ(run({"replay", path_, "--speed", "100", "--domain", kDomain}), 0) << output_;
  EXPECT_TRUE(said("samples published")) << output_;
  expect_page("");
}

TEST_F(RecordingCommands, CountAndNameADamagedSampleAndUseTheRest) {
  std::vector<PlacedSample> samples = bench_samples(leg(), 3000, kBegin_ns);
  for (PlacedSample& sample : samples) {
    if (sample.topic == bus::TopicId::kJointMeasurement && sample.sequence == 2500) {
      sample.cdr.resize(20);
    }
  }
  AnyMcap file = ordinary_file(leg(), samples, Packing::kZstd);
  put_end(file);
  file.save(path_);
  const std::string named = "1 sample is damaged and left out: joint/measurement with sequence 2500, of 20 bytes";
  for (const std::vector<std::string>& command :
       std::vector<std::vector<std::string>>{{"info", path_},
                                             {"convert", path_, scratch_.file("csv")},
                                             {"identify", path_},
                                             {"replay", path_, "--speed", "100", "--domain", kDomain}}) {
    EXPECT_EQ(run(command), 1) << command.front();
    EXPECT_TRUE(said(named)) << command.front() << ": " << output_;
  }
  EXPECT_TRUE(std::filesystem::exists(scratch_.file("csv/joint_measurement.csv")));
  run({"diagnose", path_, "--joint", joint()});
  EXPECT_TRUE(said("1 sample is damaged")) << output_;
  run({"replay", path_, "--rerun", "estimator"});
  EXPECT_TRUE(said("1 sample is damaged")) << output_;
  expect_page(named);
}

TEST_F(RecordingCommands, SayOfAForeignFileThatNothingInItIsFarriers) {
  AnyMcap file;
  file.put(mcap::Schema{.id = 1, .name = "std_msgs/msg/String", .encoding = "ros2msg", .data = "string data"});
  file.put(mcap::Channel{.id = 0, .schema_id = 1, .topic = "/chatter", .message_encoding = "cdr"});
  file.put(mcap::Message{.channel_id = 0, .data = {}});
  file.close_chunk(Packing::kZstd);
  put_end(file);
  file.save(path_);
  for (const std::vector<std::string>& command :
       std::vector<std::vector<std::string>>{{"info", path_},
                                             {"convert", path_, scratch_.file("csv")},
                                             {"identify", path_},
                                             {"diagnose", path_, "--joint", joint()},
                                             {"replay", path_, "--domain", kDomain},
                                             {"replay", path_, "--rerun", "estimator"},
                                             {"monitor", "--open", path_, "--web", "0"}}) {
    EXPECT_EQ(run(command), 2) << command.front();
    EXPECT_TRUE(said("nothing of Farrier in it: it holds 1 message of /chatter (std_msgs/msg/String, cdr)"))
        << command.front() << ": " << output_;
  }
}

TEST_F(RecordingCommands, GoOnWhereTheClockWasSet) {
  std::vector<PlacedSample> samples = bench_samples(leg(), 3000, kAfterStart_ns);
  for (PlacedSample& sample : samples) {
    sample.log_time_ns += sample.sequence >= 1500 ? kBegin_ns : 0;
  }
  AnyMcap file = ordinary_file(leg(), samples, Packing::kZstd);
  put_end(file);
  file.save(path_);
  const std::string step = "the clock of day goes from 1970-01-01T00:00:06Z to 2023-11-14T22:13:26Z, by +1.7e+09 s";
  EXPECT_EQ(run({"info", path_}), 0) << output_;
  EXPECT_TRUE(said(step)) << output_;
  ASSERT_EQ(run({"info", path_, "--json"}), 0) << output_;
  const json info = json::parse(output_.substr(output_.find('{'), output_.rfind('}') - output_.find('{') + 1));
  EXPECT_NEAR(info.at("duration_s").get<double>(), 3.0, 0.1);
  EXPECT_EQ(info.at("clock_steps").size(), 1u);
  FarrierCommand replay({"replay", path_, "--domain", kDomain});
  EXPECT_EQ(replay.wait(20s), 0);
  EXPECT_NE(replay.output().find(step), std::string::npos) << replay.output();
  EXPECT_NE(replay.output().find("3150 samples published"), std::string::npos) << replay.output();
  expect_page(step);
}

}  // namespace recording_commands_test
}  // namespace farrier::test
