#include "bus/topics.hpp"

namespace farrier::bus {
namespace {

std::string milliseconds(Nanoseconds time) {
  return time == kInfinite ? "none"
                           : std::to_string(std::chrono::duration_cast<std::chrono::milliseconds>(time).count()) + " ms";
}

std::string describe(const Qos& qos) {
  std::string text = qos.reliability == Reliability::kReliable ? "reliable" : "best effort";
  text += ", keep last " + std::to_string(qos.history_depth);
  text += qos.durability == Durability::kTransientLocal ? ", transient local" : "";
  text += qos.deadline == kInfinite ? "" : ", deadline " + milliseconds(qos.deadline);
  text += qos.lease == kInfinite ? "" : ", manual liveliness " + milliseconds(qos.lease);
  text += qos.ownership == Ownership::kExclusive ? ", exclusive" : "";
  return text;
}

}  // namespace

std::string topics_table_markdown() {
  std::string table =
      "| topic | file | from → to | key | version | reaches | QoS in real time | QoS in lock-step |\n"
      "|---|---|---|---|---|---|---|---|\n";
  for (const TopicSpec& topic : topics()) {
    table += std::string("| `") + topic.name + "` | [" + topic.idl + "](" + topic.idl + ") | " + to_string(topic.writers) + " → " +
             topic.readers + " | " +
             topic.key + " | " + std::to_string(topic.version) + " | " +
             (topic.route == Route::kRobot ? "the robot" : "the leg's hosts") + " | " + describe(topic.realtime) +
             " | " + describe(qos_for(topic, ClockKind::kLockstep)) + " |\n";
  }
  return table;
}

}  // namespace farrier::bus
