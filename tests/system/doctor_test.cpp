// Faults that keep data from coming, made one at a time, and the real command's diagnosis of each.

#include <arpa/inet.h>
#include <dds/dds.h>
#include <gtest/gtest.h>
#include <netinet/in.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/socket.h>
#include <unistd.h>

#include <linux/capability.h>

#include <cstring>
#include <fstream>

#include "bus_cyclone/cyclone_domain.hpp"
#include "bus_cyclone/cyclone_endpoints.hpp"
#include "bus_factory/bus_factory.hpp"
#include "farrier_command.hpp"
#include "tests/support/needs_network_namespaces.hpp"
#include "cli/processes/domain_lock.hpp"
#include "cli/processes/host_clock.hpp"

namespace farrier::test {
namespace doctor_test {

using namespace std::chrono_literals;
using bus::TopicId;

/// A domain that no run uses, and who is in it.
class Doctor : public testing::Test {
 protected:
  /// Returns the command's output about robot hyq in the domain. It must end with that status.
  std::string asked(int status, std::vector<std::string> more = {}, const Surroundings& surroundings = {}) const {
    std::vector<std::string> arguments{"doctor", "--look", "1", "--domain", std::to_string(domain())};
    arguments.insert(arguments.end(), more.begin(), more.end());
    std::string output;
    EXPECT_EQ(run_farrier(arguments, &output, surroundings), status) << output;
    return output;
  }

  int domain() const { return lock_.value().domain(); }

  bus::NetworkOptions network() const {
    bus::NetworkOptions options;
    options.domain = domain();
    return options;
  }

 private:
  Result<cli::DomainLock> lock_ = cli::DomainLock::acquire();
};

/// A process of the robot as the contract has it, unless it is altered.
class Somebody {
 public:
  Somebody(bus::Vendor vendor, const bus::NetworkOptions& network)
      : bus_(std::move(bus_factory::create_bus(vendor, network).value())) {}

  void writes(TopicId topic, const std::string& partition) {
    writers_.push_back(std::move(bus_->create_writer(endpoint(topic, partition)).value()));
  }
  void reads(TopicId topic, const std::string& partition, void (*spoil)(bus::Qos&) = nullptr) {
    bus::EndpointSpec asked = endpoint(topic, partition);
    if (spoil != nullptr) {
      spoil(asked.qos);
    }
    readers_.push_back(std::move(bus_->create_reader(asked).value()));
  }

 private:
  static bus::EndpointSpec endpoint(TopicId topic, const std::string& partition) {
    return {.topic = topic,
            .qos = bus::qos_for(bus::spec(topic), bus::ClockKind::kRealtime),
            .partitions = {partition},
            .ownership_strength = 0};
  }

  std::unique_ptr<bus::Bus> bus_;
  std::vector<std::unique_ptr<bus::RawWriter>> writers_;
  std::vector<std::unique_ptr<bus::RawReader>> readers_;
};

/// Somebody else's program: a writer of a topic by any name of any of our types.
class Stranger {
 public:
  Stranger(const bus::NetworkOptions& network, const char* topic, TopicId type) {
    const bus_cyclone::Domain opened = bus_cyclone::open_domain(network).value();
    domain_ = opened.entity;
    const dds_entity_t participant = bus_cyclone::join_domain(opened, network).value();
    dds_qos_t* const hyq = dds_create_qos();
    dds_qset_partition1(hyq, "hyq/lf");
    const dds_entity_t publisher = dds_create_publisher(participant, hyq, nullptr);
    dds_delete_qos(hyq);
    const dds_entity_t named =
        dds_create_topic(participant, &bus_cyclone::topic_descriptor(type), topic, nullptr, nullptr);
    EXPECT_GT(dds_create_writer(publisher, named, nullptr, nullptr), 0);
  }
  ~Stranger() { dds_delete(domain_); }
  Stranger(const Stranger&) = delete;
  Stranger& operator=(const Stranger&) = delete;

 private:
  dds_entity_t domain_;
};

void expect_in(const std::string& output, const std::string& text) {
  EXPECT_NE(output.find(text), std::string::npos) << "'" << text << "' is not in\n" << output;
}

constexpr auto kSensors = TopicId::kJointSensors;

TEST_F(Doctor, FindsNothingWhereBothVendorsKeepTheContract) {
  Somebody bridge(bus::Vendor::kCyclone, network()), node(bus::Vendor::kFast, network());
  bridge.writes(kSensors, "hyq/lf");
  node.reads(kSensors, "hyq/lf");
  const std::string output = asked(0);
  expect_in(output, ": 2 processes, 2 writers and readers");
  expect_in(output, "hyq: 0 findings");
}

TEST_F(Doctor, FindsNobody) { expect_in(asked(1), "nobody else is in domain " + std::to_string(domain())); }

TEST_F(Doctor, FindsTheDomainInWhichTheProcessesAre) {
  const auto other = cli::DomainLock::acquire();
  bus::NetworkOptions elsewhere;
  elsewhere.domain = other.value().domain();
  const Somebody bridge(bus::Vendor::kCyclone, elsewhere);
  const std::string output = asked(1);
  expect_in(output, "DDS processes of this computer are in domain ");
  expect_in(output, std::to_string(elsewhere.domain));
}

TEST_F(Doctor, FindsAnAddressThatThisComputerDoesNotHave) {
  expect_in(asked(1, {"--address", "192.0.2.7"}), "no interface has 192.0.2.7");
}

TEST_F(Doctor, FindsThePartitionOfAnotherRobot) {
  Somebody bridge(bus::Vendor::kFast, network());
  bridge.writes(kSensors, "hexapod/lf");
  expect_in(asked(1), "in partition 'hexapod/lf', which is not robot hyq's");
}

TEST_F(Doctor, FindsAMisspelledTopic) {
  const Stranger stranger(network(), "joint/sensor", kSensors);
  const std::string output = asked(1);
  expect_in(output, "has topic 'joint/sensor', which nobody else does");
  expect_in(output, "if joint/sensors is meant");
}

TEST_F(Doctor, FindsATypeThatIsNotTheTopics) {
  const Stranger stranger(network(), "joint/sensors", TopicId::kJointCommand);
  expect_in(asked(1), "has type wire::JointCommand for joint/sensors, which is of wire::JointSensors");
}

class MismatchedQos : public Doctor, public testing::WithParamInterface<bus::Vendor> {};

TEST_P(MismatchedQos, IsFoundByPolicyWithBothOffers) {
  Somebody bridge(bus::Vendor::kCyclone, network()), node(GetParam(), network());
  bridge.writes(kSensors, "hyq/lf");
  node.reads(kSensors, "hyq/lf", [](bus::Qos& qos) {
    qos.reliability = bus::Reliability::kReliable;
    qos.deadline = 1ms;
  });
  const std::string output = asked(1);
  expect_in(output, "joint/sensors, RELIABILITY: best effort is offered and reliable is asked for");
  expect_in(output, "joint/sensors, DEADLINE: infinite is offered and 1 ms is asked for");
}

INSTANTIATE_TEST_SUITE_P(By, MismatchedQos, testing::Values(bus::Vendor::kCyclone, bus::Vendor::kFast),
                         [](const auto& vendor) {
                           return std::string(vendor.param == bus::Vendor::kFast ? "FastDds" : "Cyclone");
                         });

TEST_F(Doctor, FindsTwoWritersWhereOneBelongs) {
  Somebody one(bus::Vendor::kCyclone, network()), other(bus::Vendor::kFast, network());
  one.writes(kSensors, "hyq/lf");
  other.writes(kSensors, "hyq/lf");
  expect_in(asked(1), "several processes write joint/sensors of robot hyq");
}

TEST_F(Doctor, FindsThatNoParticipantIndexIsLeft) {
  std::vector<Descriptor> taken;
  for (int index = 0; index < network().max_processes; ++index) {
    for (const int port : {10 + 2 * index, 11 + 2 * index}) {
      taken.emplace_back(::socket(AF_INET, SOCK_DGRAM | SOCK_CLOEXEC, 0));
      sockaddr_in name{};
      name.sin_family = AF_INET;
      name.sin_port = htons(static_cast<std::uint16_t>(7400 + 250 * domain() + port));
      ASSERT_EQ(::bind(taken.back().number(), reinterpret_cast<const sockaddr*>(&name), sizeof name), 0);
    }
  }
  expect_in(asked(1), "all 40 participant indexes of domain " + std::to_string(domain()) + " are taken");
}

TEST_F(Doctor, FindsTheClockOfARunThatIsAnHourAhead) {
  const ScratchDirectory scratch;
  const auto clock = cli::HostClock::create(FARRIER_PREFIX "/libexec/farrier", scratch.file("clock"));
  ASSERT_TRUE(clock && clock.value().set(3600));
  FarrierCommand trot({"trot", "--world", "bench", "--clock", "realtime", "--no-comparison", "--duration", "600",
                       "--out", scratch.file("out")},
                      {FARRIER_COMMAND, [&] {
                         for (const std::string& variable : clock.value().environment()) {
                           ::putenv(::strdup(variable.c_str()));
                         }
                       }});
  ASSERT_TRUE(trot.says("trot: tick 0 of")) << trot.output();
  std::string output;
  EXPECT_EQ(run_farrier({"doctor", "--domain", std::to_string(trot.domain())}, &output), 1);
  expect_in(output, " s ahead of this computer's");
  expect_in(output, "chrony");
  trot.signal(SIGINT);
  EXPECT_EQ(trot.wait(20s), 130);
}

TEST_F(Doctor, FindsWhatKeepsAUserFromRealTime) {
  const Surroundings unprivileged{FARRIER_COMMAND, [] {
                                    for (const int capability : {CAP_SYS_NICE, CAP_IPC_LOCK, CAP_SYS_RESOURCE}) {
                                      ::prctl(PR_CAPBSET_DROP, capability, 0, 0, 0);
                                    }
                                    const rlimit none{0, 0};
                                    ::setrlimit(RLIMIT_RTPRIO, &none);
                                    ::setrlimit(RLIMIT_MEMLOCK, &none);
                                  }};
  const std::string output = asked(1, {"--realtime"}, unprivileged);
  expect_in(output, "gets no SCHED_FIFO priority 80");
  expect_in(output, "cannot lock its memory");
}

TEST_F(Doctor, FindsAKernelThatIsNotForRealTime) {
  const bool realtime_kernel = read_file("/sys/kernel/realtime").starts_with("1");
  const std::string output = asked(1, {"--realtime"});
  EXPECT_EQ(output.find("is not built with PREEMPT_RT") == std::string::npos, realtime_kernel) << output;
}

TEST_F(Doctor, NotesSharedMemoryOfProcessesThatAreGone) {
  const ScratchDirectory shared_memory;
  std::ofstream(shared_memory.file("fastrtps_port7410")) << "left";
  std::ofstream(shared_memory.file("fastrtps_port7410_el")) << "";
  expect_in(asked(1, {"--shared-memory", shared_memory.file("")}), "segments or ports of Fast DDS");
}

class DoctorOnAHost : public NeedsNetworkNamespaces<testing::Test> {};

TEST_F(DoctorOnAHost, NotesAnInterfaceWithoutMulticastAndFindsACableThatIsCut) {
  const NetworkNamespaces network({{"front", "eth0", "10.77.0.2"}});
  const auto asked = [&] {
    std::string output;
    EXPECT_EQ(run_farrier({"doctor", "--look", "0.5", "--address", "10.77.0.2", "--peers", "10.77.0.2"}, &output,
                          {FARRIER_COMMAND, network.at("front")}),
              1);
    return output;
  };
  const std::string whole = asked();
  expect_in(whole, "multicast");
  EXPECT_EQ(whole.find("has no carrier"), std::string::npos) << whole;
  network.cut("front");
  // The kernel reports a lost carrier up to a second late.
  const std::string no_carrier = "eth0 is down or has no carrier";
  std::string output = asked();
  for (int more = 2; more > 0 && output.find(no_carrier) == std::string::npos; --more) {
    output = asked();
  }
  expect_in(output, no_carrier);
}

}  // namespace doctor_test
}  // namespace farrier::test
