#include "cli/processes/child_process.hpp"

#include <fcntl.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstring>
#include <deque>
#include <filesystem>
#include <fstream>
#include <thread>

#include "runtime/processors.hpp"
#include "runtime/realtime_thread.hpp"
#include "cli/processes/process_stat.hpp"

namespace farrier::cli {
namespace {

using namespace std::chrono_literals;

constexpr std::size_t kLastLines = 5;

std::deque<std::string> last_lines(const std::string& path, std::size_t count) {
  std::deque<std::string> lines;
  std::ifstream file(path);
  for (std::string line; std::getline(file, line);) {
    lines.push_back(line);
    if (lines.size() > count) {
      lines.pop_front();
    }
  }
  return lines;
}

}  // namespace

Result<ChildProcess> ChildProcess::start(const std::string& name, const std::string& executable,
                                         const std::vector<std::string>& arguments, const std::string& log_path,
                                         const Surroundings& surroundings) {
  const int log = ::open(log_path.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0644);
  if (log < 0) {
    return Error{"cannot write " + log_path + ": " + std::strerror(errno)};
  }
  std::vector<char*> argv{const_cast<char*>(executable.c_str())};
  for (const std::string& argument : arguments) {
    argv.push_back(const_cast<char*>(argument.c_str()));
  }
  argv.push_back(nullptr);
  std::vector<char*> envp;
  for (const std::string& variable : surroundings.environment) {
    envp.push_back(const_cast<char*>(variable.c_str()));
  }
  for (char** variable = environ; *variable != nullptr; ++variable) {
    envp.push_back(*variable);
  }
  envp.push_back(nullptr);
  const pid_t self = ::getpid();
  // Not fork: that copies the page tables of all this process has locked in memory, then faults at every page it
  // writes. On the real-time clock it delayed the receive threads of its processor by 8 ms.
  const pid_t pid = ::vfork();  // until execve the child has this process's memory, and this thread waits for it
  if (pid == 0) {
    ::prctl(PR_SET_PDEATHSIG, SIGKILL);
    if (::getppid() != self) {
      ::_exit(127);  // the launcher died before the line above
    }
    // Ctrl-C goes to the launcher alone, which ends its children in order.
    ::setpgid(0, 0);
    if (surroundings.processor) {
      runtime::stay_on(*surroundings.processor);
    }
    ::dup2(log, STDOUT_FILENO);
    ::dup2(log, STDERR_FILENO);
    // Loading a program must not use the launcher's priority: other processes of the run would wait for it.
    runtime::set_no_priority();
    ::execve(executable.c_str(), argv.data(), envp.data());
    ::dprintf(STDERR_FILENO, "cannot run %s: %s\n", executable.c_str(), std::strerror(errno));
    ::_exit(127);
  }
  ::close(log);
  if (pid < 0) {
    return Error{"cannot start " + name + ": " + std::strerror(errno)};
  }
  return ChildProcess(name, log_path, pid);
}

ChildProcess::ChildProcess(ChildProcess&& other) noexcept
    : name_(std::move(other.name_)),
      log_path_(std::move(other.log_path_)),
      pid_(other.pid_),
      ended_(other.ended_),
      exit_status_(other.exit_status_) {
  other.ended_ = true;
}

ChildProcess& ChildProcess::operator=(ChildProcess&& other) noexcept {
  kill();
  name_ = std::move(other.name_);
  log_path_ = std::move(other.log_path_);
  pid_ = other.pid_;
  ended_ = other.ended_;
  exit_status_ = other.exit_status_;
  other.ended_ = true;
  return *this;
}

ChildProcess::~ChildProcess() {
  kill();
}

void ChildProcess::kill() {
  if (running()) {
    ::kill(pid_, SIGKILL);
    int status = 0;
    ::waitpid(pid_, &status, 0);
    ended_ = true;
    exit_status_ = 128 + SIGKILL;
  }
}

bool ChildProcess::running() {
  int status = 0;
  if (!ended_ && ::waitpid(pid_, &status, WNOHANG) == pid_) {
    ended_ = true;
    exit_status_ = WIFSIGNALED(status) ? 128 + WTERMSIG(status) : WEXITSTATUS(status);
  }
  return !ended_;
}

void ChildProcess::terminate() {
  if (running()) {
    ::kill(pid_, SIGTERM);
    ::kill(pid_, SIGCONT);
  }
}

std::string ChildProcess::epitaph() {
  std::string text = name_ + " (pid " + std::to_string(pid_) + ") ended with exit status " +
                     std::to_string(exit_status_);
  if (exit_status_ > 128) {
    text += std::string(", killed by ") + ::strsignal(exit_status_ - 128);
  }
  const auto lines = last_lines(log_path_, kLastLines);
  text += "; its log " + log_path_ + (lines.empty() ? " is empty" : " ends with:");
  for (const std::string& line : lines) {
    text += "\n  " + line;
  }
  return text;
}

bool ChildProcess::stopped() const {
  const auto stat = process_stat(pid_);
  return stat && (stat->state == 'T' || stat->state == 't');
}

std::string ChildProcess::last_line() const {
  const auto lines = last_lines(log_path_, 1);
  return lines.empty() ? std::string() : lines.back();
}

std::string ChildProcess::last_words(std::chrono::seconds silence) const {
  std::error_code unknown;
  const auto written = std::filesystem::last_write_time(log_path_, unknown);
  if (unknown || std::filesystem::file_time_type::clock::now() - written > silence) {
    return {};
  }
  return last_line();
}

Result<Done> ChildProcess::wait_for_words(const std::string& words, std::chrono::seconds budget) {
  const auto until = std::chrono::steady_clock::now() + budget;
  const auto said = [&] {
    std::ifstream log(log_path_);
    const std::string text(std::istreambuf_iterator<char>(log), {});
    return text.find(words) != std::string::npos;
  };
  while (!said()) {
    if (!running()) {
      return Error{epitaph()};
    }
    if (std::chrono::steady_clock::now() > until) {
      return Error{name_ + " (pid " + std::to_string(pid_) + ") has not said '" + words + "' within " +
                   std::to_string(budget.count()) + " s; its log: " + log_path_};
    }
    std::this_thread::sleep_for(5ms);
  }
  return Done{};
}

std::string end_all(std::vector<ChildProcess>& children, const std::set<int>& well) {
  for (ChildProcess& child : children) {
    child.terminate();
  }
  const auto until = std::chrono::steady_clock::now() + 2s;
  std::string hard_ends;
  for (ChildProcess& child : children) {
    while (child.running() && std::chrono::steady_clock::now() < until) {
      std::this_thread::sleep_for(5ms);
    }
    child.kill();
    if (!well.contains(child.exit_status())) {
      hard_ends += (hard_ends.empty() ? "" : "\n") + child.epitaph();
    }
  }
  children.clear();
  return hard_ends;
}

}  // namespace farrier::cli
