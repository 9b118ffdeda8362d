#pragma once

#include "tests/ros/sender.hpp"

namespace farrier::test {

/// True if this build has Fast DDS.
bool has_fast_sender();

/// Sender on Fast DDS, as rmw_fastrtps makes one.
std::unique_ptr<Sender> make_fast_sender(int domain, const std::string& topic, const std::string& type, bool reliable);

}  // namespace farrier::test
