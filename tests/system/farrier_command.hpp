#pragma once

// Starts the farrier command as a user would and looks at what it leaves: exit status, output, traces, processes.

#include <sys/types.h>

#include <chrono>
#include <filesystem>
#include <functional>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "tests/support/scratch_directory.hpp"

namespace farrier::test {

/// Vendors that this run of the tests takes: those of FARRIER_TEST_VENDORS, "cyclone,fast", where it is set, else
/// `otherwise`.
std::vector<const char*> tested_vendors(const char* otherwise);
/// Duration of a run in seconds: FARRIER_TEST_DURATION_S where it is set, else `otherwise`.
const char* tested_duration(const char* otherwise);

/// Start conditions of a command besides its arguments.
struct Surroundings {
  std::string executable = FARRIER_COMMAND;
  std::function<void()> prepare;  ///< runs in the new process before the command; ending there, it ends with its status
};

/// One running command, farrier unless told otherwise, with its output in a file.
class FarrierCommand {
 public:
  explicit FarrierCommand(const std::vector<std::string>& arguments, const Surroundings& surroundings = {});
  ~FarrierCommand();
  FarrierCommand(const FarrierCommand&) = delete;
  FarrierCommand& operator=(const FarrierCommand&) = delete;

  /// Waits until it ends; its exit status, 128 + signal when killed, -1 when it does not end in time.
  int wait(std::chrono::seconds budget = std::chrono::seconds(120));
  void signal(int number) const;

  /// Process of the run whose command line has `--name <name>`; 0 when there is none within the budget.
  pid_t process(const std::string& name) const;
  /// Waits until the output has `text`; false when it does not come in time.
  bool says(const std::string& text, std::chrono::seconds budget = std::chrono::seconds(60)) const;
  std::string output() const;
  /// DDS domain of a trot that has begun.
  int domain() const;
  pid_t pid() const noexcept { return pid_; }
  /// Gives every thread of it and of the processes of its run this nice value, which 0 to 19 are, where this user may.
  void renice(int value) const;

 private:
  ScratchDirectory scratch_;
  pid_t pid_;
  bool ended_ = false;
};

/// Node processes that name this launcher's session in their command line.
std::vector<pid_t> processes_of_session(pid_t launcher);

/// Runs to the end; the exit status.
int run_farrier(const std::vector<std::string>& arguments, std::string* output = nullptr,
                const Surroundings& surroundings = {});

/// Trace of a trot with these options, in a directory of its own; one that leaves none fails the test.
std::string trace_of_trot(const std::vector<std::string>& options);

std::string read_file(const std::string& path);
nlohmann::json read_json(const std::string& path);

/// Value of a figure of a run; not a number where it is null. One that is not there fails the test.
double figure(const nlohmann::json& run, const std::string& name);

}  // namespace farrier::test
