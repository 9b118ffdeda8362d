// DDS Security within each vendor and across both: who is let in, and what those may write.

#include <gtest/gtest.h>

#include <fstream>

#include "bus_factory/bus_factory.hpp"
#include "bus_fastdds/session_keys.hpp"
#include "conformance.hpp"
#include "security/certificate.hpp"
#include "security/credentials.hpp"
#include "tests/unit/security/pki.hpp"
#include "tools/tool_process/tool_process.hpp"

namespace farrier::contract {
namespace security_test {

using bus::Role;
using signals::JointValveCommand;
using test::kRobot;
using test::Pki;

/// For a handshake, and for Fast's endpoint discovery to repeat itself once or twice, on a loaded machine.
constexpr Nanoseconds kHandshakeBudget = 30s;
/// Those who may talk have found each other long before; who has not by then is kept out.
constexpr Nanoseconds kKeptOut = 3s;

Pki& pki() {
  static Pki shared;
  return shared;
}

Pki& another_pki() {
  static Pki shared;
  return shared;
}

using Made = Result<std::unique_ptr<bus::Bus>>;

Made join(bus::Vendor vendor, std::optional<bus::SecurityFiles> security) {
  bus::NetworkOptions network;
  network.domain = own_domain();
  network.security = std::move(security);
  return bus_factory::create_bus(vendor, network);
}

std::unique_ptr<bus::Bus> required(Made made) {
  FARRIER_ENSURE(made.ok(), made.error().message.c_str());
  return std::move(made).value();
}

std::unique_ptr<bus::Bus> join_as(Role role, bus::Vendor vendor, const Pki& keys = pki()) {
  return required(join(vendor, security::files_of(keys.out(), role, vendor)));
}

bus::EndpointSpec endpoint(bus::TopicId topic, const std::string& robot = kRobot) {
  return {topic, reliable(), {robot}};
}

auto publisher(bus::Bus& bus) {
  return bus::Publisher<JointValveCommand>::create(bus, endpoint(bus::TopicId::kJointValveCommand));
}
auto subscription(bus::Bus& bus) {
  return bus::Subscription<JointValveCommand>::create(bus, endpoint(bus::TopicId::kJointValveCommand));
}

/// Valve commands of one joint from a bus to another.
class Route {
 public:
  Route(std::unique_ptr<bus::Bus> from, std::unique_ptr<bus::Bus> to, std::uint16_t joint = 0)
      : from_(std::move(from)), to_(std::move(to)), out_(publisher(*from_)), in_(subscription(*to_)) {
    FARRIER_ENSURE(out_.ok() && in_.ok(), "endpoints that may be");
    command_.joint = joint;
  }

  bus::Bus& to() { return *to_; }
  /// Publishes a command. True once one has arrived.
  bool crosses() {
    out_.value().publish(command_);
    in_.value().drain([&](const JointValveCommand& arrived) { came_ = came_ || arrived.joint == command_.joint; });
    return came_;
  }

 private:
  std::unique_ptr<bus::Bus> from_, to_;
  decltype(publisher(*from_)) out_;
  decltype(subscription(*to_)) in_;
  JointValveCommand command_;
  bool came_ = false;
};

std::string all_of(const std::vector<std::string>& sentences) {
  std::string text;
  for (const std::string& sentence : sentences) {
    text += sentence + "\n";
  }
  return text;
}

class Security : public testing::TestWithParam<Pair> {};

TEST_P(Security, SamplesCrossBetweenProvenIdentities) {
  Route route(join_as(Role::kJointNode, GetParam().writer), join_as(Role::kSimBridge, GetParam().reader));
  EXPECT_TRUE(wait_until(route.to(), kHandshakeBudget, [&] { return route.crosses(); }));
}

// The three wait at the same time.
TEST_P(Security, ParticipantWithoutIdentityOrOfAnotherCaIsKeptOutAndReported) {
  const auto [name, writer, reader] = GetParam();
  Route stranger_writes(required(join(writer, std::nullopt)), join_as(Role::kSimBridge, reader), 0);
  Route stranger_reads(join_as(Role::kJointNode, writer), required(join(reader, std::nullopt)), 1);
  Route impostor(join_as(Role::kJointNode, writer, another_pki()), join_as(Role::kSimBridge, reader), 2);
  wait_until(impostor.to(), kKeptOut, [&] {
    const bool stranger_wrote = stranger_writes.crosses(), stranger_read = stranger_reads.crosses();
    return impostor.crosses() && stranger_wrote && stranger_read;
  });
  EXPECT_FALSE(stranger_writes.crosses()) << "a participant without identity writes";
  EXPECT_FALSE(stranger_reads.crosses()) << "a participant without identity reads";
  EXPECT_FALSE(impostor.crosses()) << "a participant of another CA writes";
  // With two Cyclones only the one that answers a handshake says why it fails; with Fast DDS Cyclone never answers.
  if (reader == bus::Vendor::kFast) {
    EXPECT_NE(all_of(impostor.to().take_security_warnings()), "");
  }
}

constexpr Pair kPairs[] = {{"CycloneToCyclone", bus::Vendor::kCyclone, bus::Vendor::kCyclone},
                           {"FastToFast", bus::Vendor::kFast, bus::Vendor::kFast},
                           {"CycloneToFast", bus::Vendor::kCyclone, bus::Vendor::kFast},
                           {"FastToCyclone", bus::Vendor::kFast, bus::Vendor::kCyclone}};
INSTANTIATE_TEST_SUITE_P(Over, Security, testing::ValuesIn(kPairs), [](const auto& pair) { return pair.param.name; });

// A session of Fast DDS lasts some messages: 200 samples took 58 keys where this was written.
TEST(SessionKeys, AreDerivedForASessionNotForAMessage) {
  constexpr int kSamples = 200;
  const auto writer = join_as(Role::kJointNode, bus::Vendor::kFast);
  const auto reader = join_as(Role::kSimBridge, bus::Vendor::kFast);
  auto out = publisher(*writer);
  auto in = subscription(*reader);
  ASSERT_TRUE(out.ok() && in.ok());
  const auto crosses_once = [&] {
    out.value().publish({});
    return in.value().drain([](const JointValveCommand&) {}) > 0;
  };
  ASSERT_TRUE(wait_until(*reader, kHandshakeBudget, crosses_once));
  const std::uint64_t before = bus_fastdds::session_keys_derived();
  EXPECT_GT(before, 0u) << "Fast DDS derives its keys by another function";
  for (int i = 0; i < kSamples; ++i) {
    ASSERT_TRUE(wait_until(*reader, kHandshakeBudget, crosses_once));
  }
  EXPECT_LT(bus_fastdds::session_keys_derived() - before, kSamples / 2);
}

class SecureProcess : public testing::TestWithParam<bus::Vendor> {};

TEST_P(SecureProcess, MonitorMayNotWriteValveCommandsAndIsToldWhere) {
  const auto monitor = join_as(Role::kMonitor, GetParam());
  const auto refused = publisher(*monitor);
  ASSERT_FALSE(refused.ok());
  EXPECT_NE(refused.error().message.find("joint/valve_command"), std::string::npos) << refused.error().message;
  EXPECT_NE(refused.error().message.find("monitor." + std::string(bus::to_string(GetParam()))), std::string::npos)
      << refused.error().message;
  EXPECT_TRUE(subscription(*monitor).ok()) << "reading is a monitor's right";
}

TEST_P(SecureProcess, LauncherMayGreetAndCommandsNoJoint) {
  const auto launcher = join_as(Role::kLauncher, GetParam());
  EXPECT_FALSE(publisher(*launcher).ok());
  const auto hello = bus::Publisher<signals::SystemHello>::create(*launcher, endpoint(bus::TopicId::kSystemHello));
  EXPECT_TRUE(hello.ok()) << (hello ? "" : hello.error().message);
}

TEST_P(SecureProcess, MayNotEnterThePartitionOfAnotherRobot) {
  const auto node = join_as(Role::kJointNode, GetParam());
  const auto refused =
      bus::Publisher<JointValveCommand>::create(*node, endpoint(bus::TopicId::kJointValveCommand, "another_robot"));
  EXPECT_FALSE(refused.ok());
}

TEST_P(SecureProcess, DoesNotStartWithAnExpiredCertificate) {
  static Pki expired(-1);
  const auto refused = join(GetParam(), security::files_of(expired.out(), Role::kJointNode, GetParam()));
  ASSERT_FALSE(refused.ok());
  EXPECT_NE(refused.error().message.find("refuses a secure participant with"), std::string::npos)
      << refused.error().message;
}

TEST_P(SecureProcess, DoesNotStartInsecureWhenAFileIsMissing) {
  for (std::string bus::SecurityFiles::*file :
       {&bus::SecurityFiles::identity_ca, &bus::SecurityFiles::certificate, &bus::SecurityFiles::private_key,
        &bus::SecurityFiles::permissions_ca, &bus::SecurityFiles::governance, &bus::SecurityFiles::permissions}) {
    bus::SecurityFiles files = security::files_of(pki().out(), Role::kJointNode, GetParam());
    const std::string path = files.*file;
    files.*file += ".missing";
    EXPECT_FALSE(join(GetParam(), files).ok()) << path;
  }
}

TEST_P(SecureProcess, DoesNotStartWithAGovernanceThatAnotherCaSigned) {
  bus::SecurityFiles files = security::files_of(pki().out(), Role::kJointNode, GetParam());
  files.governance = another_pki().out() + "/governance.p7s";
  EXPECT_FALSE(join(GetParam(), files).ok());
}

// CVE-2023-24010 and -24011: possible where one CA issues identities and permissions.
TEST_P(SecureProcess, MayNotSignItsOwnPermissions) {
  const std::string folder = pki().copy();
  bus::SecurityFiles files = security::files_of(folder, Role::kMonitor, GetParam());
  const bus::SecurityFiles coveted = security::files_of(folder, Role::kJointNode, GetParam());
  const auto rights = security::signed_text(coveted.permissions, coveted.permissions_ca);
  const std::string draft = folder + "/mine.xml";
  std::string text = rights.value();
  const std::string subject = security::read_certificate(coveted.certificate).value().subject;
  text.replace(text.find(subject), subject.size(), security::read_certificate(files.certificate).value().subject);
  std::ofstream(draft) << text;
  const auto signing = run_tool({"openssl", "openssl"},
                                {"smime", "-sign", "-text", "-in", draft, "-signer", files.certificate, "-inkey",
                                 files.private_key, "-out", files.permissions},
                                folder, folder + "/log");
  ASSERT_TRUE(signing.ok()) << signing.error().message;
  EXPECT_FALSE(join(GetParam(), files).ok());
}

INSTANTIATE_TEST_SUITE_P(On, SecureProcess, testing::Values(bus::Vendor::kCyclone, bus::Vendor::kFast),
                         [](const auto& vendor) { return std::string(bus::to_string(vendor.param)); });

}  // namespace security_test
}  // namespace farrier::contract
