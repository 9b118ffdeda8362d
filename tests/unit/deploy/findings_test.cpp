#include "files.hpp"
#include "runtime/realtime_thread.hpp"
#include "tools/deploy/host_findings.hpp"
#include "tools/deploy/rendering.hpp"

namespace farrier::deploy {
namespace findings_test {

/// A computer that is all that host `front` of hyq.yaml asks for.
HostFacts fit_host() {
  HostFacts facts;
  facts.name = "front";
  facts.interfaces = {{"lo", "127.0.0.1", true, false}, {"eth0", "192.168.20.11", true, true}};
  facts.cpus = {0, 1, 2, 3};
  facts.realtime_kernel = true;
  facts.receive_buffer_max = facts.send_buffer_max = 4u << 20;
  return facts;
}

Findings findings_of(const HostFacts& facts) {
  const robot::Deployment& deployment = *hyq().file.deployment;
  return host_findings(facts, deployment, *config::find(deployment.hosts, "front"));
}

/// The only finding there must be.
std::string only_finding(const HostFacts& facts) {
  const Findings findings = findings_of(facts);
  EXPECT_EQ(findings.size(), 1u);
  EXPECT_FALSE(findings.empty() || findings.front().fix.empty()) << "a finding has a fix";
  return findings.empty() ? "" : findings.front().what;
}

TEST(HostFindings, AreNoneOnAComputerThatFits) { EXPECT_TRUE(findings_of(fit_host()).empty()); }

TEST(HostFindings, NameAnInterfaceThatIsNotThere) {
  HostFacts facts = fit_host();
  facts.interfaces[1].name = "enp3s0";
  EXPECT_EQ(only_finding(facts), "no interface eth0 here; there are lo (127.0.0.1), enp3s0 (192.168.20.11)");
}

TEST(HostFindings, NameAnInterfaceWithAnotherAddress) {
  HostFacts facts = fit_host();
  facts.interfaces[1].address = "10.0.0.4";
  EXPECT_EQ(only_finding(facts), "eth0 does not have 192.168.20.11; there are lo (127.0.0.1), eth0 (10.0.0.4)");
}

TEST(HostFindings, NameAnInterfaceThatIsDown) {
  HostFacts facts = fit_host();
  facts.interfaces[1].up = false;
  EXPECT_EQ(only_finding(facts), "eth0 is down or has no carrier");
}

TEST(HostFindings, NameAProcessorThatIsNotThere) {
  HostFacts facts = fit_host();
  facts.cpus = {0, 1};
  EXPECT_EQ(only_finding(facts), "process joint_node_rf is for processor 2 and this computer has 2");
}

TEST(HostFindings, NameSocketBuffersThatAreTooSmall) {
  HostFacts facts = fit_host();
  facts.receive_buffer_max = 212992;
  EXPECT_EQ(only_finding(facts),
            "net.core.rmem_max is 212992 bytes and DDS asks for 4194304: bursts of samples may be dropped");
}

TEST(HostFindings, NameAHostThatIsNotHeardForASecondAfterACut) {
  HostFacts facts = fit_host();
  facts.interfaces[1].address_retry_ms = 1000;
  EXPECT_EQ(only_finding(facts), "net.ipv4.neigh.eth0.retrans_time_ms is 1000: when its cable comes back, this host is not "
                                 "heard for up to that time");
  facts.interfaces[1].address_retry_ms = kAddressRetry_ms;
  EXPECT_TRUE(findings_of(facts).empty());
}

TEST(HostFindings, NameWhatKeepsALoopFromItsDeadlines) {
  HostFacts facts = fit_host();
  facts.realtime_kernel = false;
  facts.lacks_priority = "real-time priority (Operation not permitted)";
  facts.lacks_locked_memory = "locked memory (Cannot allocate memory)";
  facts.lacks_awake_processors = "processors that stay awake (Permission denied)";
  const Findings findings = findings_of(facts);
  ASSERT_EQ(findings.size(), 4u);
  EXPECT_NE(findings[0].what.find("no SCHED_FIFO priority 80: real-time priority (Operation not permitted)"),
            std::string::npos);
  EXPECT_NE(findings[1].what.find("cannot lock its memory"), std::string::npos);
  EXPECT_NE(findings[2].fix.find("KERNEL==\"cpu_dma_latency\""), std::string::npos) << findings[2].fix;
  EXPECT_NE(findings[3].fix.find("linux-image-rt-amd64"), std::string::npos);
}

TEST(HostFindings, AskNothingOfTheClockInLockStep) {
  HostFacts facts = fit_host();
  facts.realtime_kernel = false;
  facts.lacks_priority = "real-time priority";
  robot::Deployment deployment = *hyq().file.deployment;
  deployment.clock = ClockKind::kLockstep;
  EXPECT_TRUE(host_findings(facts, deployment, *config::find(deployment.hosts, "front")).empty());
}

TEST(HostFindings, NameExecutablesAndFilesThatAreNotThere) {
  const ScratchDirectory scratch;
  const Places places{.prefix = scratch.file("usr"), .folder = scratch.file("units")};
  const auto processes = processes_of(hyq(), "front", places);
  const Findings findings = file_findings(processes.value(), places, {"farrier-hyq.target"});
  ASSERT_EQ(findings.size(), 2u) << "both processes are joint_nodes, which is missing once";
  EXPECT_EQ(findings[0].what, scratch.file("usr/libexec/farrier/joint_node") + " is not there or cannot be run");
  EXPECT_EQ(findings[1].what, scratch.file("units/farrier-hyq.target") +
                                  " is not there or not what this robot file asks for");
}

TEST(HostFacts, AreThoseOfThisComputer) {
  const HostFacts facts = this_host(runtime::kControlPriority);
  EXPECT_FALSE(facts.cpus.empty());
  EXPECT_FALSE(facts.kernel.empty());
  EXPECT_GT(facts.receive_buffer_max, 0u);
  EXPECT_TRUE(std::any_of(facts.interfaces.begin(), facts.interfaces.end(),
                          [](const Interface& i) { return i.name == "lo"; }));
}

TEST(HostFacts, ReadListsOfProcessorsAsTheKernelWritesThem) {
  EXPECT_EQ(parse_cpu_list("0-3,6"), (std::vector<int>{0, 1, 2, 3, 6}));
  EXPECT_EQ(parse_cpu_list("5"), std::vector<int>{5});
  EXPECT_TRUE(parse_cpu_list("").empty());
}

}  // namespace findings_test
}  // namespace farrier::deploy
