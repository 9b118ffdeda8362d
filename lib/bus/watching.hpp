#pragma once

#include "bus/topics.hpp"

namespace farrier::bus {

/// What somebody asks for who only watches, on either clock: no stream's writer waits for him, and what was announced
/// before he came is told him. `depth`: samples of a key that are kept until he looks.
Qos qos_for_watching(const TopicSpec& topic, int depth);

}  // namespace farrier::bus
