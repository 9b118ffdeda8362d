// Cyclone's timed waits where the computer's wall clock is set back while they last.

#include <dds/dds.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <chrono>
#include <cstdlib>
#include <filesystem>
#include <future>
#include <string>
#include <thread>

#include "bus_cyclone/cyclone_waits.hpp"
#include "tests/support/scratch_directory.hpp"
#include "cli/processes/host_clock.hpp"

namespace farrier::bus_cyclone {
namespace cyclone_waits_test {

using namespace std::chrono_literals;

constexpr int kHour_s = 3600;
constexpr std::chrono::milliseconds kWait = 300ms;

/// This test again, on a computer whose wall clock is `clock`.
int again_with(const cli::HostClock& clock) {
  const std::string self = std::filesystem::read_symlink("/proc/self/exe");
  const std::string test = testing::UnitTest::GetInstance()->current_test_info()->name();
  std::string command = "env";
  for (const std::string& variable : clock.environment()) {
    command += " '" + variable + "'";
  }
  return std::system((command + " timeout 20 '" + self + "' --gtest_filter='*" + test + "'").c_str());
}

TEST(CycloneWaits, EndInTimeThoughTheWallClockIsSetBack) {
  wait_on_steady_clock();
  const char* const file = std::getenv("FARRIER_WALL_CLOCK");
  const test::ScratchDirectory scratch;
  if (file == nullptr) {
    const auto clock = cli::HostClock::create(FARRIER_EXECUTABLES, scratch.file("clock"));
    ASSERT_TRUE(clock.ok()) << clock.error().message;
    EXPECT_EQ(again_with(clock.value()), 0);
    return;
  }
  const auto clock = cli::HostClock::create(FARRIER_EXECUTABLES, file);
  ASSERT_TRUE(clock.ok()) << clock.error().message;
  const dds_entity_t participant = dds_create_participant(20 + ::getpid() % 80, nullptr, nullptr);
  ASSERT_GT(participant, 0);
  const dds_entity_t waitset = dds_create_waitset(participant);
  ASSERT_EQ(dds_waitset_attach(waitset, dds_create_guardcondition(participant), 0), DDS_RETCODE_OK);
  const dds_time_t before = dds_time();
  const auto begun = std::chrono::steady_clock::now();
  auto ended = std::async(std::launch::async, [waitset] {
    return dds_waitset_wait(waitset, nullptr, 0, DDS_MSECS(kWait.count()));
  });
  std::this_thread::sleep_for(100ms);
  ASSERT_TRUE(clock.value().set(-kHour_s).ok());
  EXPECT_LT(dds_time(), before) << "the wall clock was not set";
  const bool in_time = ended.wait_for(5s) == std::future_status::ready;
  EXPECT_TRUE(in_time);
  if (!in_time) {
    std::_Exit(1);  // what waits for an hour cannot be joined
  }
  EXPECT_EQ(ended.get(), 0) << "nothing was to wake it but time";
  EXPECT_GE(std::chrono::steady_clock::now() - begun, kWait);
  dds_delete(participant);
}

}  // namespace cyclone_waits_test
}  // namespace farrier::bus_cyclone
