#include "bus/roles.hpp"

namespace farrier::bus {

const char* to_string(Role role) noexcept {
  switch (role) {
#define FARRIER_PROCESS(constant, program, number, needed, made) \
  case Role::constant:                                           \
    return #program;
#include "core/processes.def"
#undef FARRIER_PROCESS
    case Role::kLauncher:
      return "launcher";
    case Role::kOperator:
      return "operator";
    case Role::kMonitor:
      return "monitor";
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
