#pragma once

#include "bus/topics.hpp"

namespace farrier::bus {

/// What somebody asks for who only watches, on either clock: no stream's writer waits for him, and what was announced
/// before he came is told him.
Qos qos_for_watching(const TopicSpec& topic);

}  // namespace farrier::bus
