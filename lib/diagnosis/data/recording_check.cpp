#include "diagnosis/data/recording_check.hpp"

#include "diagnosis/judge/finding_text.hpp"
#include "diagnosis/data/recording_sensors.hpp"
#include "diagnosis/data/recording_units.hpp"

namespace farrier::diagnosis {

std::vector<Finding> check_recording(const Recording& recording, const robot::Joint& joint) {
  std::vector<Finding> findings = check_units(recording, joint);
  const std::vector<Finding> of_sensors = check_sensors(recording, joint);
  findings.insert(findings.end(), of_sensors.begin(), of_sensors.end());
  sort_by_line(findings);
  return findings;
}

Recording with_current(Recording recording, const robot::Joint& joint) {
  if (joint.electric && recording.valve_current_A.empty()) {
    const double constant = joint.electric->gear_ratio * joint.electric->torque_constant_Nm_A;
    for (const double torque : recording.torque_command_Nm) {
      recording.valve_current_A.push_back(torque / constant);
    }
  }
  return recording;
}

}  // namespace farrier::diagnosis
