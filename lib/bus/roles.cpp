#include "bus/roles.hpp"

namespace farrier::bus {

const char* to_string(Role role) noexcept {
  switch (role) {
    case Role::kSimBridge: return "sim_bridge";
    case Role::kEstimatorService: return "estimator_service";
    case Role::kSupervisor: return "supervisor";
    case Role::kGaitSource: return "gait_source";
    case Role::kJointNode: return "joint_node";
    case Role::kLauncher: return "launcher";
    case Role::kOperator: return "operator";
    case Role::kMonitor: return "monitor";
  }
  return "unknown role";
}

std::string to_string(RoleSet roles) {
  if (roles == kParticipantRoles) {
    return "all";
  }
  std::string names;
  for (const Role role : kRoles) {
    if (roles.contains(role)) {
      names += (names.empty() ? "" : ", ") + std::string(to_string(role));
    }
  }
  return names;
}

}  // namespace farrier::bus
