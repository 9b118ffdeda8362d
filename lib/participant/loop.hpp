#pragma once

#include "participant/application.hpp"
#include "participant/participant.hpp"

namespace farrier::participant {

/// Makes SIGTERM, SIGINT and SIGHUP end run(). SIGHUP that is ignored or handled already stays so.
void install_signal_handlers();

/// True once SIGTERM, SIGINT or SIGHUP came.
bool stop_requested() noexcept;

/// Exit status of a program that SIGHUP, SIGINT or SIGTERM ended, as shells count: 129, 130 or 143; 0 before.
int stop_status() noexcept;

/// Exit status of a process after its run: 0, or 1 with the reason on standard error if it could not take part.
int end_status(const Participant& member);

/// SCHED_FIFO priority of a process's threads until the run has begun for it, and from then on; equal: it stays.
struct Promotion {
  int from = 0, to = 0;
};

/// Drives an application by one thread that polls it whenever samples arrive, until SIGTERM or until the participant
/// cannot take part. Returns the process's exit status, 0 or 1. If nothing moves for a while, it prints on standard
/// error which input it waits for. Notifies systemd when the run has begun, and from then on while the loop turns.
int run(Application& application, Participant& member, const Promotion& promotion);

}  // namespace farrier::participant
