// Cyclone's timed waits where the computer's wall clock is set back while they last.

#include <dds/dds.h>
#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <cstdint>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <future>
#include <string>
#include <thread>

#include "bus_cyclone/cyclone_waits.hpp"

namespace farrier::bus_cyclone {
namespace {

using namespace std::chrono_literals;

constexpr const char* kClockFile = "FARRIER_WALL_CLOCK";
constexpr std::chrono::nanoseconds kHourBack = -1h;
constexpr std::chrono::milliseconds kWait = 300ms;

void set_wall_clock(const std::string& file, std::chrono::nanoseconds ahead) {
  const std::int64_t offset_ns = ahead.count();
  std::ofstream(file, std::ios::binary | std::ios::app);  // made if it is not there, and never shorter: it is mapped
  std::fstream(file, std::ios::binary | std::ios::in | std::ios::out).write(reinterpret_cast<const char*>(&offset_ns), sizeof offset_ns);
}

/// This test again, with the library that stands for a wall clock.
int again_with_a_wall_clock(const std::string& file) {
  const std::string self = std::filesystem::read_symlink("/proc/self/exe");
  const std::string test = testing::UnitTest::GetInstance()->current_test_info()->name();
  const std::string command = "LD_PRELOAD='" FARRIER_WALL_CLOCK_LIBRARY "' " + std::string(kClockFile) + "='" + file +
                              "' timeout 20 '" + self + "' --gtest_filter='*" + test + "'";
  return std::system(command.c_str());
}

TEST(CycloneWaits, EndInTimeThoughTheWallClockIsSetBack) {
  wait_on_steady_clock();
  const char* const file = std::getenv(kClockFile);
  if (file == nullptr) {
    const std::string own = testing::TempDir() + "wall_clock_" + std::to_string(::getpid());
    set_wall_clock(own, 0ns);
    EXPECT_EQ(again_with_a_wall_clock(own), 0);
    std::filesystem::remove(own);
    return;
  }
  const dds_entity_t participant = dds_create_participant(20 + ::getpid() % 80, nullptr, nullptr);
  ASSERT_GT(participant, 0);
  const dds_entity_t waitset = dds_create_waitset(participant);
  ASSERT_EQ(dds_waitset_attach(waitset, dds_create_guardcondition(participant), 0), DDS_RETCODE_OK);
  const dds_time_t before = dds_time();
  const auto begun = std::chrono::steady_clock::now();
  auto ended = std::async(std::launch::async, [&] { return dds_waitset_wait(waitset, nullptr, 0, DDS_MSECS(kWait.count())); });
  std::this_thread::sleep_for(100ms);
  set_wall_clock(file, kHourBack);
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

}  // namespace
}  // namespace farrier::bus_cyclone
