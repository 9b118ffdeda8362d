// farrier drive at a terminal, which the test plays.

#include <fcntl.h>
#include <gtest/gtest.h>
#include <stdlib.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <csignal>
#include <string>
#include <thread>

#include "tests/system/farrier_command.hpp"

namespace farrier::test {
namespace drive_test {

using namespace std::chrono_literals;

/// A terminal whose far end is the test.
class Terminal {
 public:
  Terminal() : far_(::posix_openpt(O_RDWR | O_NOCTTY)) {
    ::grantpt(far_);
    ::unlockpt(far_);
  }
  ~Terminal() { hang_up(); }
  Terminal(const Terminal&) = delete;
  Terminal& operator=(const Terminal&) = delete;

  /// For the process of the command: standard input is this terminal.
  void take_over() const {
    const int near = ::open(::ptsname(far_), O_RDWR | O_NOCTTY);
    ::dup2(near, STDIN_FILENO);
    ::close(near);
    ::close(far_);
  }
  void press(const std::string& keys) const { ASSERT_EQ(::write(far_, keys.data(), keys.size()), std::ssize(keys)); }
  void hang_up() {
    if (far_ >= 0) {
      ::close(far_);
    }
    far_ = -1;
  }

 private:
  int far_;
};

TEST(Drive, StopsTheRobotAndEndsWhenItsTerminalIsLost) {
  const ScratchDirectory scratch;
  Terminal terminal;
  FarrierCommand drive({"drive", "--no-page", "--out", scratch.file("out")},
                       {FARRIER_COMMAND, [&terminal] { terminal.take_over(); }});
  ASSERT_TRUE(drive.says("lie, asked to lie", 30s)) << drive.output();
  terminal.press("www");
  ASSERT_TRUE(drive.says("trot, forward 0.3 m/s", 30s)) << drive.output();
  terminal.hang_up();
  EXPECT_NE(drive.wait(40s), -1) << drive.output();
  EXPECT_NE(drive.output().find("the robot did not fall"), std::string::npos) << drive.output();
  EXPECT_NE(drive.output().find("the terminal was lost"), std::string::npos) << drive.output();
  EXPECT_TRUE(processes_of_session(drive.pid()).empty());
}

TEST(Drive, RefusesAStandardInputThatIsNoTerminal) {
  std::string output;
  const int status = run_farrier({"drive", "--no-page"}, &output, {FARRIER_COMMAND, [] {
                                                                     const int none = ::open("/dev/null", O_RDONLY);
                                                                     ::dup2(none, STDIN_FILENO);
                                                                   }});
  EXPECT_EQ(status, 2);
  EXPECT_NE(output.find("standard input is none"), std::string::npos) << output;
}

}  // namespace drive_test
}  // namespace farrier::test
