#pragma once

#include <array>
#include <cstdint>

namespace farrier {

/// The programs of a robot's processes, as core/processes.def lists them.
enum class Program : std::uint8_t {
#define FARRIER_PROCESS(constant, program, number, needed, made) constant,
#include "core/processes.def"
#undef FARRIER_PROCESS
};

struct ProgramInfo {
  Program program;
  const char* name;      ///< of the executable, and of the process where there is one
  std::uint16_t number;  ///< of the participant; of joint nodes the first
  bool needed;           ///< a run in real time ends when the process does
};

inline constexpr std::array kPrograms{
#define FARRIER_PROCESS(constant, program, number, needed, made) \
  ProgramInfo{Program::constant, #program, number, needed},
#include "core/processes.def"
#undef FARRIER_PROCESS
};

constexpr const ProgramInfo& info(Program program) noexcept { return kPrograms[static_cast<std::size_t>(program)]; }

/// Name of the executable: "joint_node".
constexpr const char* to_string(Program program) noexcept { return info(program).name; }

}  // namespace farrier
