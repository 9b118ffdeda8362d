#pragma once

#include <optional>
#include <vector>

#include "cli/diagnose/diagnose_options.hpp"
#include "diagnosis/wiring/wiring_evidence.hpp"
#include "robot/robot.hpp"

namespace farrier::cli {

/// Faults of wiring, the likeliest first, and evidence for that one.
struct WiringOfRecording {
  std::vector<diagnosis::WiringAnswer> answers;
  std::optional<diagnosis::WiringEvidence> evidence;
};

/// Faults of wiring that the recording of one joint has. If they may be of another joint, the file is read again for the
/// other joints that it has.
WiringOfRecording wiring_of(const DiagnoseOptions& options, const robot::Robot& robot, const robot::Joint& joint,
                            const diagnosis::Recording& recording);

}  // namespace farrier::cli
