#include "joint_node/fault_events.hpp"

namespace farrier::joint_node {
namespace {

constexpr Tick kClampedLingers = 100;

}  // namespace

std::optional<std::string> FaultEvents::update(Tick tick, FaultSet faults) {
  faults.set(Fault::kValveSaturated, false);
  if (faults.has(Fault::kReferenceClamped)) {
    last_clamped_ = tick;
  }
  faults.set(Fault::kReferenceClamped, last_clamped_ != kNoTick && tick - last_clamped_ < kClampedLingers);
  if (faults == reported_) {
    return std::nullopt;
  }
  reported_ = faults;
  return faults.any() ? to_string(faults) : std::string("well again");
}

}  // namespace farrier::joint_node
