#include "tests/fuzz/harness.hpp"

namespace farrier::fuzz {

std::span<const Harness> harnesses() noexcept {
  static constexpr Harness kHarnesses[] = {
      {"arrow_fault", arrow_fault},
      {"robot_file", robot_file},
      {"scene_file", scene_file},
      {"recording", recording},
      {"scaled_recording", scaled_recording},
      {"trace", trace},
      {"run_file", run_file},
      {"log_times", log_times},
      {"dds_settings", dds_settings},
      {"description", description},
      {"foxglove_text", foxglove_text},
      {"urdf_file", urdf_file},
      {"cyclone_codec", cyclone_codec},
      {"fast_codec", fast_codec},
      {"cyclone_datagram", cyclone_datagram},
      {"journal", journal},
      {"ros_message", ros_message},
      {"ports", ports},
      {"joint_node", joint_node},
      {"estimator_service", estimator_service},
      {"supervisor", supervisor},
  };
  return kHarnesses;
}

}  // namespace farrier::fuzz
