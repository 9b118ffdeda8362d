#include "security/credentials.hpp"

#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <filesystem>

#include "security/certificate.hpp"

namespace farrier::security {
namespace {

namespace fs = std::filesystem;

constexpr const char* kMakeAnew = "; make the folder with 'farrier security init', or copy it from where that was run";

Result<Done> is_readable(const std::string& path) {
  if (::access(path.c_str(), R_OK) == 0) {
    return Done{};
  }
  const int why = errno;
  return Error{"--security: cannot read " + path + ": " + std::strerror(why) +
               (why == EACCES ? "; it must be readable for the user this process runs as (chown, chmod)" : kMakeAnew)};
}

Result<Done> is_private(const std::string& path) {
  struct stat about {};
  if (::stat(path.c_str(), &about) != 0) {
    return Error{"--security: cannot read " + path + ": " + std::strerror(errno)};
  }
  if ((about.st_mode & (S_IRWXG | S_IRWXO)) != 0) {
    return Error{"--security: " + path + " is open to others than its owner: chmod 600 it, and make a new one if "
                 "somebody may have read it"};
  }
  return Done{};
}

Result<Done> is_valid(const Certificate& certificate, const std::string& path, std::time_t now) {
  const std::string clock = "; this computer's clock says " + date_text(now);
  if (now < certificate.not_before) {
    return Error{"--security: " + path + " is valid from " + date_text(certificate.not_before) + " on" + clock +
                 ": set the clock (without a battery it starts in the past, see docs/security.md)"};
  }
  if (now > certificate.not_after) {
    return Error{"--security: " + path + " expired on " + date_text(certificate.not_after) + clock +
                 ": issue new certificates with 'farrier security init', or set the clock"};
  }
  return Done{};
}

Error mixed_up(const Error& error) {
  return Error{"--security: " + error.message + ": files of different 'farrier security init' are mixed; copy the "
               "folder anew"};
}

}  // namespace

std::string date_text(std::time_t time) {
  std::tm parts{};
  ::gmtime_r(&time, &parts);
  char text[32];
  std::strftime(text, sizeof text, "%Y-%m-%d %H:%M UTC", &parts);
  return text;
}

bus::SecurityFiles files_of(const std::string& folder, bus::Role role, bus::Vendor vendor) {
  const fs::path all = fs::absolute(folder).lexically_normal();
  const fs::path own = all / (std::string(bus::to_string(role)) + "." + bus::to_string(vendor));
  return {.identity_ca = all / "identity_ca.pem",
          .certificate = own / "certificate.pem",
          .private_key = own / "key.pem",
          .permissions_ca = all / "permissions_ca.pem",
          .governance = all / "governance.p7s",
          .permissions = own / "permissions.p7s"};
}

Result<bus::SecurityFiles> credentials(const std::string& folder, bus::Role role, bus::Vendor vendor, std::time_t now) {
  std::error_code unseen;
  if (!fs::is_directory(folder, unseen)) {
    return Error{"--security: " + folder + " is not a folder" + kMakeAnew};
  }
  const bus::SecurityFiles files = files_of(folder, role, vendor);
  for (const std::string* path : {&files.identity_ca, &files.certificate, &files.private_key, &files.permissions_ca,
                                  &files.governance, &files.permissions}) {
    FARRIER_TRY(is_readable(*path));
  }
  FARRIER_TRY(is_private(files.private_key));
  const auto certificate = read_certificate(files.certificate);
  if (!certificate) {
    return mixed_up(certificate.error());
  }
  for (const std::string* path : {&files.certificate, &files.identity_ca, &files.permissions_ca}) {
    const auto dated = read_certificate(*path);
    if (!dated) {
      return mixed_up(dated.error());
    }
    FARRIER_TRY(is_valid(dated.value(), *path, now));
  }
  for (const Result<Done>& kinship : {issued_by(files.certificate, files.identity_ca),
                                      belongs_to(files.private_key, files.certificate)}) {
    if (!kinship) {
      return mixed_up(kinship.error());
    }
  }
  if (!suits(certificate.value().subject_hash, vendor)) {
    return Error{"--security: the subject of " + files.certificate + " is for the other DDS vendor, with which this "
                 "process could not agree on keys" + kMakeAnew};
  }
  const auto governance = signed_text(files.governance, files.permissions_ca);
  const auto permissions = signed_text(files.permissions, files.permissions_ca);
  if (!governance || !permissions) {
    return mixed_up(!governance ? governance.error() : permissions.error());
  }
  if (permissions.value().find("<subject_name>" + certificate.value().subject + "</subject_name>") ==
      std::string::npos) {
    return mixed_up(Error{files.permissions + " is not for " + certificate.value().subject});
  }
  return files;
}

}  // namespace farrier::security
