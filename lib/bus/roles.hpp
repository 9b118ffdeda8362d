#pragma once

#include <array>
#include <cstdint>
#include <initializer_list>
#include <string>

namespace farrier::bus {

/// What a process is to the robot: it decides which topics the process may write.
enum class Role : std::uint8_t {
  kSimBridge,
  kEstimatorService,
  kSupervisor,
  kGaitSource,
  kJointNode,
  kLauncher,  ///< starts the processes of a run on one computer, and listens to it
  kOperator,  ///< asks the supervisor to arm or to stop
  kMonitor,   ///< only reads
};

inline constexpr std::array kRoles{Role::kSimBridge, Role::kEstimatorService, Role::kSupervisor, Role::kGaitSource,
                                   Role::kJointNode, Role::kLauncher,         Role::kOperator,   Role::kMonitor};

const char* to_string(Role role) noexcept;

class RoleSet {
 public:
  constexpr RoleSet(std::initializer_list<Role> roles) noexcept {
    for (const Role role : roles) {
      bits_ |= bit(role);
    }
  }
  constexpr bool contains(Role role) const noexcept { return (bits_ & bit(role)) != 0; }
  friend constexpr bool operator==(RoleSet, RoleSet) = default;

 private:
  static constexpr unsigned bit(Role role) noexcept { return 1u << static_cast<unsigned>(role); }

  unsigned bits_ = 0;
};

/// Those that take part in a run.
inline constexpr RoleSet kParticipantRoles{Role::kSimBridge, Role::kEstimatorService, Role::kSupervisor,
                                           Role::kGaitSource, Role::kJointNode,        Role::kLauncher};

/// For people: the roles' names, or "all" for those that take part in a run.
std::string to_string(RoleSet roles);

}  // namespace farrier::bus
