#pragma once

#include "bus/bus.hpp"
#include "participant/application.hpp"

namespace farrier::participant {

/// Makes SIGTERM and SIGINT end run() and makes the process die with its launcher.
void install_signal_handlers();

/// True once SIGTERM or SIGINT came.
bool stop_requested() noexcept;

/// Drives an application in lock-step until SIGTERM; returns the process's exit status. When nothing moves for a
/// while it says on standard error what it waits for.
int run(Application& application, bus::Bus& bus, const char* name);

}  // namespace farrier::participant
