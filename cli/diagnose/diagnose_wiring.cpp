#include "cli/diagnose/diagnose_wiring.hpp"

#include <utility>

#include "cli/base/long_work.hpp"
#include "diagnosis/data/recording_check.hpp"
#include "diagnosis/data/trace_recording.hpp"
#include "tools/offline/joint_recording.hpp"

namespace farrier::cli {
namespace {

/// Recordings of the robot's other joints of the same kind in the same file; none of a file of one joint.
std::vector<diagnosis::OtherJoint> others_of(const DiagnoseOptions& o, const robot::Robot& robot,
                                             const robot::Joint& joint) {
  std::vector<diagnosis::OtherJoint> others;
  const auto each = [&](auto&& read) {
    for (const robot::Joint& other : robot.joints) {
      if (other.name != joint.name && other.electric.has_value() == joint.electric.has_value()) {
        read(other);
      }
    }
  };
  if (playback::is_recording(o.recording)) {
    if (auto run = playback::RecordedRun::open(o.recording, {}, long_work("diagnose, reading other joints"))) {
      const playback::Measurements measured = playback::read_measurements(run.value());
      each([&](const robot::Joint& other) {
        if (const robot::Joint* const recorded = run.value().robot().find(other.name)) {
          others.push_back({other.name, offline::joint_recording(measured, run.value().robot(), *recorded)});
        }
      });
    }
    return others;
  }
  const bool trace = diagnosis::is_trace(o.recording);
  each([&](const robot::Joint& other) {
    auto recording = trace ? diagnosis::recording_of_trace(o.recording, robot, other)
                           : diagnosis::read_recording(o.recording, other.name);
    if (recording) {
      others.push_back({other.name, diagnosis::with_current(std::move(recording).value(), other)});
    }
  });
  return others;
}

}  // namespace

WiringOfRecording wiring_of(const DiagnoseOptions& options, const robot::Robot& robot, const robot::Joint& joint,
                            const diagnosis::Recording& recording) {
  std::vector<diagnosis::OtherJoint> others;
  if (robot.joints.size() > 1 && diagnosis::may_be_of_another_joint(recording, joint)) {
    others = others_of(options, robot, joint);
  }
  WiringOfRecording wiring{diagnosis::find_wiring(recording, joint, others), {}};
  if (!wiring.answers.empty()) {
    wiring.evidence = diagnosis::wiring_evidence(recording, joint, wiring.answers.front().fault, others);
  }
  return wiring;
}

}  // namespace farrier::cli
