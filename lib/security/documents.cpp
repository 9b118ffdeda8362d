#include "security/documents.hpp"

#include <vector>

#include "bus/topics.hpp"

namespace farrier::security {
namespace {

constexpr std::time_t kDay = 24 * 60 * 60;

/// One element on a line of its own, or with other elements inside, which begin with a new line.
std::string element(const std::string& name, const std::string& content) {
  return "<" + name + ">" + content + "</" + name + ">\n";
}

std::string group(const std::string& name, const std::string& content) { return element(name, "\n" + content); }

std::string document(const std::string& schema, const std::string& content) {
  return "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n"
         "<dds xmlns:xsi=\"http://www.w3.org/2001/XMLSchema-instance\" xsi:noNamespaceSchemaLocation="
         "\"http://www.omg.org/spec/DDS-SECURITY/20170901/" +
         schema + "\">\n" + content + "</dds>\n";
}

/// All that Cyclone's parser takes, which are two fewer than there are: runs of farrier trot pick a free one.
std::string all_domains() {
  return group("domains", group("id_range", element("min", "0") + element("max", "230")));
}

std::string date(std::time_t time) {
  std::tm parts{};
  ::gmtime_r(&time, &parts);
  char text[32];
  std::strftime(text, sizeof text, "%Y-%m-%dT%H:%M:%S", &parts);
  return text;
}

/// Topics of one route with the partitions they travel in; nothing when there are none.
std::string access(const std::string& what, const std::vector<std::string>& names, const std::string& partition) {
  if (names.empty()) {
    return {};
  }
  std::string topics;
  for (const std::string& name : names) {
    topics += element("topic", name);
  }
  return group(what, group("topics", topics) + group("partitions", element("partition", partition)));
}

/// Those topics of either route that `allowed` picks.
template <class Allowed>
std::string access(const std::string& what, const std::string& robot, Allowed allowed) {
  std::string out;
  for (const bus::Route route : {bus::Route::kRobot, bus::Route::kLeg}) {
    std::vector<std::string> names;
    for (const bus::TopicSpec& topic : bus::topics()) {
      if (topic.route == route && allowed(topic)) {
        names.push_back(topic.name);
      }
    }
    out += access(what, names, route == bus::Route::kRobot ? bus::partition(robot) : bus::partition(robot, "*"));
  }
  return out;
}

}  // namespace

std::string governance_document() {
  const std::string topics =
      group("topic_rule", element("topic_expression", "*") + element("enable_discovery_protection", "false") +
                              element("enable_liveliness_protection", "false") +
                              element("enable_read_access_control", "true") +
                              element("enable_write_access_control", "true") +
                              element("metadata_protection_kind", "NONE") + element("data_protection_kind", "NONE"));
  // RTPS protection covers discovery, liveliness and data at once. Data protection alone does not: Fast DDS 2.9 then
  // does not match Cyclone's readers.
  return document("omg_shared_ca_governance.xsd",
                  group("domain_access_rules",
                        group("domain_rule", all_domains() + element("allow_unauthenticated_participants", "false") +
                                                 element("enable_join_access_control", "true") +
                                                 element("discovery_protection_kind", "NONE") +
                                                 element("liveliness_protection_kind", "NONE") +
                                                 element("rtps_protection_kind", "ENCRYPT") +
                                                 group("topic_access_rules", topics))));
}

std::string permissions_document(const std::string& subject, bus::Role role, const std::string& robot,
                                 std::time_t not_before, std::time_t not_after) {
  const std::string rule =
      all_domains() +
      access("publish", robot, [role](const bus::TopicSpec& topic) { return topic.writers.contains(role); }) +
      access("subscribe", robot, [](const bus::TopicSpec&) { return true; });
  return document(
      "omg_shared_ca_permissions.xsd",
      group("permissions", "<grant name=\"" + std::string(bus::to_string(role)) + "\">\n" +
                               element("subject_name", subject) +
                               group("validity", element("not_before", date(not_before - kDay)) +
                                                     element("not_after", date(not_after + kDay))) +
                               group("allow_rule", rule) + element("default", "DENY") + "</grant>\n"));
}

}  // namespace farrier::security
