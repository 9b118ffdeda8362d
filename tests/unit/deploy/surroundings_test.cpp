#include <arpa/inet.h>
#include <fcntl.h>
#include <netinet/in.h>
#include <sys/file.h>
#include <sys/socket.h>
#include <unistd.h>

#include "files.hpp"
#include "tools/deploy/domain_ports.hpp"
#include "tools/deploy/surroundings.hpp"

namespace farrier::deploy {
namespace surroundings_test {

constexpr int kFirstOfDomain3 = 7400 + 3 * 250;
constexpr PortRange kUsual{32768, 60999};

/// A UDP socket on loopback; it lets go with the test.
class BoundPort {
 public:
  explicit BoundPort(int port) : socket_(::socket(AF_INET, SOCK_DGRAM, 0)) {
    sockaddr_in name{};
    name.sin_family = AF_INET;
    name.sin_port = htons(static_cast<std::uint16_t>(port));
    name.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    bound_ = ::bind(socket_, reinterpret_cast<const sockaddr*>(&name), sizeof name) == 0;
  }
  ~BoundPort() { ::close(socket_); }
  BoundPort(const BoundPort&) = delete;
  BoundPort& operator=(const BoundPort&) = delete;
  bool bound() const { return bound_; }

 private:
  int socket_;
  bool bound_;
};

bus::NetworkOptions domain(int number) {
  bus::NetworkOptions network;
  network.domain = number;
  return network;
}

/// Ports of that many participants of domain 3.
std::set<int> ports_of(int participants) {
  std::set<int> ports;
  for (int index = 0; index < participants; ++index) {
    ports.insert({kFirstOfDomain3 + 10 + 2 * index, kFirstOfDomain3 + 11 + 2 * index});
  }
  return ports;
}

TEST(DomainPorts, AreSeenWhereAProcessBindsThem) {
  constexpr int kPort = 7400 + 250 * 97 + 10;  // domain 97, first participant
  const BoundPort discovery(kPort), data(kPort + 1);
  if (!discovery.bound() || !data.bound()) {
    GTEST_SKIP() << "domain 97 is in use";
  }
  const std::set<int> ports = bound_udp_ports();
  EXPECT_TRUE(ports.contains(kPort) && ports.contains(kPort + 1));
  const std::vector<int> domains = domains_in_use(ports);
  EXPECT_NE(std::find(domains.begin(), domains.end(), 97), domains.end());
}

TEST(DomainPorts, TellInWhichDomainProcessesAreWhenItIsNotTheOneAskedFor) {
  const Findings findings = other_domain_findings(domain(0), ports_of(2));
  ASSERT_EQ(findings.size(), 1u);
  EXPECT_EQ(findings[0].what, "DDS processes of this computer are in domain 3, not in 0");
  EXPECT_TRUE(other_domain_findings(domain(3), ports_of(2)).empty());
}

TEST(DomainPorts, TakeOnePortForNoProcess) { EXPECT_TRUE(domains_in_use({kFirstOfDomain3 + 10}).empty()); }

TEST(PortFindings, NameADomainThatHasNoIndexLeft) {
  EXPECT_TRUE(port_findings(domain(3), ports_of(39), kUsual).empty());
  const Findings findings = port_findings(domain(3), ports_of(40), kUsual);
  ASSERT_EQ(findings.size(), 1u);
  EXPECT_EQ(findings[0].what, "all 40 participant indexes of domain 3 are taken on this computer: no process can join");
}

TEST(PortFindings, NameADomainWhosePortsLinuxHandsOut) {
  EXPECT_TRUE(port_findings(domain(100), {}, kUsual).empty());
  const Findings findings = port_findings(domain(150), {}, kUsual);
  ASSERT_EQ(findings.size(), 1u);
  EXPECT_EQ(findings[0].fix, "take a domain from 0 to 100");
}

TEST(Leftovers, AreSegmentsWhoseLockNobodyHolds) {
  const ScratchDirectory shared_memory;
  for (const char* name : {"fastrtps_0123456789abcdef", "fastrtps_0123456789abcdef_el", "fastrtps_port7410_sl"}) {
    std::ofstream(shared_memory.file(name)) << "";
  }
  const int held = ::open((shared_memory.file("fastrtps_port7410_sl")).c_str(), O_RDONLY);
  ASSERT_EQ(::flock(held, LOCK_SH), 0);
  const Findings findings = leftover_findings(shared_memory.file(""));
  ::close(held);
  ASSERT_EQ(findings.size(), 1u);
  EXPECT_TRUE(findings[0].what.starts_with("1 segments or ports of Fast DDS")) << findings[0].what;
  EXPECT_FALSE(findings[0].fault);
}

TEST(Leftovers, AreNoneInAnEmptyFolder) { EXPECT_TRUE(leftover_findings(ScratchDirectory().file("")).empty()); }

TEST(Environment, IsNotedWithWhatBecomesOfIt) {
  ::setenv("CYCLONEDDS_URI", "<General><AllowMulticast>true</AllowMulticast></General>", 1);
  const Findings findings = environment_findings({});
  ::unsetenv("CYCLONEDDS_URI");
  ASSERT_FALSE(findings.empty());
  EXPECT_EQ(findings[0].what, "CYCLONEDDS_URI, General/AllowMulticast true: set aside, processes use unicast alone");
  EXPECT_FALSE(findings[0].fault);
}

TEST(Multicast, IsNotedWhereTheInterfaceHasNone) {
  HostFacts facts;
  facts.interfaces = {{"lo", "127.0.0.1", true, false}, {"eth0", "10.0.0.4", true, true}};
  ASSERT_EQ(multicast_findings(facts, "127.0.0.1").size(), 1u);
  EXPECT_FALSE(multicast_findings(facts, "127.0.0.1")[0].fault);
  EXPECT_TRUE(multicast_findings(facts, "10.0.0.4").empty());
}

}  // namespace surroundings_test
}  // namespace farrier::deploy
