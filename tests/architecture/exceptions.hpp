#pragma once

// Every exception from the rules that tests/architecture checks, with its reason. One that is no longer needed fails.

#include <string_view>

namespace farrier::architecture {

struct Exception {
  std::string_view path;  ///< a file, or a folder for all below it
  std::string_view reason;
};

/// Where a vendor's or a generated header may be included.
inline constexpr Exception kVendorHeaders[] = {
    {"lib/signals", "the structs and field lists that from_idl writes"},
    {"lib/cyclone_base", "calls of Cyclone DDS that its users share"},
    {"lib/bus_cyclone", "the Cyclone DDS bus"},
    {"lib/bus_fastdds", "the Fast DDS bus"},
    {"lib/ros_messages/messages.hpp", "the structs that ros_from_idl writes"},
    {"lib/bus_ros", "a node of ROS 2 by Cyclone DDS"},
    {"lib/body/engine/mujoco_engine.cpp", "the physics engine"},
    {"tests/unit/urdf/urdf_engine_test.cpp", "has MuJoCo read a URDF by itself"},
    {"tests/ros/wire_test.cpp", "is a program that knows nothing of our nodes"},
    {"tests/ros/fast_sender.cpp", "writes as a node of the other vendor of ROS 2 does"},
    {"tests/fuzz/cyclone_codec.cpp", "feeds bytes to Cyclone's decoder, which no bus exposes"},
    {"tests/contract/wire_bytes_cyclone.cpp", "the same, to hold recordings to what Cyclone reads"},
    {"tests/contract/cyclone_waits_test.cpp", "waits by a call of Cyclone's, which no bus exposes"},
    {"tests/system/doctor_test.cpp",
     "is somebody else's program, with topics and types that no bus of ours would make"},
};

/// Where below lib/ and in process cores a clock may be read or a random number drawn.
inline constexpr Exception kClocks[] = {
    {"lib/participant", "the main loops, the one place where a process meets the clock"},
};

/// Main programs longer than 80 lines.
inline constexpr Exception kLongMains[] = {
    {"", ""},  // none
};

/// Sources longer than 300 lines.
inline constexpr Exception kLongFiles[] = {
    {"", ""},  // none
};

/// Includes of a header whose library is not linked.
inline constexpr Exception kIncludes[] = {
    {"", ""},  // none
};

}  // namespace farrier::architecture
