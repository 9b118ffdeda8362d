// farrier security: makes and checks what --security reads.

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <memory>

#include "participant/clock.hpp"
#include "robot/robot.hpp"
#include "security/certificate.hpp"
#include "security/credentials.hpp"
#include "cli/base/command.hpp"
#include "cli/base/help.hpp"
#include "cli/base/installation.hpp"
#include "tools/pki/pki.hpp"

namespace farrier::cli {
namespace {

namespace fs = std::filesystem;

struct SecurityOptions {
  std::string what;
  std::string folder;
  std::string ca;  ///< empty: `folder` with -ca behind it
  std::string robot_path = shipped_robot("hyq.yaml");
  int days = pki::Plan{}.days;
};

/// `folder/` names the same as `folder`.
std::string without_slash(const std::string& folder) {
  const fs::path path = fs::absolute(folder).lexically_normal();
  return path.has_filename() ? path : path.parent_path();
}

int init(const SecurityOptions& o) {
  const auto robot = robot::load_robot(o.robot_path);
  if (!robot) {
    std::fputs(config::to_string(robot.error()).c_str(), stderr);
    return kBadInput;
  }
  const std::string out = without_slash(o.folder);
  const std::string ca = o.ca.empty() ? out + "-ca" : without_slash(o.ca);
  if (auto made = pki::make({.robot = robot.value().name, .out = out, .ca = ca, .days = o.days}); !made) {
    return refuse("security", made.error().message);
  }
  std::printf("%s: for --security of every process of %s, valid for %d days; what each computer needs of it is in "
              "docs/security.md\n%s: the keys of the CAs, which may issue any right: keep them off the robot\n",
              out.c_str(), robot.value().name.c_str(), o.days, ca.c_str());
  return kPassed;
}

/// Every identity that is there, as a process that starts now would judge it.
int check(const SecurityOptions& o) {
  int found = 0;
  bool good = true;
  for (const bus::Role role : bus::kRoles) {
    for (const bus::Vendor vendor : {bus::Vendor::kCyclone, bus::Vendor::kFast}) {
      if (!fs::exists(fs::path(security::files_of(o.folder, role, vendor).certificate).parent_path())) {
        continue;
      }
      ++found;
      const auto files = security::credentials(o.folder, role, vendor, participant::date_now());
      if (!files) {
        static_cast<void>(refuse("security", files.error().message));
        good = false;
        continue;
      }
      const auto certificate = security::read_certificate(files.value().certificate);
      std::printf("%-18s %-8s %s, until %s\n", bus::to_string(role), bus::to_string(vendor),
                  certificate.value().subject.c_str(), security::date_text(certificate.value().not_after).c_str());
    }
  }
  if (found == 0) {
    return refuse("security", o.folder + " has no identity in it: give the folder that 'farrier security init' made");
  }
  return good ? kPassed : kBadInput;
}

}  // namespace

std::function<int()> declare_security(CLI::App& app) {
  auto o = std::make_shared<SecurityOptions>();
  app.add_option("what", o->what,
                 "init: make the folder, an identity with its rights for each role on each vendor; check: judge those that "
                 "are there as a process that starts now would")
      ->required()
      ->check(CLI::IsMember({"init", "check"}))
      ->type_name("init|check");
  app.add_option("folder", o->folder, "what --security is given")->required()->type_name("<dir>");
  app.add_option("--ca", o->ca,
                 "init: folder of the two CAs with their keys; made when it is not there, else they issue anew")
      ->type_name("<dir>")
      ->default_str("the folder's name with -ca behind it");
  app.add_option("--robot", o->robot_path, "init: robot file; its name is where the rights hold")
      ->type_name("<file>")
      ->default_str("hyq.yaml, as shipped");
  app.add_option("--days", o->days, "init: for which the identities are valid")
      ->check(between(1, 3650))
      ->type_name("<n>")
      ->capture_default_str();
  return [o] { return o->what == "init" ? init(*o) : check(*o); };
}

}  // namespace farrier::cli
