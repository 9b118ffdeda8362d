#include "bus/qos_text.hpp"
#include "bus/topics.hpp"

namespace farrier::bus {
namespace {

std::string milliseconds(Nanoseconds time) {
  return time == kInfinite ? "none"
                           : std::to_string(std::chrono::duration_cast<std::chrono::milliseconds>(time).count()) + " ms";
}

}  // namespace

std::string qos_text(const Qos& qos, bool with_history) {
  std::string text = qos.reliability == Reliability::kReliable ? "reliable" : "best effort";
  text += with_history ? ", keep last " + std::to_string(qos.history_depth) : "";
  text += qos.durability == Durability::kTransientLocal ? ", transient local" : "";
  text += qos.deadline == kInfinite ? "" : ", deadline " + milliseconds(qos.deadline);
  text += qos.lease == kInfinite ? "" : ", manual liveliness " + milliseconds(qos.lease);
  text += qos.ownership == Ownership::kExclusive ? ", exclusive" : "";
  return text;
}

std::string topics_table_markdown() {
  std::string table =
      "| topic | file | from → to | key | version | reaches | QoS in real time | QoS in lock-step |\n"
      "|---|---|---|---|---|---|---|---|\n";
  for (const TopicSpec& topic : topics()) {
    table += std::string("| `") + topic.name + "` | [" + topic.idl + "](" + topic.idl + ") | " + to_string(topic.writers) + " → " +
             topic.readers + " | " +
             topic.key + " | " + std::to_string(topic.version) + " | " +
             (topic.route == Route::kRobot ? "the robot" : "the leg's hosts") + " | " + qos_text(topic.realtime) +
             " | " + qos_text(qos_for(topic, ClockKind::kLockstep)) + " |\n";
  }
  return table;
}

}  // namespace farrier::bus
