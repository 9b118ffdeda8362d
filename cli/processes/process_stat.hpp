#pragma once

#include <sys/types.h>

#include <optional>

namespace farrier::cli {

/// State of a process as Linux reports it (proc_pid_stat(5)).
struct ProcessStat {
  char state = '?';          ///< T: stopped, t: traced
  double processor_s = 0.0;  ///< used so far, in its own code and in the kernel
};

/// None where there is no such process.
std::optional<ProcessStat> process_stat(pid_t process);

/// True while a debugger, or another tracer, is attached to the process (proc_pid_status(5)).
bool is_traced(pid_t process);

}  // namespace farrier::cli
