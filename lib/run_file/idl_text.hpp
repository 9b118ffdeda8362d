#pragma once

#include "bus/topics.hpp"

namespace farrier::run_file {

/// The file of a topic in idl/, as this version was built with.
const char* idl_text(bus::TopicId topic);

}  // namespace farrier::run_file
