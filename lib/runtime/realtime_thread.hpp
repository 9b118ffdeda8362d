#pragma once

#include <sys/types.h>

#include <string>

namespace farrier::runtime {

/// SCHED_FIFO priorities of a process on the real-time clock: the control loop comes before the thread that talks to
/// the bus, whose priority the vendor's threads inherit when it creates them. Processes that are not on the way from
/// sensor to valve come after both: FIFO threads of one priority do not take turns.
inline constexpr int kControlPriority = 80;
inline constexpr int kBusPriority = 60;
inline constexpr int kServicePriority = 40;
/// Priority of all threads of a process that starts: its work until it takes part must not delay running processes.
inline constexpr int kJoiningPriority = kServicePriority;
/// Priority of a sender thread with data that no loop waits for: below every thread on the way from sensor to valve.
inline constexpr int kLeisurePriority = 50;
/// Priority of threads outside the robot that must not wait for it: a watch over the computer, a cable in a test.
inline constexpr int kWatchPriority = kControlPriority + 10;

/// Name of the calling thread, at most 15 characters, as ps -L and a debugger show it.
void name_thread(const char* name) noexcept;

/// Gives the calling thread, and threads it creates from now on, a SCHED_FIFO priority. If the system's limits forbid
/// it, the thread runs on without. Returns what was refused; empty if nothing was.
std::string set_priority(int priority);

/// Takes the calling thread's priority away.
void set_no_priority() noexcept;

/// Lets all other work of this computer go before the calling thread and those it creates from now on: nice 19.
void give_way() noexcept;

/// Gives every thread of this process that has the SCHED_FIFO priority `from` the priority `to`.
void raise_threads(int from, int to) noexcept;

/// The calling thread, as the kernel numbers it.
pid_t thread_id() noexcept;

/// The same for any thread of this process that still runs, at the cost of one system call. Returns false on failure.
bool set_priority_of(pid_t thread, int priority) noexcept;

/// Stacks of threads that are created from now on, so that locking them takes little: unless told 8 MiB each.
void use_small_stacks() noexcept;

/// Locks the process's memory and touches the calling thread's stack, so that a loop meets no page fault. Returns as
/// set_priority.
std::string lock_memory();

}  // namespace farrier::runtime
