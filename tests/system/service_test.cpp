// Processes started as systemd would start them, from the units that farrier deploy renders: what they tell it, and
// that the watchdog is fed only while a process's loop turns.

#include <gtest/gtest.h>
#include <sys/ptrace.h>
#include <sys/socket.h>
#include <sys/un.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cstring>
#include <fstream>
#include <map>
#include <memory>
#include <sstream>

#include "core/processes.hpp"
#include "farrier_command.hpp"
#include "tools/deploy/rendered_folder.hpp"

namespace farrier::test {
namespace service_test {

using namespace std::chrono_literals;
using Clock = std::chrono::steady_clock;

constexpr const char* kWatchdog_us = "800000";
constexpr auto kWatchdog = 800ms;
/// For a computer that is busy with other things.
constexpr auto kPatience = 30s;

/// systemd's end of the notifications.
class FakeManager {
 public:
  explicit FakeManager(const std::string& path)
      : path_(path), socket_(::socket(AF_UNIX, SOCK_DGRAM | SOCK_CLOEXEC, 0)) {
    sockaddr_un name{};
    name.sun_family = AF_UNIX;
    std::strncpy(name.sun_path, path.c_str(), sizeof name.sun_path - 1);
    const int on = 1;
    ::setsockopt(socket_, SOL_SOCKET, SO_PASSCRED, &on, sizeof on);
    EXPECT_EQ(::bind(socket_, reinterpret_cast<const sockaddr*>(&name), sizeof name), 0) << path;
  }
  ~FakeManager() { ::close(socket_); }
  FakeManager(const FakeManager&) = delete;
  FakeManager& operator=(const FakeManager&) = delete;

  const std::string& path() const { return path_; }

  /// Listens for that long, or until a process says `text`; whether it did.
  bool hears(pid_t process, const std::string& text, std::chrono::milliseconds how_long = kPatience) {
    const auto until = Clock::now() + how_long;
    while (Clock::now() < until) {
      if (const auto [from, said] = next(); from == process && said.find(text) != std::string::npos) {
        return true;
      }
    }
    return false;
  }
  /// Listens to nobody for that long.
  void forget(std::chrono::milliseconds how_long) {
    for (const auto until = Clock::now() + how_long; Clock::now() < until;) {
      next();
    }
  }

 private:
  /// The next notification and who sent it; nobody when none comes within 20 ms.
  std::pair<pid_t, std::string> next() {
    timeval wait{0, 20000};
    ::setsockopt(socket_, SOL_SOCKET, SO_RCVTIMEO, &wait, sizeof wait);
    char text[512];
    char control[CMSG_SPACE(sizeof(ucred))];
    iovec into{text, sizeof text};
    msghdr message{};
    message.msg_iov = &into;
    message.msg_iovlen = 1;
    message.msg_control = control;
    message.msg_controllen = sizeof control;
    const ssize_t length = ::recvmsg(socket_, &message, 0);
    if (length < 0) {
      return {0, ""};
    }
    ucred sender{};
    std::memcpy(&sender, CMSG_DATA(CMSG_FIRSTHDR(&message)), sizeof sender);
    return {sender.pid, std::string(text, static_cast<std::size_t>(length))};
  }

  std::string path_;
  int socket_;
};

/// The rig on one host, as an integrator would write it.
std::string rig_with_deployment(const std::string& clock) {
  std::string file = read_file(FARRIER_ROBOTS "/fc1d.yaml") +
                     "\ndeployment:\n  domain: " + std::to_string(20 + ::getpid() % 80) + "\n  clock: " + clock +
                     "\n  hosts:\n    rig:\n      address: 127.0.0.1\n      interface: lo\n      processes:\n";
  for (const ProgramInfo& one : kPrograms) {
    const char* const joints = one.program == Program::kJointNode ? ", joints: [fc1d]" : "";
    file += std::string("        ") + one.name + ": {program: " + one.name + joints + "}\n";
  }
  return file;
}

/// The processes of the rig, each started from its unit.
class Rig {
 public:
  explicit Rig(const std::string& clock) : manager_(scratch_.file("notify")) {
    const std::string text = rig_with_deployment(clock);
    const deploy::Places places{.prefix = FARRIER_PREFIX, .folder = scratch_.file("units")};
    const auto robot = robot::load_robot_text(text, "rig.yaml");
    EXPECT_TRUE(robot.ok()) << (robot ? "" : config::to_string(robot.error()));
    const auto files = deploy::render_host(robot.value(), text, "rig", places);
    EXPECT_TRUE(files.ok() && deploy::write_folder(places.folder, files.value(), "").ok());
  }

  void start(const std::string& process) {
    std::istringstream unit(read_file(scratch_.file("units/farrier-fc1d-" + process + ".service")));
    std::vector<std::string> words;
    for (std::string line; std::getline(unit, line);) {
      if (line.starts_with("ExecStart=")) {
        std::istringstream command(line.substr(std::strlen("ExecStart=")));
        for (std::string word; command >> word;) {
          words.push_back(word == "\"\"" ? "" : word);
        }
      }
    }
    ASSERT_FALSE(words.empty()) << process;
    const auto as_systemd = [this] {
      ::setenv("NOTIFY_SOCKET", manager_.path().c_str(), 1);
      ::setenv("WATCHDOG_USEC", kWatchdog_us, 1);
      ::setenv("WATCHDOG_PID", std::to_string(::getpid()).c_str(), 1);
    };
    processes_[process] = std::make_unique<FarrierCommand>(std::vector(words.begin() + 1, words.end()),
                                                           Surroundings{words.front(), as_systemd});
  }
  void start_all() {
    for (const char* process : kAll) {
      start(process);
    }
  }

  FarrierCommand& process(const std::string& name) { return *processes_.at(name); }
  pid_t pid(const std::string& name) { return process(name).pid(); }
  FakeManager& manager() { return manager_; }

  static inline const std::vector<const char*> kAll = [] {
    std::vector<const char*> names;
    for (const ProgramInfo& one : kPrograms) {
      names.push_back(one.name);
    }
    return names;
  }();

 private:
  ScratchDirectory scratch_;
  FakeManager manager_;
  std::map<std::string, std::unique_ptr<FarrierCommand>> processes_;
};

/// The thread of that name; 0 when there is none.
pid_t thread_of(pid_t process, const std::string& name) {
  for (const auto& task : std::filesystem::directory_iterator("/proc/" + std::to_string(process) + "/task")) {
    if (read_file(task.path() / "comm") == name + "\n") {
      return static_cast<pid_t>(std::stol(task.path().filename().string()));
    }
  }
  return 0;
}

/// Holds one thread of a process as a debugger does, while the others run on.
class HeldThread {
 public:
  explicit HeldThread(pid_t thread) : thread_(thread) {
    held_ = ::ptrace(PTRACE_SEIZE, thread_, nullptr, nullptr) == 0 &&
            ::ptrace(PTRACE_INTERRUPT, thread_, nullptr, nullptr) == 0 &&
            ::waitpid(thread_, nullptr, __WALL) == thread_;
  }
  ~HeldThread() {
    if (held_) {
      ::ptrace(PTRACE_DETACH, thread_, nullptr, nullptr);
    }
  }
  HeldThread(const HeldThread&) = delete;
  HeldThread& operator=(const HeldThread&) = delete;
  bool held() const { return held_; }

 private:
  pid_t thread_;
  bool held_ = false;
};

class Service : public testing::TestWithParam<const char*> {};

TEST_P(Service, IsReadyWhenAllHaveGreetedAndNotBefore) {
  Rig rig(GetParam());
  for (const char* const process : Rig::kAll) {
    if (std::string_view(process) != to_string(Program::kJointNode)) {
      rig.start(process);
    }
  }
  EXPECT_TRUE(rig.manager().hears(rig.pid("supervisor"), "STATUS=waiting for "));
  EXPECT_FALSE(rig.manager().hears(rig.pid("supervisor"), "READY=1", 1s));
  rig.start("joint_node");
  EXPECT_TRUE(rig.manager().hears(rig.pid("supervisor"), "READY=1"));
}

TEST_P(Service, FeedsTheWatchdogInEveryProcess) {
  Rig rig(GetParam());
  rig.start_all();
  for (const char* const process : Rig::kAll) {
    EXPECT_TRUE(rig.manager().hears(rig.pid(process), "WATCHDOG=1")) << process;
  }
}

TEST_P(Service, SaysThatItStopsWhenItIsTold) {
  Rig rig(GetParam());
  rig.start_all();
  ASSERT_TRUE(rig.manager().hears(rig.pid("joint_node"), "WATCHDOG=1"));
  rig.process("joint_node").signal(SIGTERM);
  EXPECT_TRUE(rig.manager().hears(rig.pid("joint_node"), "STOPPING=1"));
  EXPECT_EQ(rig.process("joint_node").wait(), 0);
}

INSTANTIATE_TEST_SUITE_P(On, Service, testing::Values("realtime", "lockstep"),
                         [](const auto& clock) { return std::string(clock.param); });

// A process that hangs must not look well because another of its threads still runs.
TEST(Watchdog, IsNotFedWhileTheControlLoopStandsAndIsAgainWhenItTurns) {
  Rig rig("realtime");
  rig.start_all();
  const pid_t node = rig.pid("joint_node");
  ASSERT_TRUE(rig.manager().hears(node, "WATCHDOG=1"));
  const pid_t control = thread_of(node, "control");
  ASSERT_NE(control, 0);
  {
    const HeldThread debugger(control);
    if (!debugger.held()) {
      GTEST_SKIP() << "a thread cannot be held here: " << std::strerror(errno);
    }
    rig.manager().forget(kWatchdog / 2);  // what the loop did before it was held may be fed for once
    EXPECT_FALSE(rig.manager().hears(node, "WATCHDOG=1", 2 * kWatchdog)) << "systemd would not notice";
    EXPECT_TRUE(rig.manager().hears(rig.pid("sim_bridge"), "WATCHDOG=1")) << "the others are well";
  }
  EXPECT_TRUE(rig.manager().hears(node, "WATCHDOG=1"));
}

// In lock-step every process waits for a blocked one; that is no reason to kill them.
TEST(Watchdog, IsFedWhileAProcessWaitsForAnother) {
  Rig rig("lockstep");
  rig.start_all();
  ASSERT_TRUE(rig.manager().hears(rig.pid("sim_bridge"), "WATCHDOG=1"));
  rig.process("joint_node").signal(SIGSTOP);
  rig.manager().forget(kWatchdog / 2);
  EXPECT_FALSE(rig.manager().hears(rig.pid("joint_node"), "WATCHDOG=1", kWatchdog));
  EXPECT_TRUE(rig.manager().hears(rig.pid("sim_bridge"), "WATCHDOG=1"));
  rig.process("joint_node").signal(SIGCONT);
}

}  // namespace service_test
}  // namespace farrier::test
