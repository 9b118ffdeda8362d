#include <arpa/inet.h>
#include <ifaddrs.h>
#include <netinet/in.h>

#include <algorithm>
#include <optional>

#include "bus/settings/user_settings.hpp"
#include "bus/settings/xml_elements.hpp"

namespace farrier::bus {
namespace {

using tinyxml2::XMLElement;

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
  explicit Reader(const NetworkOptions& network) : network_(network) { domain_.SetAttribute("Id", "any"); }

  void read(const Result<XmlPtr>& parsed, const std::string& file) {
    file_ = file;
    if (!parsed) {
      result_.settings.push_back({.variable = kCyclone, .place = file, .reason = parsed.error().message});
      return;
    }
    for_each_element(*parsed.value(), [this](const XMLElement& root) {
      if (same_name(root.Name(), "CycloneDDS")) {
        for_each_element(root, [this](const XMLElement& child) { read_domain_or_section(child); });
      } else {
        read_domain_or_section(root);
      }
    });
  }

  CycloneSettings result() && {
    if (!domain_.NoChildren()) {
      tinyxml2::XMLPrinter printer(nullptr, true);
      config_.Print(&printer);
      result_.config = printer.CStr();
    }
    return std::move(result_);
  }

 private:
  void read_domain_or_section(const XMLElement& element) {
    if (!same_name(element.Name(), "Domain")) {
      read_section(element);
      return;
    }
    const std::string id = attribute_of(element, "Id");
    if (id.empty() || same_name(id, "any") || id == std::to_string(network_.domain)) {
      for_each_element(element, [this](const XMLElement& section) { read_section(section); });
    }
  }

  void read_section(const XMLElement& section) {
    XMLElement* honoured = nullptr;
    const bool internal = same_name(section.Name(), "Unsupported") || same_name(section.Name(), "Internal");
    const std::string section_name = internal ? "Internal" : section.Name();
    for_each_element(section, [&](const XMLElement& element) {
      const std::string name = std::string(section.Name()) + "/" + element.Name();
      const std::string text = text_of(element);
      const Rule* const rule = rule_of(section_name, element.Name());
      if (same_name(name, "General/Interfaces")) {
        for_each_element(element, [&](const XMLElement& interface) {
          const std::string by_name = attribute_of(interface, "name");
          add_interface(interface, name + "/" + interface.Name(),
                        by_name.empty() ? attribute_of(interface, "address") : by_name);
        });
      } else if (same_name(name, "General/NetworkInterfaceAddress")) {
        add_interface(element, name, text);
      } else {
        UserSetting setting = setting_of(element, name, text);
        if (rule == nullptr) {
          setting.use = SettingUse::kHonoured;
          honoured = honoured == nullptr ? domain_.InsertNewChildElement(section.Name()) : honoured;
          honoured->InsertEndChild(element.DeepClone(&config_));
        } else {
          const bool fits = rule->fits != nullptr && same_name(text, rule->fits);
          setting.use = fits ? SettingUse::kFits : SettingUse::kSetAside;
          setting.reason = rule->reason;
        }
        result_.settings.push_back(std::move(setting));
      }
    });
  }

  void add_interface(const XMLElement& element, const std::string& name, const std::string& value) {
    result_.settings.push_back(judge_interface(setting_of(element, name, value), network_));
  }

  UserSetting setting_of(const XMLElement& element, const std::string& name, const std::string& value) const {
    return {.variable = kCyclone,
            .place = file_.empty() ? "" : file_ + ":" + std::to_string(element.GetLineNum()),
            .name = name,
            .value = value};
  }

  const NetworkOptions& network_;
  std::string file_;
  tinyxml2::XMLDocument config_;
  XMLElement& domain_ = *config_.InsertEndChild(config_.NewElement("CycloneDDS"))
                             ->InsertEndChild(config_.NewElement("Domain"))
                             ->ToElement();
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
      reader.read(parse_xml(std::string_view(uri).substr(at, end - at)), "");
      at = end;
    } else {
      const std::size_t end = std::min(uri.find(',', at), uri.size());
      std::string path = uri.substr(at, end - at);
      path = path.starts_with("file://") ? path.substr(7) : path;
      path.erase(path.find_last_not_of(" \t\r\n") + 1);
      reader.read(parse_xml_file(path), path);
      at = end;
    }
  }
  return std::move(reader).result();
}

}  // namespace farrier::bus
