#include "bus/settings/user_settings.hpp"

#include <cstdlib>
#include <filesystem>

#include "bus/settings/xml_elements.hpp"

namespace farrier::bus {
namespace {

constexpr const char* kServers[] = {"ROS_DISCOVERY_SERVER", "ROS_SUPER_CLIENT", "FASTDDS_ENVIRONMENT_FILE"};
constexpr const char* kDefaultProfiles =
    "DEFAULT_FASTRTPS_PROFILES.xml";  // which Fast DDS reads where a process starts

std::string value_of(const char* variable) {
  const char* const value = std::getenv(variable);
  return value == nullptr ? "" : value;
}

bool is_loopback(const std::string& address) { return address.starts_with("127."); }

/// The profiles of a file with their lines, which Farrier's participants and endpoints do not use.
void add_profiles(const std::string& variable, const std::string& path, std::vector<UserSetting>& settings) {
  const auto add = [&](const std::string& place, const std::string& name, const std::string& value,
                       const std::string& reason) {
    settings.push_back({.variable = variable, .place = place, .name = name, .value = value, .reason = reason});
  };
  const auto parsed = parse_xml_file(path);
  if (!parsed) {
    add(path, "", "", parsed.error().message);
    return;
  }
  constexpr const char* kOwn = "Farrier's participants and endpoints have settings of their own";
  const std::size_t before = settings.size();
  const auto add_group = [&](const tinyxml2::XMLElement& group) {
    for_each_element(group, [&](const tinyxml2::XMLElement& profile) {
      add(path + ":" + std::to_string(profile.GetLineNum()), std::string(group.Name()) + "/" + profile.Name(),
          attribute_of(profile, "profile_name"), kOwn);
    });
  };
  for_each_element(*parsed.value(), [&](const tinyxml2::XMLElement& root) {
    if (same_name(root.Name(), "dds")) {
      for_each_element(root, add_group);
    } else {
      add_group(root);
    }
  });
  if (settings.size() == before) {
    add(path, "", "", kOwn);
  }
}

void add_ros(const NetworkOptions& network, std::vector<UserSetting>& settings) {
  const auto add = [&](const char* variable, bool fits, const std::string& reason) {
    settings.push_back({.variable = variable,
                        .value = value_of(variable),
                        .use = fits ? SettingUse::kFits : SettingUse::kSetAside,
                        .reason = reason});
  };
  const bool local = is_loopback(network.address);
  if (const std::string only = value_of("ROS_LOCALHOST_ONLY"); !only.empty() && only != "0") {
    add("ROS_LOCALHOST_ONLY", local, "--address " + network.address + " chooses the interface");
  }
  if (const std::string range = value_of("ROS_AUTOMATIC_DISCOVERY_RANGE"); !range.empty()) {
    const bool fits = range == "SYSTEM_DEFAULT" || local == (range == "LOCALHOST" || range == "OFF");
    add("ROS_AUTOMATIC_DISCOVERY_RANGE", fits, "--address and --peers say where processes are searched");
  }
  if (!value_of("ROS_STATIC_PEERS").empty()) {
    add("ROS_STATIC_PEERS", false, "--peers names the computers");
  }
}

}  // namespace

std::string to_string(const UserSetting& setting) {
  std::string text = setting.variable;
  text += setting.place.empty() ? "" : ", " + setting.place;
  text += setting.name.empty() ? "" : ", " + setting.name;
  text += setting.value.empty() ? "" : (setting.name.empty() ? "=" : " ") + setting.value;
  switch (setting.use) {
    case SettingUse::kHonoured:
      return text + ": honoured";
    case SettingUse::kFits:
      return text + ": fits, " + setting.reason;
    case SettingUse::kSetAside:
      break;
  }
  return text + ": set aside, " + setting.reason;
}

std::vector<UserSetting> user_settings(const NetworkOptions& network) {
  std::vector<UserSetting> settings;
  if (const std::string uri = value_of("CYCLONEDDS_URI"); !uri.empty()) {
    settings = cyclone_settings(uri, network).settings;
  }
  for (const char* variable : {"FASTRTPS_DEFAULT_PROFILES_FILE", "FASTDDS_DEFAULT_PROFILES_FILE"}) {
    if (const std::string path = value_of(variable); !path.empty()) {
      add_profiles(variable, path, settings);
    }
  }
  std::error_code none;
  if (value_of("SKIP_DEFAULT_XML") != "1" && std::filesystem::exists(kDefaultProfiles, none)) {
    add_profiles("the working directory", kDefaultProfiles, settings);
  }
  for (const char* variable : kServers) {
    if (const std::string value = value_of(variable); !value.empty()) {
      settings.push_back({.variable = variable,
                          .value = value,
                          .reason = "processes find each other without a discovery server, at --address and --peers"});
    }
  }
  add_ros(network, settings);
  return settings;
}

std::string lines_of_user_settings(const NetworkOptions& network, const std::string& prefix) {
  std::string lines;
  for (const UserSetting& setting : user_settings(network)) {
    lines += setting.use == SettingUse::kFits ? "" : prefix + to_string(setting) + "\n";
  }
  return lines;
}

void set_aside_discovery_servers() {
  for (const char* variable : kServers) {
    if (std::getenv(variable) != nullptr) {
      ::unsetenv(variable);
    }
  }
}

}  // namespace farrier::bus
