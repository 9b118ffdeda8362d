#include "tools/pki/pki.hpp"

#include <sys/stat.h>

#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <vector>

#include "bus/roles.hpp"
#include "security/certificate.hpp"
#include "security/credentials.hpp"
#include "security/documents.hpp"
#include "tools/tool_process/tool_process.hpp"

namespace farrier::pki {
namespace {

namespace fs = std::filesystem;

constexpr int kCaDays = 3650;
/// Half of all names suit a vendor, so that not one of this many does has a chance of 2^-64.
constexpr int kMostNames = 64;

// Instead of the computer's own configuration, whatever that says. A permissions CA signs documents, too.
constexpr const char* kConfiguration =
    "[req]\ndistinguished_name = name\nx509_extensions = authority\n[name]\n"
    "[authority]\nbasicConstraints = critical, CA:TRUE\nkeyUsage = critical, keyCertSign, digitalSignature\n"
    "subjectKeyIdentifier = hash\n"
    "[identity]\nbasicConstraints = critical, CA:FALSE\nkeyUsage = critical, digitalSignature\n";

/// A folder that is made under another name beside its own, so that it is there whole or not at all.
class Workplace {
 public:
  static Result<Workplace> beside(const std::string& path) {
    const fs::path target = fs::absolute(path).lexically_normal();
    std::error_code refused;
    fs::create_directories(target.parent_path(), refused);
    std::string pattern = target.string() + ".XXXXXX";
    if (::mkdtemp(pattern.data()) == nullptr) {
      return Error{"cannot make a folder beside " + target.string() + ": " + std::strerror(errno)};
    }
    return Workplace(target, pattern);
  }
  Workplace(Workplace&& other) noexcept : target_(std::move(other.target_)), path_(std::exchange(other.path_, {})) {}
  Workplace& operator=(Workplace&&) = delete;
  ~Workplace() {
    if (!path_.empty()) {
      std::error_code ignored;
      fs::remove_all(path_, ignored);
    }
  }

  std::string file(const std::string& name) const { return path_ / name; }
  Result<Done> finish() {
    std::error_code refused;
    fs::rename(path_, target_, refused);
    if (refused) {
      return Error{"cannot make " + target_.string() + ": " + refused.message()};
    }
    path_.clear();
    return Done{};
  }

 private:
  Workplace(fs::path target, fs::path path) : target_(std::move(target)), path_(std::move(path)) {}

  fs::path target_;
  fs::path path_;
};

Result<Done> write(const std::string& path, const std::string& text) {
  std::ofstream file(path);
  file << text << std::flush;
  return file ? Result<Done>(Done{}) : Error{"cannot write " + path + ": " + std::strerror(errno)};
}

/// openssl, with its messages and drafts in a folder that goes with this object.
class OpenSsl {
 public:
  static Result<OpenSsl> start() {
    auto drafts = FARRIER_TRY(Workplace::beside((fs::temp_directory_path() / "farrier-pki").string()));
    OpenSsl openssl(std::move(drafts));
    FARRIER_TRY(write(openssl.configuration(), kConfiguration));
    return openssl;
  }

  std::string draft(const std::string& name) const { return drafts_.file(name); }
  std::string configuration() const { return draft("openssl.cnf"); }

  /// Runs commands in turn until one fails.
  Result<Done> run(const std::vector<std::vector<std::string>>& commands) const {
    for (const std::vector<std::string>& arguments : commands) {
      if (auto done = run_tool({"openssl", "openssl"}, arguments, draft(""), draft("log")); !done) {
        return Error{"openssl " + arguments.front() + ": " + done.error().message};
      }
    }
    return Done{};
  }

 private:
  explicit OpenSsl(Workplace drafts) : drafts_(std::move(drafts)) {}

  Workplace drafts_;
};

// P-256, with which Cyclone proposes a key agreement that Fast DDS can answer.
std::vector<std::string> new_key(const std::string& path) {
  return {"genpkey", "-algorithm", "EC", "-pkeyopt", "ec_paramgen_curve:P-256", "-out", path};
}

Result<Done> make_cas(const OpenSsl& openssl, const Plan& plan) {
  auto folder = FARRIER_TRY(Workplace::beside(plan.ca));
  for (const std::string name : {"identity", "permissions"}) {
    const std::string key = folder.file(name + "_ca.key");
    auto made = openssl.run({new_key(key),
                             {"req", "-x509", "-new", "-sha256", "-config", openssl.configuration(), "-key", key,
                              "-days", std::to_string(kCaDays), "-subj",
                              "/O=" + plan.robot + "/CN=" + name + " CA", "-out",
                              folder.file(name + "_ca.pem")}});
    if (!made) {
      return made;
    }
    ::chmod(key.c_str(), S_IRUSR | S_IWUSR);
  }
  return folder.finish();
}

/// Signs a document for DDS.
Result<Done> sign(const OpenSsl& openssl, const Plan& plan, const std::string& text, const std::string& path) {
  const std::string draft = openssl.draft("document.xml");
  if (auto written = write(draft, text); !written) {
    return written;
  }
  const std::string ca = fs::absolute(plan.ca) / "permissions_ca";
  return openssl.run({{"smime", "-sign", "-text", "-in", draft, "-signer", ca + ".pem", "-inkey", ca + ".key", "-out",
                       path}});
}

/// A request for a certificate whose subject suits the vendor: names are numbered until one does.
Result<Done> request(const OpenSsl& openssl, const Plan& plan, bus::Role role, bus::Vendor vendor,
                     const std::string& key, const std::string& path) {
  for (int number = 1; number <= kMostNames; ++number) {
    const std::string name =
        std::string(bus::to_string(role)) + "." + bus::to_string(vendor) + "." + std::to_string(number);
    auto asked = openssl.run({{"req", "-new", "-sha256", "-config", openssl.configuration(), "-key", key, "-subj",
                               "/O=" + plan.robot + "/CN=" + name, "-out", path}});
    if (!asked) {
      return asked;
    }
    const auto hash = FARRIER_TRY(security::subject_hash_of_request(path));
    if (security::suits(hash, vendor)) {
      return Done{};
    }
  }
  return Error{"no name of a " + std::string(bus::to_string(role)) + " suits " + bus::to_string(vendor)};
}

Result<Done> make_identity(const OpenSsl& openssl, const Plan& plan, const bus::SecurityFiles& files, bus::Role role,
                           bus::Vendor vendor) {
  std::error_code refused;
  fs::create_directory(fs::path(files.private_key).parent_path(), refused);
  if (auto made = openssl.run({new_key(files.private_key)}); !made) {
    return made;
  }
  ::chmod(files.private_key.c_str(), S_IRUSR | S_IWUSR);
  const std::string draft = openssl.draft("request.pem");
  if (auto asked = request(openssl, plan, role, vendor, files.private_key, draft); !asked) {
    return asked;
  }
  const std::string ca = fs::absolute(plan.ca) / "identity_ca";
  auto issued = openssl.run({{"x509", "-req", "-sha256", "-in", draft, "-CA", ca + ".pem", "-CAkey", ca + ".key",
                              "-CAserial", ca + ".serial", "-CAcreateserial", "-days", std::to_string(plan.days),
                              "-extfile", openssl.configuration(), "-extensions", "identity", "-out",
                              files.certificate}});
  if (!issued) {
    return issued;
  }
  const auto certificate = FARRIER_TRY(security::read_certificate(files.certificate));
  return sign(openssl, plan,
              security::permissions_document(certificate.subject, role, plan.robot,
                                             certificate.not_before, certificate.not_after),
              files.permissions);
}

Result<Done> check(const Plan& plan) {
  const fs::path out = fs::absolute(plan.out).lexically_normal();
  const fs::path ca = fs::absolute(plan.ca).lexically_normal();
  if (fs::exists(fs::symlink_status(out))) {
    return Error{out.string() + " is there already: name another folder, or move it away; the robot's processes need "
                 "what is in it until they are restarted with the new one"};
  }
  for (const auto& [inner, outer] : {std::pair(ca, out), std::pair(out, ca)}) {
    const fs::path way = inner.lexically_relative(outer);
    if (!way.empty() && *way.begin() != "..") {
      return Error{"the CAs' keys must not lie with what goes to the robot: " + out.string() + " and " + ca.string() +
                   " must be beside each other"};
    }
  }
  if (!fs::exists(fs::symlink_status(ca))) {
    return Done{};
  }
  for (const char* name : {"identity_ca.pem", "identity_ca.key", "permissions_ca.pem", "permissions_ca.key"}) {
    if (!fs::is_regular_file(ca / name)) {
      return Error{ca.string() + " is there and has no " + name +
                   ": name the folder of an earlier 'farrier security init', or one that is not there"};
    }
  }
  return Done{};
}

}  // namespace

Result<Done> make(const Plan& plan) {
  if (auto checked = check(plan); !checked) {
    return checked;
  }
  const auto openssl = FARRIER_TRY(OpenSsl::start());
  auto folder = FARRIER_TRY(Workplace::beside(plan.out));
  if (!fs::exists(plan.ca)) {
    if (auto made = make_cas(openssl, plan); !made) {
      return made;
    }
  }
  for (const char* name : {"identity_ca.pem", "permissions_ca.pem"}) {
    std::error_code refused;
    fs::copy_file(fs::path(plan.ca) / name, folder.file(name), refused);
    if (refused) {
      return Error{"cannot copy " + plan.ca + "/" + name + ": " + refused.message()};
    }
  }
  if (auto made = sign(openssl, plan, security::governance_document(), folder.file("governance.p7s"));
      !made) {
    return made;
  }
  for (const bus::Role role : bus::kRoles) {
    for (const bus::Vendor vendor : {bus::Vendor::kCyclone, bus::Vendor::kFast}) {
      auto made =
          make_identity(openssl, plan, security::files_of(folder.file(""), role, vendor), role, vendor);
      if (!made) {
        return made;
      }
    }
  }
  ::chmod(folder.file("").c_str(), 0755);
  return folder.finish();
}

}  // namespace farrier::pki
