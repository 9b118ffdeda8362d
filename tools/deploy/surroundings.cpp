#include "tools/deploy/surroundings.hpp"

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include <filesystem>

#include "bus/settings/user_settings.hpp"

namespace farrier::deploy {
namespace {

namespace fs = std::filesystem;

/// Fast DDS holds a lock on a file beside each segment and port for as long as somebody uses it.
bool is_left_over(const fs::path& lock_file) {
  const int file = ::open(lock_file.c_str(), O_RDONLY | O_CLOEXEC);
  if (file < 0) {
    return false;
  }
  const bool free = ::flock(file, LOCK_EX | LOCK_NB) == 0;
  ::close(file);
  return free;
}

}  // namespace

Findings leftover_findings(const std::string& folder) {
  int left = 0;
  std::error_code unreadable;
  for (const auto& entry : fs::directory_iterator(folder, unreadable)) {
    const std::string name = entry.path().filename().string();
    const bool lock = name.starts_with("fastrtps_") && (name.ends_with("_el") || name.ends_with("_sl"));
    left += lock && is_left_over(entry.path()) ? 1 : 0;
  }
  if (left == 0) {
    return {};
  }
  return {{std::to_string(left) + " segments or ports of Fast DDS in " + folder + " belong to processes that are gone",
           "fastdds shm clean (package fastdds-tools); Farrier's own processes use UDP alone", false}};
}

Findings environment_findings(const bus::NetworkOptions& network) {
  Findings findings;
  for (const bus::UserSetting& setting : bus::user_settings(network)) {
    const bool acts = setting.use == bus::SettingUse::kHonoured;
    findings.push_back({bus::to_string(setting),
                        acts ? "unset " + setting.variable + " where the robot is started, unless that is wanted"
                             : "nothing: it acts on programs of others alone",
                        false});
  }
  return findings;
}

Findings multicast_findings(const HostFacts& facts, const std::string& address) {
  for (const Interface& interface : facts.interfaces) {
    if (interface.address == address && !interface.multicast) {
      const std::string& name = interface.name;
      return {{name + " has no multicast: Farrier's processes do without, but a DDS program with its vendor's defaults "
                      "finds nobody here",
               "ip link set " + name + " multicast on, and ip route add 239.255.0.0/16 dev " + name +
                   "; or give that program the peers " + address,
               false}};
    }
  }
  return {};
}

}  // namespace farrier::deploy
