// Outputs that cannot be written, files that are there already, and signals at any time.

#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/resource.h>
#include <unistd.h>

#include <csignal>
#include <filesystem>
#include <fstream>
#include <thread>

#include "tests/system/farrier_command.hpp"
#include "tests/cases/any_mcap.hpp"

namespace farrier::test {
namespace outputs_test {

using namespace std::chrono_literals;
using Arguments = std::vector<std::string>;

constexpr const char* kDomain = "96";  // of no run

void write_recording(const std::string& path, Tick ticks) {
  AnyMcap file = ordinary_file(leg(), bench_samples(leg(), ticks, kBegin_ns), Packing::kZstd);
  file.put_data_end();
  file.put_footer();
  file.save(path);
}

Surroundings with_output(const char* path) {
  return {FARRIER_COMMAND, [path] { ::dup2(::open(path, O_WRONLY), STDOUT_FILENO); }};
}
Surroundings with_closed_pipe() {
  return {FARRIER_COMMAND, [] {
            int ends[2];
            if (::pipe(ends) == 0) {
              ::close(ends[0]);
              ::dup2(ends[1], STDOUT_FILENO);
            }
          }};
}
Surroundings with_closed_output() {
  return {FARRIER_COMMAND, [] { ::close(STDOUT_FILENO); }};
}
/// No file may have more bytes, as on a disk that is full.
Surroundings with_small_disk(rlim_t bytes) {
  return {FARRIER_COMMAND, [bytes] {
            const rlimit limit{bytes, bytes};
            ::setrlimit(RLIMIT_FSIZE, &limit);
          }};
}

class Outputs : public testing::Test {
 protected:
  bool said(const std::string& text) const { return output_.find(text) != std::string::npos; }

  const ScratchDirectory scratch_;
  const std::string path_ = scratch_.file("run.mcap");
  std::string output_;
};

TEST_F(Outputs, ThatCannotBeWrittenAreErrorsWithTheReason) {
  write_recording(path_, 1000);
  const std::vector<Arguments> commands{{"--help"},
                                        {"--version"},
                                        {"info", "--help"},
                                        {"info", path_},
                                        {"info", path_, "--json"},
                                        {"identify", path_},
                                        {"replay", path_, "--speed", "1000", "--domain", kDomain}};
  for (const Arguments& command : commands) {
    EXPECT_EQ(run_farrier(command, &output_, with_output("/dev/full")), 1) << command.front();
    EXPECT_TRUE(said("cannot write standard output: No space left on device")) << command.front() << output_;
  }
  for (const Arguments& command : {commands[0], commands[4], commands[5]}) {
    EXPECT_EQ(run_farrier(command, &output_, with_closed_pipe()), 1) << command.front();
    EXPECT_TRUE(said("cannot write standard output: Broken pipe")) << command.front() << output_;
    EXPECT_EQ(run_farrier(command, &output_, with_closed_output()), 1) << command.front();
    EXPECT_TRUE(said("cannot write standard output: Bad file descriptor")) << command.front() << output_;
  }
}

TEST_F(Outputs, OnAFullDiskAreErrorsAndLeaveNothingThatPassesForWhole) {
  write_recording(path_, 3000);
  constexpr rlim_t kSmall = 50'000;
  EXPECT_EQ(run_farrier({"convert", path_, scratch_.file("csv")}, &output_, with_small_disk(kSmall)), 1) << output_;
  EXPECT_TRUE(said("cannot write")) << output_;
  EXPECT_TRUE(std::filesystem::is_empty(scratch_.file("csv")));
  EXPECT_EQ(run_farrier({"identify", path_, "--csv", scratch_.file("e.csv")}, &output_, with_small_disk(kSmall)), 1)
      << output_;
  EXPECT_TRUE(said("cannot write")) << output_;
  EXPECT_FALSE(std::filesystem::exists(scratch_.file("e.csv")));
  ASSERT_EQ(run_farrier({"convert", path_, scratch_.file("whole")}, &output_), 0) << output_;
  EXPECT_EQ(
      run_farrier({"convert", scratch_.file("whole"), scratch_.file("back.mcap")}, &output_, with_small_disk(kSmall)),
      1)
      << output_;
  EXPECT_TRUE(said("cannot write")) << output_;
  EXPECT_FALSE(std::filesystem::exists(scratch_.file("back.mcap")));
}

TEST_F(Outputs, ThatAreThereAreNotReplaced) {
  std::ofstream(path_) << "the only recording of its kind";
  EXPECT_EQ(run_farrier({"record", path_, "--domain", kDomain}, &output_), 2);
  EXPECT_TRUE(said("is there already: give another file, or --force")) << output_;
  EXPECT_EQ(read_file(path_), "the only recording of its kind");
  std::ofstream(scratch_.file("killed.mcap.part")) << "what was left of it";
  EXPECT_EQ(run_farrier({"record", scratch_.file("killed.mcap"), "--domain", kDomain}, &output_), 2);
  EXPECT_TRUE(said("killed.mcap.part is there")) << output_;
  EXPECT_EQ(read_file(scratch_.file("killed.mcap.part")), "what was left of it");
  write_recording(scratch_.file("good.mcap"), 100);
  ASSERT_EQ(run_farrier({"convert", scratch_.file("good.mcap"), scratch_.file("csv")}, &output_), 0) << output_;
  EXPECT_EQ(run_farrier({"convert", scratch_.file("csv"), path_}, &output_), 2);
  EXPECT_TRUE(said("is there already")) << output_;
  EXPECT_EQ(read_file(path_), "the only recording of its kind");
}

TEST_F(Outputs, AreOfOneRecorder) {
  FarrierCommand first({"record", path_, "--domain", kDomain});
  ASSERT_TRUE(first.says("Ctrl-C ends it", 20s)) << first.output();
  EXPECT_EQ(run_farrier({"record", path_, "--domain", kDomain}, &output_), 2);
  EXPECT_EQ(run_farrier({"record", path_, "--domain", kDomain, "--force"}, &output_), 2);
  EXPECT_TRUE(said("another program writes")) << output_;
  first.signal(SIGHUP);
  EXPECT_NE(first.wait(5s), -1);
  EXPECT_TRUE(std::filesystem::exists(path_)) << "a recorder that ends at SIGHUP closes its file";
  EXPECT_EQ(run_farrier({"info", path_}, &output_), 0) << output_;
}

TEST_F(Outputs, EndWithinASecondOfASignalInTheMiddleOfALargeChunk) {
  // One chunk of 200 MB, which alone takes a while.
  const std::vector<PlacedSample> samples = bench_samples(leg(), 1, kBegin_ns);
  AnyMcap file = ordinary_file(leg(), {}, Packing::kNone);
  file.put(channel_of(samples.front().topic, 1));
  while (file.chunk().size() < 200'000'000) {
    file.put(1, samples.front());
  }
  file.close_chunk(Packing::kZstdWithoutSize);
  file.put_data_end();
  file.put_footer();
  file.save(path_);
  for (const int signal : {SIGINT, SIGTERM, SIGHUP}) {
    for (const Arguments& command : {Arguments{"info", path_},
                                     {"convert", path_, scratch_.file("csv")},
                                     {"identify", path_},
                                     {"diagnose", path_, "--joint", "fc1d"},
                                     {"monitor", "--open", path_, "--web", "0"}}) {
      FarrierCommand running(command);
      std::this_thread::sleep_for(100ms);
      running.signal(signal);
      EXPECT_EQ(running.wait(1s), 128 + signal) << command.front();
    }
  }
}

}  // namespace outputs_test
}  // namespace farrier::test
