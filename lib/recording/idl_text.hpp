#pragma once

#include "bus/topics.hpp"

namespace farrier::recording {

/// The file of a topic in idl/, as this version was built with.
const char* idl_text(bus::TopicId topic);

}  // namespace farrier::recording
