#pragma once

// Decoders and cores fed with bytes nobody meant. A harness runs in two ways: under libFuzzer (preset fuzz), which
// looks for new inputs, and in the test that replays the kept ones with mutations of them (replay_test.cpp).

#include <cstdint>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>

namespace farrier::fuzz {

using Bytes = std::span<const std::uint8_t>;

struct Harness {
  std::string_view name;  ///< of its folder in corpus/, too
  void (*run)(Bytes);     ///< throws Broken where a promise of the code is not kept
};

std::span<const Harness> harnesses() noexcept;

struct Broken : std::logic_error {
  using std::logic_error::logic_error;
};

inline void require(bool holds, const std::string& promise) {
  if (!holds) {
    throw Broken(promise);
  }
}

inline std::string_view text_of(Bytes bytes) { return {reinterpret_cast<const char*>(bytes.data()), bytes.size()}; }

// Text and files.
void arrow_fault(Bytes bytes);
void robot_file(Bytes bytes);
void scene_file(Bytes bytes);
void recording(Bytes bytes);
void scaled_recording(Bytes bytes);
void trace(Bytes bytes);
void run_file(Bytes bytes);
void log_times(Bytes bytes);
void dds_settings(Bytes bytes);
void description(Bytes bytes);
void foxglove_text(Bytes bytes);
void urdf_file(Bytes bytes);

// Samples as they come from the network; the first byte is the topic's number.
void cyclone_codec(Bytes bytes);
void fast_codec(Bytes bytes);
void cyclone_datagram(Bytes bytes);
void journal(Bytes bytes);
void ros_message(Bytes bytes);

// Process cores, with their state, behind signals of any content.
void ports(Bytes bytes);
void joint_node(Bytes bytes);
void estimator_service(Bytes bytes);
void supervisor(Bytes bytes);

}  // namespace farrier::fuzz
