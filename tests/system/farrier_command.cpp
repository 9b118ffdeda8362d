#include "farrier_command.hpp"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <csignal>
#include <cstdlib>
#include <fstream>
#include <sstream>
#include <thread>

namespace farrier::test {
namespace {

using namespace std::chrono_literals;
using Clock = std::chrono::steady_clock;

/// The words of a process's command line; empty when it is gone.
std::vector<std::string> command_line(const std::filesystem::path& process) {
  std::ifstream file(process / "cmdline", std::ios::binary);
  std::vector<std::string> words;
  for (std::string word; std::getline(file, word, '\0');) {
    words.push_back(word);
  }
  return words;
}

bool follows(const std::vector<std::string>& words, const std::string& flag, const std::string& value) {
  const auto place = std::find(words.begin(), words.end(), flag);
  return place != words.end() && place + 1 != words.end() && *(place + 1) == value;
}

template <class Use>
void for_each_process(Use&& use) {
  for (const auto& entry : std::filesystem::directory_iterator("/proc")) {
    const std::string name = entry.path().filename().string();
    if (std::all_of(name.begin(), name.end(), [](unsigned char c) { return std::isdigit(c) != 0; })) {
      use(static_cast<pid_t>(std::stol(name)), command_line(entry.path()));
    }
  }
}

const char* setting(const char* name, const char* otherwise) {
  const char* value = std::getenv(name);
  return value != nullptr ? value : otherwise;
}

}  // namespace

std::vector<const char*> tested_vendors(const char* otherwise) {
  const std::string chosen = setting("FARRIER_TEST_VENDORS", otherwise);
  std::vector<const char*> vendors;
  for (const char* vendor : {"cyclone", "fast", "mixed"}) {
    if (chosen.find(vendor) != std::string::npos) {
      vendors.push_back(vendor);
    }
  }
  return vendors;
}

const char* tested_duration(const char* otherwise) { return setting("FARRIER_TEST_DURATION_S", otherwise); }

FarrierCommand::FarrierCommand(const std::vector<std::string>& arguments, const Surroundings& surroundings) {
  const std::string log = scratch_.file("output");
  std::vector<char*> argv{const_cast<char*>(surroundings.executable.c_str())};
  for (const std::string& argument : arguments) {
    argv.push_back(const_cast<char*>(argument.c_str()));
  }
  argv.push_back(nullptr);
  const int file = ::open(log.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0600);
  pid_ = ::fork();
  if (pid_ == 0) {
    ::prctl(PR_SET_PDEATHSIG, SIGKILL);  // a test that crashes leaves no run behind
    ::dup2(file, STDOUT_FILENO);
    ::dup2(file, STDERR_FILENO);
    if (surroundings.prepare) {
      surroundings.prepare();
    }
    ::execv(argv.front(), argv.data());
    ::_exit(127);
  }
  ::close(file);
}

FarrierCommand::~FarrierCommand() {
  if (!ended_) {
    ::kill(pid_, SIGKILL);
    ::waitpid(pid_, nullptr, 0);
  }
}

int FarrierCommand::wait(std::chrono::seconds budget) {
  const auto until = Clock::now() + budget;
  int status = 0;
  while (Clock::now() < until) {
    if (::waitpid(pid_, &status, WNOHANG) == pid_) {
      ended_ = true;
      return WIFSIGNALED(status) ? 128 + WTERMSIG(status) : WEXITSTATUS(status);
    }
    std::this_thread::sleep_for(10ms);
  }
  return -1;
}

void FarrierCommand::signal(int number) const { ::kill(pid_, number); }

pid_t FarrierCommand::process(const std::string& name) const {
  const auto until = Clock::now() + 30s;
  while (Clock::now() < until) {
    pid_t found = 0;
    for_each_process([&](pid_t pid, const std::vector<std::string>& words) {
      if (follows(words, "--name", name) && follows(words, "--session", std::to_string(pid_))) {
        found = pid;
      }
    });
    if (found != 0) {
      return found;
    }
    std::this_thread::sleep_for(5ms);
  }
  return 0;
}

bool FarrierCommand::says(const std::string& text, std::chrono::seconds budget) const {
  const auto until = Clock::now() + budget;
  while (Clock::now() < until) {
    if (output().find(text) != std::string::npos) {
      return true;
    }
    std::this_thread::sleep_for(5ms);
  }
  return false;
}

std::string FarrierCommand::output() const { return read_file(scratch_.file("output")); }

int FarrierCommand::domain() const {
  const std::string command_line = read_file("/proc/" + std::to_string(process("supervisor")) + "/cmdline");
  const std::string option = std::string("--domain") + '\0';
  const std::size_t at = command_line.find(option);
  EXPECT_NE(at, std::string::npos) << "no supervisor with --domain";
  return at == std::string::npos ? -1 : std::atoi(command_line.c_str() + at + option.size());
}

void FarrierCommand::renice(int value) const {
  std::vector<pid_t> processes = processes_of_session(pid_);
  processes.push_back(pid_);
  for (const pid_t process : processes) {
    std::error_code ended;  // of a process, meanwhile
    std::filesystem::directory_iterator thread("/proc/" + std::to_string(process) + "/task", ended);
    for (; thread != std::filesystem::directory_iterator(); thread.increment(ended)) {
      ::setpriority(PRIO_PROCESS, static_cast<id_t>(std::stol(thread->path().filename().string())), value);
    }
  }
}

std::vector<pid_t> processes_of_session(pid_t launcher) {
  std::vector<pid_t> found;
  for_each_process([&](pid_t pid, const std::vector<std::string>& words) {
    if (follows(words, "--session", std::to_string(launcher))) {
      found.push_back(pid);
    }
  });
  return found;
}

int run_farrier(const std::vector<std::string>& arguments, std::string* output, const Surroundings& surroundings) {
  FarrierCommand command(arguments, surroundings);
  const int status = command.wait();
  if (output != nullptr) {
    *output = command.output();
  }
  return status;
}

std::string trace_of_trot(const std::vector<std::string>& options) {
  const ScratchDirectory scratch;
  std::vector<std::string> arguments{"trot",  "--world",           "bench",   "--no-comparison",
                                     "--out", scratch.file("out"), "--trace", scratch.file("trace.csv")};
  arguments.insert(arguments.end(), options.begin(), options.end());
  std::string output;
  run_farrier(arguments, &output);
  const std::string trace = read_file(scratch.file("trace.csv"));
  EXPECT_FALSE(trace.empty()) << output;
  return trace;
}

std::string read_file(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  std::ostringstream text;
  text << file.rdbuf();
  return text.str();
}

nlohmann::json read_json(const std::string& path) { return nlohmann::json::parse(read_file(path), nullptr, false); }

double figure(const nlohmann::json& run, const std::string& name) {
  for (const auto& entry : run["figures"]) {
    if (entry["name"] == name) {
      return entry["value"].is_null() ? NAN : entry["value"].get<double>();
    }
  }
  ADD_FAILURE() << "no figure " << name;
  return NAN;
}

}  // namespace farrier::test
