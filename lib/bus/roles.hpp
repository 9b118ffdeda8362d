#pragma once

#include <array>
#include <cstdint>
#include <initializer_list>
#include <string>

#include "core/processes.hpp"

namespace farrier::bus {

/// Decides which topics a process may write. The first roles are the programs of core/processes.def.
enum class Role : std::uint8_t {
#define FARRIER_PROCESS(constant, program, number, needed, made) constant,
#include "core/processes.def"
#undef FARRIER_PROCESS
  kLauncher,  ///< starts the processes of a run on one computer, and listens to it
  kOperator,  ///< asks the supervisor to arm or to stop
  kMonitor,   ///< only reads
};

/// Every role, in order.
inline constexpr std::array kRoles{
#define FARRIER_PROCESS(constant, program, number, needed, made) Role::constant,
#include "core/processes.def"
#undef FARRIER_PROCESS
    Role::kLauncher, Role::kOperator, Role::kMonitor};

constexpr Role role_of(Program program) noexcept { return static_cast<Role>(program); }

const char* to_string(Role role) noexcept;

class RoleSet {
 public:
  constexpr RoleSet(std::initializer_list<Role> roles) noexcept {
    for (const Role role : roles) {
      bits_ |= bit(role);
    }
  }
  /// The roles of this set without one.
  constexpr RoleSet without(Role role) const noexcept {
    RoleSet rest = *this;
    rest.bits_ &= ~bit(role);
    return rest;
  }
  constexpr bool contains(Role role) const noexcept { return (bits_ & bit(role)) != 0; }
  friend constexpr bool operator==(RoleSet, RoleSet) = default;

 private:
  static constexpr unsigned bit(Role role) noexcept { return 1u << static_cast<unsigned>(role); }

  unsigned bits_ = 0;
};

/// Those that take part in a run.
inline constexpr RoleSet kParticipantRoles{
#define FARRIER_PROCESS(constant, program, number, needed, made) Role::constant,
#include "core/processes.def"
#undef FARRIER_PROCESS
    Role::kLauncher};

/// For people: the roles' names, or "all" for those that take part in a run.
std::string to_string(RoleSet roles);

}  // namespace farrier::bus
