#pragma once

// The functions that make processes of the robot file, the world and a number of ticks alone: those that core/processes.def lists as
// `plain`. Each process defines its function in the namespace of its program.

#include <memory>

#include "core/processes.hpp"
#include "core/result.hpp"
#include "participant/application.hpp"
#include "participant/options.hpp"
#include "participant/participant.hpp"

namespace farrier::robot {
struct Robot;
}

#define FARRIER_DECLARE_plain(program)                                                                        \
  namespace farrier::program {                                                                                \
  /* Opens the ports of the process. With `ticks` 0 it runs until told to stop. */                            \
  Result<std::unique_ptr<participant::Application>> create_application(const robot::Robot& robot,             \
                                                                       participant::World world,              \
                                                                       participant::Participant& participant, \
                                                                       Tick ticks);                           \
  }
#define FARRIER_DECLARE_specially(program)
#define FARRIER_PROCESS(constant, program, number, needed, made) FARRIER_DECLARE_##made(program)
#include "core/processes.def"
#undef FARRIER_PROCESS
#undef FARRIER_DECLARE_specially
#undef FARRIER_DECLARE_plain
