// A process in no hurry receives what arrives within some milliseconds at one wake-up.

#include <gtest/gtest.h>
#include <unistd.h>

#include <chrono>
#include <filesystem>
#include <fstream>
#include <string>
#include <thread>

#include "bus_cyclone/cyclone_bus.hpp"
#include "bus_cyclone/cyclone_reception.hpp"

namespace farrier::bus_cyclone {
namespace cyclone_reception_test {

using namespace std::chrono_literals;

constexpr auto kBetween = 250us;
constexpr std::uint16_t kSamples = 800;
constexpr auto kBudget = 10s;

bus::NetworkOptions own_network(bool unhurried) {
  bus::NetworkOptions options;
  options.domain = 20 + ::getpid() % 80;
  options.unhurried = unhurried;
  return options;
}

bus::EndpointSpec endpoint() {
  return {bus::TopicId::kClockTick, {bus::Reliability::kReliable, bus::Durability::kVolatile, kSamples}, {"robot"}};
}

/// Number of times that threads of this process that receive unicast datagrams have gone to sleep.
long sleeps_of_receivers() {
  long sleeps = 0;
  for (const auto& thread : std::filesystem::directory_iterator("/proc/self/task")) {
    std::string name;
    std::getline(std::ifstream(thread.path() / "comm") >> std::ws, name);
    std::ifstream status(thread.path() / "status");
    for (std::string word; name == "recvUC" && status >> word;) {
      if (long count = 0; word == "voluntary_ctxt_switches:" && status >> count) {
        sleeps += count;
      }
    }
  }
  return sleeps;
}

TEST(CycloneReception, OfAProcessInNoHurryGathersSamples) {
  const auto writing = create_cyclone_bus(own_network(false));
  const auto reading = create_cyclone_bus(own_network(true));
  ASSERT_TRUE(writing.ok() && reading.ok());
  auto publisher = bus::Publisher<signals::ClockTick>::create(*writing.value(), endpoint());
  auto subscription = bus::Subscription<signals::ClockTick>::create(*reading.value(), endpoint());
  ASSERT_TRUE(publisher.ok() && subscription.ok());
  const auto end = std::chrono::steady_clock::now() + kBudget;
  const auto waits = [end] {
    std::this_thread::sleep_for(1ms);
    return std::chrono::steady_clock::now() < end;
  };
  while (publisher.value().matched_readers() == 0 && waits()) {
  }
  const long before = sleeps_of_receivers();
  const auto begun = std::chrono::steady_clock::now();
  for (int i = 0; i < kSamples; ++i) {
    publisher.value().publish({.tick = i});
    std::this_thread::sleep_for(kBetween);
  }
  int heard = 0;
  while (heard < kSamples && waits()) {
    subscription.value().drain([&heard](const signals::ClockTick&) { ++heard; });
  }
  const auto lasted = std::chrono::steady_clock::now() - begun;
  EXPECT_EQ(heard, kSamples);
  // Both buses receive in this process: samples on the one, acknowledgements on the other.
  EXPECT_LE(sleeps_of_receivers() - before, 4 * (lasted / kGatheringTime) + 40);
}

}  // namespace cyclone_reception_test
}  // namespace farrier::bus_cyclone
