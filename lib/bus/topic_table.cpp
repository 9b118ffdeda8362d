#include "bus/qos_text.hpp"
#include "bus/topics.hpp"

namespace farrier::bus {
namespace {

std::string milliseconds(Nanoseconds time) {
  return time == kInfinite
             ? "none"
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
      "# Topics\n\n"
      "Each file declares the struct of one topic. The build writes the C++ structs, field lists, keys and the hash "
      "of\n"
      "the contract from these files ([decision](../docs/decisions/0060-idl-is-the-source.md)).\n\n"
      "- The first line names the topic: `// Topic 3: joint/measurement, version 2.` Numbers have no gaps. The "
      "version\n"
      "  rises with every change of the fields or of their meaning.\n"
      "- The second line names writers and readers: `// joint_node -> estimator_service: the measurement.`\n"
      "- The struct is `@final`. Its first fields are its `@key`. Types are `octet`, `char`, `double`, the signed and\n"
      "  unsigned `short`, `long` and `long long`, arrays of these, and `sequence<octet, N>` as the last field.\n"
      "- A `long long` with the name `tick` or `..._tick` counts control periods. It is -1 for none.\n"
      "- An `octet` whose comment begins with `enum Phase:` is a `Phase` of `signals/words.hpp` in C++.\n"
      "- A comment behind a field, or in the lines before it, becomes the comment of the C++ field.\n\n"
      "The page [Add a sensor channel](../docs/how-to/new-sensor-channel.md) adds a field to a topic.\n\n"
      "| topic | file | from → to | key | version | reaches | QoS in real time | QoS in lock-step |\n"
      "|---|---|---|---|---|---|---|---|\n";
  for (const TopicSpec& topic : topics()) {
    table += std::string("| `") + topic.name + "` | [" + topic.idl + "](" + topic.idl + ") | " +
             to_string(topic.writers) + " → " + topic.readers + " | " + topic.key + " | " +
             std::to_string(topic.version) + " | " + (topic.route == Route::kRobot ? "the robot" : "the leg's hosts") +
             " | " + qos_text(topic.realtime) + " | " + qos_text(qos_for(topic, ClockKind::kLockstep)) + " |\n";
  }
  return table;
}

}  // namespace farrier::bus
