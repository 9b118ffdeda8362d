#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

#include <array>
#include <chrono>
#include <thread>

#include "sim_bridge/trace_thread.hpp"
#include "tests/support/scratch_directory.hpp"

namespace farrier::sim_bridge {
namespace trace_thread_test {

using namespace std::chrono_literals;

const std::vector<std::string> kJoints{"lf_haa", "lf_hfe"};

trace::TraceRow row_of(Tick tick, std::uint16_t joint) {
  trace::TraceRow row;
  row.tick = tick;
  row.joint = joint;
  return row;
}

TEST(TraceThread, WritesEveryRowInTheirOrder) {
  const test::ScratchDirectory scratch;
  TraceThread trace(trace::TraceWriter::create(scratch.file("trace.csv"), kJoints).value());
  for (Tick tick = 0; tick < 100; ++tick) {
    trace.write(row_of(tick, 0));
    trace.write(row_of(tick, 1));
  }
  EXPECT_FALSE(trace.finished()) << "more may come";
  trace.end();
  while (!trace.finished()) {
    std::this_thread::sleep_for(1ms);
  }
  EXPECT_TRUE(trace.complete());
  const auto rows = trace::read_trace(scratch.file("trace.csv"), kJoints);
  ASSERT_TRUE(rows.ok()) << rows.error().message;
  ASSERT_EQ(rows.value().size(), 200u);
  for (std::size_t i = 0; i < rows.value().size(); ++i) {
    EXPECT_EQ(rows.value()[i].tick, i / 2);
    EXPECT_EQ(rows.value()[i].joint, i % 2);
  }
}

// A pipe that nobody reads stands for a disk that takes nothing.
TEST(TraceThread, LosesRowsRatherThanWaitForADisk) {
  const test::ScratchDirectory scratch;
  const std::string path = scratch.file("trace.csv");
  ASSERT_EQ(::mkfifo(path.c_str(), 0600), 0);
  const int reader = ::open(path.c_str(), O_RDONLY | O_NONBLOCK | O_CLOEXEC);
  ASSERT_GE(reader, 0);
  TraceThread trace(trace::TraceWriter::create(path, kJoints).value());
  for (Tick tick = 0; tick < 100000; ++tick) {
    trace.write(row_of(tick, 0));
  }
  trace.end();
  for (std::array<char, 4096> read_away; !trace.finished();) {
    if (::read(reader, read_away.data(), read_away.size()) <= 0) {
      std::this_thread::sleep_for(1ms);
    }
  }
  EXPECT_FALSE(trace.complete());
  ::close(reader);
}

}  // namespace trace_thread_test
}  // namespace farrier::sim_bridge
