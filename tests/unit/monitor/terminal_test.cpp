// The table on a terminal, which is a pseudo-terminal of this test's.

#include "tools/monitor/terminal.hpp"

#include <gtest/gtest.h>
#include <poll.h>
#include <pty.h>
#include <sys/wait.h>
#include <termios.h>
#include <unistd.h>
#include <utmp.h>

#include <algorithm>
#include <chrono>
#include <csignal>
#include <functional>
#include <stdexcept>
#include <string>

#include "feed.hpp"
#include "participant/loop.hpp"

namespace farrier::display {
namespace terminal_test {

using namespace monitor::testing;
using Clock = std::chrono::steady_clock;

/// A process whose terminal the test holds the other end of.
class OnTerminal {
 public:
  explicit OnTerminal(const std::function<int()>& run) {
    const winsize size{.ws_row = 40, .ws_col = 150, .ws_xpixel = 0, .ws_ypixel = 0};
    if (::openpty(&end_, &terminal_, nullptr, nullptr, &size) != 0) {
      throw std::runtime_error("no pseudo terminal: is /dev/pts mounted?");
    }
    ::tcgetattr(end_, &before_);
    pid_ = ::fork();
    if (pid_ == 0) {
      ::close(end_);
      ::login_tty(terminal_);
      ::setenv("TERM", "xterm", 1);
      ::_exit(run());
    }
  }
  ~OnTerminal() {
    if (!ended_) {
      ::kill(pid_, SIGKILL);
      ::waitpid(pid_, nullptr, 0);
    }
    ::close(terminal_);
    ::close(end_);
  }
  OnTerminal(const OnTerminal&) = delete;
  OnTerminal& operator=(const OnTerminal&) = delete;

  void type(const std::string& keys) const { EXPECT_EQ(::write(end_, keys.data(), keys.size()), ssize_t(keys.size())); }
  void signal(int number) const { ::kill(pid_, number); }

  /// Reads until the terminal was sent this.
  bool says(const std::string& text) {
    const auto until = Clock::now() + std::chrono::seconds(60);
    while (said_.find(text) == std::string::npos && Clock::now() < until) {
      read();
    }
    return said_.find(text) != std::string::npos;
  }
  void forget() { said_.clear(); }
  const std::string& said() const { return said_; }

  int wait() {
    const auto until = Clock::now() + std::chrono::seconds(60);
    int status = 0;
    while (Clock::now() < until) {
      read();
      if (::waitpid(pid_, &status, WNOHANG) == pid_) {
        ended_ = true;
        while (read()) {
        }
        return WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
      }
    }
    return -1;
  }

  /// True if lines are edited and keys echoed as they were at the beginning.
  bool restored() const {
    termios now{};
    ::tcgetattr(end_, &now);
    return now.c_lflag == before_.c_lflag && now.c_iflag == before_.c_iflag && now.c_oflag == before_.c_oflag;
  }

 private:
  bool read() {
    pollfd waits{.fd = end_, .events = POLLIN, .revents = 0};
    char bytes[4096];
    if (::poll(&waits, 1, 20) <= 0) {
      return false;
    }
    const ssize_t count = ::read(end_, bytes, sizeof bytes);
    said_.append(bytes, static_cast<std::size_t>(std::max<ssize_t>(count, 0)));
    return count > 0;
  }

  int end_ = -1, terminal_ = -1;
  pid_t pid_ = -1;
  bool ended_ = false;
  termios before_{};
  std::string said_;
};

constexpr const char* kOtherScreen = "\033[?1049l";  // xterm: back to the screen from before

/// Shows a walking robot until somebody asks for the end.
int show_until_end() {
  participant::install_signal_handlers();
  Feed feed;
  walk_for_a_second(feed);
  auto terminal = Terminal::create(hyq());
  if (!terminal) {
    return 99;
  }
  for (Tick tick = 1020; !terminal.value()->ended() && !participant::stop_requested(); tick += kTicksPerSummary) {
    feed.walk(tick, 1);
    terminal.value()->show(feed.frame());
    ::usleep(20'000);
  }
  return participant::stop_status();
}

TEST(Terminal, ShowsTheTableAndEndsWithItsKey) {
  OnTerminal command(show_until_end);
  EXPECT_TRUE(command.says("lf_haa")) << command.said();
  EXPECT_TRUE(command.says("rh_kfe")) << command.said();
  command.type("/rf_kfe\r");
  EXPECT_TRUE(command.says("filter: rf_kfe")) << command.said();
  command.type("h");
  EXPECT_TRUE(command.says("sort by the next")) << command.said();
  command.type("q");
  EXPECT_EQ(command.wait(), 0);
  EXPECT_TRUE(command.restored());
  EXPECT_NE(command.said().find(kOtherScreen), std::string::npos);
}

TEST(Terminal, IsItselfAgainAfterASignal) {
  for (const int number : {SIGINT, SIGTERM}) {
    OnTerminal command(show_until_end);
    EXPECT_TRUE(command.says("lf_haa")) << command.said();
    if (number == SIGINT) {
      command.type("\003");  // Ctrl-C
    } else {
      command.signal(number);
    }
    EXPECT_EQ(command.wait(), 128 + number);
    EXPECT_TRUE(command.restored());
    EXPECT_NE(command.said().find(kOtherScreen), std::string::npos);
  }
}

TEST(Terminal, IsItselfAgainAfterAnException) {
  OnTerminal command([] {
    try {
      Feed feed;
      const auto terminal = Terminal::create(hyq());
      terminal.value()->show(feed.frame());
      throw std::runtime_error("something");
    } catch (const std::exception&) {
      return 7;
    }
  });
  EXPECT_EQ(command.wait(), 7);
  EXPECT_TRUE(command.restored());
  EXPECT_NE(command.said().find(kOtherScreen), std::string::npos);
}

TEST(Terminal, RefusesATerminalOfWhichNothingIsKnown) {
  OnTerminal command([] {
    ::setenv("TERM", "of-another-world", 1);
    const auto terminal = Terminal::create(hyq());
    return !terminal && terminal.error().message.find("of-another-world") != std::string::npos ? 7 : 1;
  });
  EXPECT_EQ(command.wait(), 7);
  EXPECT_TRUE(command.restored());
}

TEST(Terminal, RefusesWhatIsNoTerminal) {
  const pid_t child = ::fork();
  if (child == 0) {
    ::close(STDIN_FILENO);
    ::_exit(Terminal::create(hyq()) ? 1 : 7);
  }
  int status = 0;
  ::waitpid(child, &status, 0);
  EXPECT_EQ(WEXITSTATUS(status), 7);
}

}  // namespace terminal_test
}  // namespace farrier::display
