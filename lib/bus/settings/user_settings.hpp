#pragma once

// DDS settings that a user has in the environment, made for other programs: which of them act on Farrier's processes.
// Farrier chooses interface, addresses of others, ports and sizes of messages itself, and all processes of a robot must
// agree in them. Such settings are set aside. Tracing, threads and the like are honoured.

#include <string>
#include <vector>

#include "bus/network.hpp"

namespace farrier::bus {

enum class SettingUse {
  kHonoured,  ///< acts on Farrier's processes
  kFits,      ///< says what Farrier does anyway
  kSetAside,  ///< does not act on Farrier's processes
};

/// One setting of the environment.
struct UserSetting {
  std::string variable;    ///< "CYCLONEDDS_URI"
  std::string place = {};  ///< "/home/user/cyclone.xml:7"; empty: the variable's own text
  std::string name = {};   ///< "Discovery/ParticipantIndex"; empty: the variable as a whole
  std::string value = {};
  SettingUse use = SettingUse::kSetAside;
  std::string reason = {};  ///< why, and what to do instead where there is something
};

/// "CYCLONEDDS_URI, cyclone.xml:7, Discovery/ParticipantIndex none: set aside, ..."
std::string to_string(const UserSetting& setting);

/// A user's settings of Cyclone DDS.
struct CycloneSettings {
  std::string config;  ///< XML of those that are honoured, for any domain; empty for none
  std::vector<UserSetting> settings;
};

/// Reads what CYCLONEDDS_URI says, a list of XML texts and of files with commas between. A file that cannot be read or is
/// not well formed is set aside as a whole. Elements for other domains are left out.
CycloneSettings cyclone_settings(const std::string& uri, const NetworkOptions& network);

/// All settings of this process's environment that a DDS program may read, for Cyclone DDS, Fast DDS and ROS 2.
std::vector<UserSetting> user_settings(const NetworkOptions& network);

/// The lines of user_settings() that are not of use kFits, each behind `prefix`.
std::string lines_of_user_settings(const NetworkOptions& network, const std::string& prefix);

/// Removes variables from the environment that would turn Fast DDS's discovery into a server's client. Call before the
/// first Fast DDS participant, while no other thread reads the environment.
void set_aside_discovery_servers();

}  // namespace farrier::bus
