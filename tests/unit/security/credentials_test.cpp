// Credentials with which a process refuses to start, before DDS sees them.

#include "security/credentials.hpp"

#include <gtest/gtest.h>
#include <sys/stat.h>

#include <ctime>
#include <fstream>

#include "security/certificate.hpp"
#include "pki.hpp"

namespace farrier::security {
namespace credentials_test {

namespace fs = std::filesystem;
using test::Pki;

constexpr std::time_t kDay = 24 * 60 * 60;

Pki& pki() {
  static Pki shared;
  return shared;
}

Pki& another_pki() {
  static Pki shared;
  return shared;
}

/// Why a joint_node on Cyclone may not start with this folder, `later` than now; empty when it may.
std::string refusal(const std::string& folder, std::time_t later = 0) {
  const auto files = credentials(folder, bus::Role::kJointNode, bus::Vendor::kCyclone, std::time(nullptr) + later);
  return files ? "" : files.error().message;
}

testing::AssertionResult names(const std::string& message, const std::string& file, const std::string& remedy) {
  if (message.find(file) != std::string::npos && message.find(remedy) != std::string::npos) {
    return testing::AssertionSuccess();
  }
  return testing::AssertionFailure() << "'" << message << "' does not name " << file << " and '" << remedy << "'";
}

std::string own(const std::string& folder, const std::string& file) { return folder + "/joint_node.cyclone/" + file; }

void replace(const std::string& file, const std::string& by) {
  fs::copy_file(by, file, fs::copy_options::overwrite_existing);
}

TEST(Credentials, EveryRoleOnEitherVendorMayStartWithWhatInitMade) {
  const std::string keys = pki().out();  // made before the clock is read
  for (const bus::Role role : bus::kRoles) {
    for (const bus::Vendor vendor : {bus::Vendor::kCyclone, bus::Vendor::kFast}) {
      const auto files = credentials(keys, role, vendor, std::time(nullptr));
      EXPECT_TRUE(files.ok()) << files.error().message;
    }
  }
}

TEST(Credentials, MissingFolderIsRefused) {
  EXPECT_TRUE(names(refusal(pki().out() + "-elsewhere"), "-elsewhere is not a folder", "farrier security init"));
}

TEST(Credentials, MissingFileIsNamed) {
  for (const char* file : {"governance.p7s", "identity_ca.pem", "permissions_ca.pem", "joint_node.cyclone/key.pem",
                           "joint_node.cyclone/certificate.pem", "joint_node.cyclone/permissions.p7s"}) {
    const std::string folder = pki().copy();
    fs::remove(folder + "/" + file);
    EXPECT_TRUE(names(refusal(folder), std::string("cannot read ") + folder + "/" + file, "farrier security init"));
  }
}

TEST(Credentials, RoleWithoutAnIdentityIsRefused) {
  const std::string folder = pki().copy();
  fs::remove_all(folder + "/joint_node.cyclone");
  EXPECT_TRUE(names(refusal(folder), "joint_node.cyclone/certificate.pem", "farrier security init"));
}

TEST(Credentials, KeyThatOthersMayReadIsRefused) {
  const std::string folder = pki().copy();
  for (const mode_t open : {0640, 0604, 0620}) {
    ::chmod(own(folder, "key.pem").c_str(), open);
    EXPECT_TRUE(names(refusal(folder), own(folder, "key.pem"), "chmod 600")) << open;
  }
}

TEST(Credentials, ExpiredCertificateIsRefused) {
  EXPECT_TRUE(names(refusal(pki().out(), 366 * kDay), "certificate.pem expired on",
                    "farrier security init"));
}

TEST(Credentials, CertificateOfTheFutureIsRefusedAndTheClockIsBlamed) {
  EXPECT_TRUE(names(refusal(pki().out(), -366 * kDay), "certificate.pem is valid from", "set the clock"));
}

TEST(Credentials, CertificateOfAnotherCaIsRefused) {
  const std::string folder = pki().copy();
  replace(folder + "/identity_ca.pem", another_pki().out() + "/identity_ca.pem");
  EXPECT_TRUE(names(refusal(folder), "certificate.pem was not issued by", "copy the folder anew"));
}

TEST(Credentials, KeyOfAnotherIdentityIsRefused) {
  const std::string folder = pki().copy();
  replace(own(folder, "key.pem"), folder + "/supervisor.cyclone/key.pem");
  EXPECT_TRUE(names(refusal(folder), "is not the key of", "copy the folder anew"));
}

TEST(Credentials, IdentityOfTheOtherVendorIsRefused) {
  const std::string folder = pki().copy();
  for (const char* file : {"certificate.pem", "key.pem", "permissions.p7s"}) {
    replace(own(folder, file), folder + "/joint_node.fast/" + file);
  }
  EXPECT_TRUE(names(refusal(folder), "certificate.pem is for the other DDS vendor", "farrier security init"));
}

TEST(Credentials, PermissionsOfAnotherIdentityAreRefused) {
  const std::string folder = pki().copy();
  replace(own(folder, "permissions.p7s"), folder + "/supervisor.cyclone/permissions.p7s");
  EXPECT_TRUE(names(refusal(folder), "permissions.p7s is not for CN=joint_node.cyclone.", "copy the folder anew"));
}

TEST(Credentials, DocumentThatWasChangedAfterSigningIsRefused) {
  const std::string folder = pki().copy();
  std::string text;
  {
    std::ifstream file(folder + "/governance.p7s");
    text.assign(std::istreambuf_iterator<char>(file), {});
  }
  text.replace(text.find("ENCRYPT"), 7, "NONE");
  std::ofstream(folder + "/governance.p7s") << text;
  EXPECT_TRUE(names(refusal(folder), "governance.p7s was not signed by", "copy the folder anew"));
}

TEST(Credentials, DocumentOfAnotherPermissionsCaIsRefused) {
  const std::string folder = pki().copy();
  replace(own(folder, "permissions.p7s"), own(another_pki().out(), "permissions.p7s"));
  EXPECT_TRUE(names(refusal(folder), "permissions.p7s was not signed by", "copy the folder anew"));
}

TEST(Credentials, FileThatIsNoCertificateIsRefused) {
  const std::string folder = pki().copy();
  std::ofstream(own(folder, "certificate.pem")) << "not a certificate\n";
  EXPECT_TRUE(names(refusal(folder), "certificate.pem is not a certificate", "copy the folder anew"));
}

}  // namespace credentials_test
}  // namespace farrier::security
