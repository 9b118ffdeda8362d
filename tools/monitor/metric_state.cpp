#include "tools/monitor/metric_state.hpp"

namespace farrier::display {

void MetricState::take(const monitor::Frame& next, double time_s) {
  frame = next;
  frame_time_s = time_s;
  start_time_s = start_time_s > 0.0 ? start_time_s : time_s;
  for (const monitor::EventFrame& event : next.events) {
    if (const auto severity = static_cast<std::size_t>(event.severity); severity < events.size()) {
      ++events[severity];
    }
  }
  fault_onsets.resize(next.joints.size());
  last_faults.resize(next.joints.size());
  for (std::size_t joint = 0; joint < next.joints.size(); ++joint) {
    for (const signals::JointSummary& summary : next.joints[joint].summaries) {
      const FaultSet begun(summary.faults & ~last_faults[joint]);
      for (std::size_t i = 0; i < kFaults.size(); ++i) {
        fault_onsets[joint][i] += begun.has(kFaults[i].fault) ? 1 : 0;
      }
      last_faults[joint] = summary.faults;
    }
    frame.joints[joint].summaries.clear();
  }
}

}  // namespace farrier::display
