// Cyclone's configuration and its refusals.

#include <gtest/gtest.h>
#include <unistd.h>

#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <string>

#include "bus_cyclone/cyclone_bus.hpp"

namespace farrier::bus_cyclone {
namespace cyclone_bus_test {

bus::NetworkOptions own_network() {
  bus::NetworkOptions options;
  options.domain = 20 + getpid() % 80;
  return options;
}

/// CYCLONEDDS_URI while in scope.
class UserConfiguration {
 public:
  explicit UserConfiguration(const char* text) { setenv("CYCLONEDDS_URI", text, 1); }
  ~UserConfiguration() { unsetenv("CYCLONEDDS_URI"); }
};

TEST(CycloneBus, RefusesADomainThatHasNoPorts) {
  bus::NetworkOptions options;
  options.domain = 233;
  const auto refused = create_cyclone_bus(options);
  ASSERT_FALSE(refused.ok());
  EXPECT_NE(refused.error().message.find("233"), std::string::npos) << refused.error().message;
}

TEST(CycloneBus, RefusesAnAddressThatIsNotThisComputers) {
  bus::NetworkOptions options = own_network();
  options.address = "192.0.2.1";  // RFC 5737: nobody's
  const auto refused = create_cyclone_bus(options);
  ASSERT_FALSE(refused.ok());
  EXPECT_NE(refused.error().message.find("192.0.2.1"), std::string::npos) << refused.error().message;
}

TEST(CycloneBus, RefusesOneProcessMoreThanThereMayBe) {
  bus::NetworkOptions options = own_network();
  options.max_processes = 2;
  const auto first = create_cyclone_bus(options);
  const auto second = create_cyclone_bus(options);
  ASSERT_TRUE(first.ok()) << first.error().message;
  ASSERT_TRUE(second.ok()) << second.error().message;
  EXPECT_FALSE(create_cyclone_bus(options).ok());
}

TEST(CycloneBus, ReadsTheUsersConfigurationAfterItsOwn) {
  const std::string log = testing::TempDir() + "cyclone_" + std::to_string(getpid()) + ".log";
  const UserConfiguration user(("<Domain Id=\"any\"><Tracing><Verbosity>config</Verbosity><OutputFile>" + log +
                                "</OutputFile></Tracing></Domain>")
                                   .c_str());
  EXPECT_TRUE(create_cyclone_bus(own_network()).ok());
  std::ifstream written(log);
  EXPECT_TRUE(written.good()) << log;
  std::remove(log.c_str());
}

TEST(CycloneBus, SetsAUsersPortsAside) {
  bus::NetworkOptions options = own_network();
  options.max_processes = 1;
  const auto first = create_cyclone_bus(options);
  ASSERT_TRUE(first.ok()) << first.error().message;
  const UserConfiguration user(
      "<Domain Id=\"any\"><Discovery><MaxAutoParticipantIndex>9</MaxAutoParticipantIndex></Discovery></Domain>");
  EXPECT_FALSE(create_cyclone_bus(options).ok());
}

TEST(CycloneBus, SetsAUsersConfigurationAsideThatCycloneRefuses) {
  const UserConfiguration user("<Domain Id=\"any\"><Threads><NoSuchElement/></Threads></Domain>");
  EXPECT_TRUE(create_cyclone_bus(own_network()).ok());
}

TEST(CycloneBus, RefusesAHistoryWithoutDepth) {
  auto bus = create_cyclone_bus(own_network());
  ASSERT_TRUE(bus.ok()) << bus.error().message;
  bus::Qos qos;
  qos.history_depth = 0;
  const auto refused = bus.value()->create_writer({bus::TopicId::kClockTick, qos, {}});
  ASSERT_FALSE(refused.ok());
  EXPECT_NE(refused.error().message.find("clock/tick"), std::string::npos) << refused.error().message;
}

}  // namespace cyclone_bus_test
}  // namespace farrier::bus_cyclone
