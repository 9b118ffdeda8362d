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

}  // namespace farrier::diagnosis
