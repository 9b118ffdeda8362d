#pragma once

#include "bus/topics.hpp"

namespace farrier::bus {

/// QoS of an observer, on either clock. Streams are best effort, so no writer waits for it; latched topics still reach
/// late joiners. `depth`: least number of samples per key that are kept until the observer reads.
Qos qos_for_watching(const TopicSpec& topic, int depth);

}  // namespace farrier::bus
