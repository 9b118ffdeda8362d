// The files that `farrier security init` makes.

#include "tools/pki/pki.hpp"

#include <gtest/gtest.h>
#include <sys/stat.h>

#include <fstream>
#include <set>

#include "bus/topics.hpp"
#include "security/certificate.hpp"
#include "security/credentials.hpp"
#include "pki.hpp"

namespace farrier::pki {
namespace pki_test {

namespace fs = std::filesystem;
using test::kRobot;
using test::Pki;
using test::ScratchDirectory;

Pki& shared() {
  static Pki pki;
  return pki;
}

bus::SecurityFiles files(bus::Role role, bus::Vendor vendor) {
  return security::files_of(shared().out(), role, vendor);
}

/// The texts between the tags, one per occurrence.
std::multiset<std::string> all_between(const std::string& text, const std::string& open, const std::string& close) {
  std::multiset<std::string> found;
  for (std::size_t at = text.find(open); at != std::string::npos; at = text.find(open, at + 1)) {
    const std::size_t from = at + open.size();
    found.insert(text.substr(from, text.find(close, from) - from));
  }
  return found;
}

// In a handshake the participant with the lower hash of its subject begins, and Cyclone must.
TEST(Pki, EveryIdentityOfCycloneHashesBelowEveryOneOfFastDds) {
  for (const bus::Role cyclone : bus::kRoles) {
    const auto low = security::read_certificate(files(cyclone, bus::Vendor::kCyclone).certificate);
    for (const bus::Role fast : bus::kRoles) {
      const auto high = security::read_certificate(files(fast, bus::Vendor::kFast).certificate);
      EXPECT_LT(low.value().subject_hash, high.value().subject_hash)
          << low.value().subject << " and " << high.value().subject;
    }
  }
}

TEST(Pki, EachIdentityHasASubjectAndAKeyOfItsOwn) {
  std::set<std::string> subjects;
  std::set<std::string> keys;
  for (const bus::Role role : bus::kRoles) {
    for (const bus::Vendor vendor : {bus::Vendor::kCyclone, bus::Vendor::kFast}) {
      subjects.insert(security::read_certificate(files(role, vendor).certificate).value().subject);
      std::ifstream key(files(role, vendor).private_key);
      keys.emplace(std::istreambuf_iterator<char>(key), std::istreambuf_iterator<char>());
    }
  }
  EXPECT_EQ(subjects.size(), 2 * bus::kRoles.size());
  EXPECT_EQ(keys.size(), 2 * bus::kRoles.size());
}

TEST(Pki, KeepsTheKeysOfTheCasApart) {
  for (const auto& entry : fs::recursive_directory_iterator(shared().out())) {
    if (entry.is_regular_file() && entry.path().filename() == "key.pem") {
      EXPECT_EQ(entry.status().permissions() & fs::perms::all, fs::perms::owner_read | fs::perms::owner_write);
    } else {
      EXPECT_EQ(entry.path().extension().string().find("key"), std::string::npos) << entry.path();
    }
  }
  for (const char* key : {"identity_ca.key", "permissions_ca.key"}) {
    EXPECT_EQ(fs::status(shared().ca() + "/" + key).permissions() & fs::perms::all,
              fs::perms::owner_read | fs::perms::owner_write);
  }
  EXPECT_EQ(fs::status(shared().ca()).permissions() & fs::perms::all, fs::perms::owner_all);
}

TEST(Pki, EachRoleMayWriteTheTopicsTheRegistryGivesItAndReadAll) {
  for (const bus::Role role : bus::kRoles) {
    const bus::SecurityFiles own = files(role, bus::Vendor::kFast);
    const auto permissions = security::signed_text(own.permissions, own.permissions_ca);
    ASSERT_TRUE(permissions.ok()) << permissions.error().message;
    std::multiset<std::string> writes;
    for (const std::string& part : all_between(permissions.value(), "<publish>", "</publish>")) {
      writes.merge(all_between(part, "<topic>", "</topic>"));
    }
    std::multiset<std::string> reads;
    for (const std::string& part : all_between(permissions.value(), "<subscribe>", "</subscribe>")) {
      reads.merge(all_between(part, "<topic>", "</topic>"));
    }
    std::multiset<std::string> may_write;
    std::multiset<std::string> may_read;
    for (const bus::TopicSpec& topic : bus::topics()) {
      may_read.insert(topic.name);
      if (topic.writers.contains(role)) {
        may_write.insert(topic.name);
      }
    }
    EXPECT_EQ(writes, may_write) << bus::to_string(role);
    EXPECT_EQ(reads, may_read) << bus::to_string(role);
    EXPECT_NE(permissions.value().find("<default>DENY</default>"), std::string::npos);
  }
}

TEST(Pki, RightsHoldInThePartitionsOfTheRobotAlone) {
  const bus::SecurityFiles own = files(bus::Role::kSupervisor, bus::Vendor::kCyclone);
  const auto permissions = security::signed_text(own.permissions, own.permissions_ca);
  const auto partitions = all_between(permissions.value(), "<partition>", "</partition>");
  const std::string robot = kRobot;
  EXPECT_EQ(std::set<std::string>(partitions.begin(), partitions.end()), (std::set{robot, robot + "/*"}));
}

TEST(Pki, SameCasIssueASecondFolder) {
  const std::string second = shared().out() + "-next";
  ASSERT_TRUE(make({.robot = kRobot, .out = second, .ca = shared().ca()}).ok());
  const bus::SecurityFiles next = security::files_of(second, bus::Role::kMonitor, bus::Vendor::kCyclone);
  EXPECT_TRUE(security::issued_by(next.certificate, shared().out() + "/identity_ca.pem").ok());
}

TEST(Pki, FolderThatIsThereStaysAsItIs) {
  const auto again = make({.robot = kRobot, .out = shared().out(), .ca = shared().ca()});
  ASSERT_FALSE(again.ok());
  EXPECT_NE(again.error().message.find("is there already: name another folder"), std::string::npos);
}

TEST(Pki, CasKeysInsideTheFolderOfTheRobotAreRefused) {
  const ScratchDirectory folder;
  for (const char* ca : {"keys/ca", "keys", "."}) {
    const auto made = make({.robot = kRobot, .out = folder.file("keys"), .ca = folder.file(ca)});
    ASSERT_FALSE(made.ok()) << ca;
    EXPECT_NE(made.error().message.find("must be beside each other"), std::string::npos) << made.error().message;
  }
}

TEST(Pki, FolderWithoutCasIsNotTakenForOne) {
  const ScratchDirectory folder;
  fs::create_directory(folder.file("ca"));
  const auto made = make({.robot = kRobot, .out = folder.file("keys"), .ca = folder.file("ca")});
  ASSERT_FALSE(made.ok());
  EXPECT_NE(made.error().message.find("has no identity_ca.pem"), std::string::npos) << made.error().message;
}

/// PATH as `path` while this lives.
class PathOf {
 public:
  explicit PathOf(const std::string& path) : before_(std::getenv("PATH")) { ::setenv("PATH", path.c_str(), 1); }
  ~PathOf() { ::setenv("PATH", before_.c_str(), 1); }

 private:
  std::string before_;
};

TEST(Pki, WithoutOpensslSaysSoAndLeavesNothing) {
  const ScratchDirectory folder;
  const PathOf nowhere(folder.file("nowhere"));
  const auto made = make({.robot = kRobot, .out = folder.file("keys"), .ca = folder.file("ca")});
  ASSERT_FALSE(made.ok());
  EXPECT_NE(made.error().message.find("openssl is not on the PATH; install it (Debian: openssl)"), std::string::npos);
  EXPECT_TRUE(fs::is_empty(folder.file("")));
}

TEST(Pki, FailureHalfWayLeavesNothingAndSaysWhatOpensslSaid) {
  const ScratchDirectory folder;
  fs::create_directory(folder.file("bin"));
  // The real one, until it is asked to sign a document.
  std::ofstream(folder.file("bin/openssl"))
      << "#!/bin/sh\n[ \"$1\" = smime ] && { echo no more signatures; exit 3; }\nexec /usr/bin/openssl \"$@\"\n";
  ::chmod(folder.file("bin/openssl").c_str(), 0755);
  const PathOf broken(folder.file("bin"));
  const auto made = make({.robot = kRobot, .out = folder.file("keys"), .ca = folder.file("ca")});
  ASSERT_FALSE(made.ok());
  EXPECT_NE(made.error().message.find("openssl smime: openssl ended with status 3: no more signatures"),
            std::string::npos)
      << made.error().message;
  EXPECT_FALSE(fs::exists(folder.file("keys")));
  fs::remove_all(folder.file("bin"));
  fs::remove_all(folder.file("ca"));  // which was whole, and would issue the next
  EXPECT_TRUE(fs::is_empty(folder.file("")));
}

}  // namespace pki_test
}  // namespace farrier::pki
