#include <arpa/inet.h>
#include <ifaddrs.h>
#include <netinet/in.h>

#include <algorithm>
#include <optional>

#include "bus/settings/user_settings.hpp"
#include "bus/settings/xml_elements.hpp"

namespace farrier::bus {
namespace {

constexpr const char* kCyclone = "CYCLONEDDS_URI";

/// A section of a domain, or an element in one, that is set aside.
struct Rule {
  const char* section;
  const char* element;  ///< null: every other one of the section
  const char* fits;     ///< value that says what Farrier does anyway; null for none
  const char* reason;
};

constexpr const char* kAddress = "--address chooses the one interface";
constexpr const char* kSearch = "processes search each other at --address and --peers";
constexpr const char* kSizes = "the sizes of messages are those of Farrier's samples";
constexpr const char* kTiming = "the times are those of Farrier's control";
constexpr const char* kSecurity = "--security secures a robot";
constexpr const char* kUdp = "processes use UDP alone";

constexpr Rule kRules[] = {
    {"General", "AllowMulticast", "false", "processes use unicast alone"},
    {"General", "Transport", "udp", kUdp},
    {"General", "FragmentSize", nullptr, kSizes},
    {"General", "MaxMessageSize", nullptr, kSizes},
    {"General", "MaxRexmitMessageSize", nullptr, kSizes},
    {"General", "EntityAutoNaming", nullptr, nullptr},
    {"General", "MulticastTimeToLive", nullptr, nullptr},
    {"General", nullptr, nullptr, kAddress},
    {"Discovery", "ParticipantIndex", "auto", "each process has a port at which the others search it"},
    {"Discovery", nullptr, nullptr, kSearch},
    {"Internal", "MultipleReceiveThreads", "true", kTiming},
    {"Internal", "WriteBatch", "true", kTiming},
    {"Internal", "HeartbeatInterval", nullptr, kTiming},
    {"Internal", "NackDelay", nullptr, kTiming},
    {"Internal", "AckDelay", nullptr, kTiming},
    {"Internal", "PreEmptiveAckDelay", nullptr, kTiming},
    {"Internal", "WriterLingerDuration", nullptr, kTiming},
    {"SharedMemory", nullptr, "false", kUdp},
    {"Security", nullptr, nullptr, kSecurity},
    {"DDSSecurity", nullptr, nullptr, kSecurity},
    {"TCP", nullptr, "false", kUdp},
    {"SSL", nullptr, "false", kUdp},
    {"Partitioning", nullptr, nullptr, "processes use unicast alone"},
    {"Compatibility", nullptr, nullptr, "processes of both vendors understand each other as they are"},
};

const Rule* rule_of(const std::string& section, const std::string& element) {
  for (const Rule& rule : kRules) {
    if (same_name(rule.section, section) && (rule.element == nullptr || same_name(rule.element, element))) {
      return rule.reason == nullptr ? nullptr : &rule;
    }
  }
  return nullptr;
}

/// IPv4 addresses of an interface of that name or address; empty for none.
std::vector<std::string> addresses_of(const std::string& interface) {
  std::vector<std::string> found;
  ifaddrs* all = nullptr;
  if (::getifaddrs(&all) != 0) {
    return found;
  }
  for (const ifaddrs* entry = all; entry != nullptr; entry = entry->ifa_next) {
    if (entry->ifa_addr != nullptr && entry->ifa_addr->sa_family == AF_INET) {
      char text[INET_ADDRSTRLEN] = {};
      ::inet_ntop(AF_INET, &reinterpret_cast<const sockaddr_in*>(entry->ifa_addr)->sin_addr, text, sizeof text);
      if (interface == entry->ifa_name || interface == text) {
        found.emplace_back(text);
      }
    }
  }
  ::freeifaddrs(all);
  return found;
}

/// Judges an interface, by name or address.
UserSetting judge_interface(UserSetting setting, const NetworkOptions& network) {
  const std::vector<std::string> addresses = addresses_of(setting.value);
  const bool same = std::ranges::find(addresses, network.address) != addresses.end();
  setting.use = same ? SettingUse::kFits : SettingUse::kSetAside;
  setting.reason = same ? "the interface of --address " + network.address
                        : std::string(kAddress) +
                              (addresses.empty() ? "" : ": give --address " + addresses.front() + " to use this one");
  return setting;
}

class Reader {
 public:
  explicit Reader(const NetworkOptions& network) : network_(network) {}

  void read_text(std::string_view text, const std::string& file) {
    file_ = file;
    const auto parsed = parse_xml(text);
    if (!parsed) {
      result_.settings.push_back({.variable = kCyclone, .place = file, .reason = parsed.error().message});
      return;
    }
    for (const XmlElement& root : parsed.value()) {
      if (same_name(root.name, "CycloneDDS")) {
        for (const XmlElement& child : root.children) {
          read_domain_or_section(child);
        }
      } else {
        read_domain_or_section(root);
      }
    }
  }

  void read_file(const std::string& path) {
    const auto text = read_settings_file(path);
    if (!text) {
      result_.settings.push_back({.variable = kCyclone, .place = path, .reason = text.error().message});
      return;
    }
    read_text(text.value(), path);
  }

  CycloneSettings result() && {
    if (!result_.config.empty()) {
      result_.config = "<CycloneDDS><Domain Id=\"any\">" + result_.config + "</Domain></CycloneDDS>";
    }
    return std::move(result_);
  }

 private:
  void read_domain_or_section(const XmlElement& element) {
    if (!same_name(element.name, "Domain")) {
      read_section(element);
      return;
    }
    const std::string id = element.attribute("Id");
    if (id.empty() || same_name(id, "any") || id == std::to_string(network_.domain)) {
      for (const XmlElement& section : element.children) {
        read_section(section);
      }
    }
  }

  void read_section(const XmlElement& section) {
    std::string honoured;
    const bool internal = same_name(section.name, "Unsupported") || same_name(section.name, "Internal");
    const std::string name = internal ? "Internal" : section.name;
    for (const XmlElement& element : section.children) {
      const Rule* const rule = rule_of(name, element.name);
      if (same_name(name, "General") && same_name(element.name, "Interfaces")) {
        for (const XmlElement& interface : element.children) {
          const std::string by_name = interface.attribute("name");
          const std::string by_address = interface.attribute("address");
          add_interface(interface, section.name + "/" + element.name + "/" + interface.name,
                        by_name.empty() ? by_address : by_name);
        }
      } else if (same_name(name, "General") && same_name(element.name, "NetworkInterfaceAddress")) {
        add_interface(element, section.name + "/" + element.name, element.text);
      } else {
        UserSetting setting = setting_of(element, section.name + "/" + element.name, element.text);
        if (rule == nullptr) {
          setting.use = SettingUse::kHonoured;
          honoured += element.source;
        } else {
          const bool fits = rule->fits != nullptr && same_name(element.text, rule->fits);
          setting.use = fits ? SettingUse::kFits : SettingUse::kSetAside;
          setting.reason = rule->reason;
        }
        result_.settings.push_back(std::move(setting));
      }
    }
    if (!honoured.empty()) {
      result_.config += "<" + section.name + ">" + honoured + "</" + section.name + ">";
    }
  }

  void add_interface(const XmlElement& element, const std::string& name, const std::string& value) {
    result_.settings.push_back(judge_interface(setting_of(element, name, value), network_));
  }

  UserSetting setting_of(const XmlElement& element, const std::string& name, const std::string& value) const {
    return {.variable = kCyclone,
            .place = file_.empty() ? "" : file_ + ":" + std::to_string(element.line),
            .name = name,
            .value = value};
  }

  const NetworkOptions& network_;
  std::string file_;
  CycloneSettings result_;
};

/// End of the XML text that begins at `from` of a list: behind it comes a comma and no tag, or the list ends.
std::size_t end_of_text(const std::string& uri, std::size_t from) {
  for (std::size_t comma = uri.find(',', from); comma != std::string::npos; comma = uri.find(',', comma + 1)) {
    const std::size_t last = uri.find_last_not_of(" \t\r\n", comma - 1);
    if (last != std::string::npos && last > from && uri[last] == '>' &&
        parse_xml(std::string_view(uri).substr(from, comma - from)).ok()) {
      return comma;
    }
  }
  return uri.size();
}

}  // namespace

CycloneSettings cyclone_settings(const std::string& uri, const NetworkOptions& network) {
  Reader reader(network);
  for (std::size_t at = uri.find_first_not_of(" \t\r\n,"); at != std::string::npos;
       at = uri.find_first_not_of(" \t\r\n,", at)) {
    if (uri[at] == '<') {
      const std::size_t end = end_of_text(uri, at);
      reader.read_text(std::string_view(uri).substr(at, end - at), "");
      at = end;
    } else {
      const std::size_t end = std::min(uri.find(',', at), uri.size());
      std::string path = uri.substr(at, end - at);
      path = path.starts_with("file://") ? path.substr(7) : path;
      reader.read_file(path.substr(0, path.find_last_not_of(" \t\r\n") + 1));
      at = end;
    }
  }
  return std::move(reader).result();
}

}  // namespace farrier::bus
