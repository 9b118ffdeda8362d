#include "joint_node/fault_events.hpp"

namespace farrier::joint_node {
namespace {

std::string event_text(FaultSet faults) {
  std::string text;
  for (const FaultInfo& info : kFaults) {
    if (faults.has(info.fault)) {
      text += (text.empty() ? "" : ", ") + std::string(info.event_text());
    }
  }
  return faults.any() ? text : "no fault";
}

}  // namespace

std::optional<std::string> FaultEvents::update(Tick tick, FaultSet faults) {
  FaultSet present;
  for (std::size_t row = 0; row < kFaults.size(); ++row) {
    const FaultInfo& info = kFaults[row];
    if (faults.has(info.fault)) {
      last_[row] = tick;
    }
    const bool lingers = last_[row] != kNoTick && tick - last_[row] < info.event.lingers;
    present.set(info.fault, info.event.reported && (faults.has(info.fault) || lingers));
  }
  if (present == reported_) {
    return std::nullopt;
  }
  reported_ = present;
  return event_text(present);
}

}  // namespace farrier::joint_node
