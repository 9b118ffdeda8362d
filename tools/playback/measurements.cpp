#include "tools/playback/measurements.hpp"

#include "signals/cdr.hpp"

namespace farrier::playback {

Measurements read_measurements(RecordedRun& run, const recording::TakeSample& others) {
  Measurements all;
  all.joints.resize(run.robot().joints.size());
  recording::Sample sample;
  while (run.next(sample)) {
    all.lockstep = all.lockstep || sample.topic == bus::TopicId::kClockTickDone;
    if (sample.topic != bus::TopicId::kJointMeasurement) {
      if (others) {
        others(sample);
      }
      continue;
    }
    signals::JointMeasurement measurement;
    if (!signals::from_cdr(sample.cdr, measurement) || measurement.joint >= all.joints.size()) {
      continue;
    }
    std::vector<signals::JointMeasurement>& joint = all.joints[measurement.joint];
    if (measurement.tick >= 0 && (joint.empty() || measurement.tick > joint.back().tick)) {
      joint.push_back(measurement);
    } else if (measurement.tick >= 0) {
      ++all.late;
    }
  }
  all.ending = run.ending();
  return all;
}

}  // namespace farrier::playback
