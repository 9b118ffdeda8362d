#pragma once

#include <sys/types.h>

#include <chrono>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "core/result.hpp"

namespace farrier::cli {

/// A process this one started. It is killed when this object goes, and by the kernel when this process dies.
class ChildProcess {
 public:
  /// Properties of the child that this process does not have.
  struct Surroundings {
    std::vector<std::string> environment;  ///< `NAME=value`
    std::optional<int> processor;          ///< the only one it may run on
  };

  /// Starts `executable` with its standard output and error going to `log_path`.
  static Result<ChildProcess> start(const std::string& name, const std::string& executable,
                                    const std::vector<std::string>& arguments, const std::string& log_path,
                                    const Surroundings& surroundings = {});
  ~ChildProcess();
  ChildProcess(ChildProcess&& other) noexcept;
  ChildProcess& operator=(ChildProcess&& other) noexcept;

  /// True while it runs.
  bool running();
  /// Asks it to end (SIGTERM).
  void terminate();
  /// Ends it (SIGKILL) if it still runs.
  void kill();
  /// Returns how it ended, with its log and its last lines: "joint_node_lf (pid 12) ended with exit status 2; its log
  /// ...".
  std::string epitaph();

  /// True while it is stopped by a debugger, Ctrl-Z or SIGSTOP.
  bool stopped() const;

  const std::string& name() const noexcept { return name_; }
  pid_t pid() const noexcept { return pid_; }
  int exit_status() const noexcept { return exit_status_; }
  const std::string& log_path() const noexcept { return log_path_; }
  /// Waits until its log has `words`. Refuses when it has ended or `budget` is over before.
  Result<Done> wait_for_words(const std::string& words, std::chrono::seconds budget);
  /// The last line of its log, empty when there is none.
  std::string last_line() const;
  /// The last line of its log, empty if it has printed nothing for `silence`.
  std::string last_words(std::chrono::seconds silence) const;

 private:
  ChildProcess(std::string name, std::string log_path, pid_t pid)
      : name_(std::move(name)), log_path_(std::move(log_path)), pid_(pid) {}

  std::string name_;
  std::string log_path_;
  pid_t pid_;
  bool ended_ = false;
  int exit_status_ = 0;  ///< as a shell counts: 128 + signal when killed by one
};

/// Ends all of them: SIGTERM, then SIGKILL for those that do not end within two seconds. Returns the epitaphs of those
/// with a status outside `well`; empty if all did well.
std::string end_all(std::vector<ChildProcess>& children, const std::set<int>& well = {0});

}  // namespace farrier::cli
