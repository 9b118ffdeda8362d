#include "bus/watching.hpp"

#include <algorithm>

namespace farrier::bus {

Qos qos_for_watching(const TopicSpec& topic, int depth) {
  Qos qos = topic.realtime;
  qos.reliability = qos.durability == Durability::kVolatile ? Reliability::kBestEffort : Reliability::kReliable;
  qos.history_depth = std::max(qos.history_depth, depth);
  qos.liveliness = Liveliness::kAutomatic;
  qos.lease = kInfinite;
  return qos;
}

}  // namespace farrier::bus
