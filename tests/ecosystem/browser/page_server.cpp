// Serves the page for a browser's test, of a made-up robot or of a recording. Lines of the standard input command the
// made-up robot:
//
//   faults <joint> <bits>     quiet     begin     (a new run; ends quiet)     bench     ground     (says no body; says one).
//
// Usage:
// page_server <page> <robot file> <port> [<recording>]     serves; a line says where
// page_server --record <robot file> <recording>            makes one of twelve seconds

#include <poll.h>
#include <unistd.h>

#include <cstdio>
#include <iostream>
#include <sstream>
#include <thread>

#include "monitor/robot_view.hpp"
#include "participant/clock.hpp"
#include "participant/loop.hpp"
#include "tests/support/made_up_robot.hpp"
#include "tools/web/recorded_frames.hpp"
#include "tools/web/web_display.hpp"

namespace farrier::test {
namespace {

using namespace std::chrono_literals;

constexpr std::uint64_t kStep_ns = 20'000'000;

int fail(const std::string& why) {
  std::fprintf(stderr, "page_server: %s\n", why.c_str());
  return 1;
}

void tell(const std::string& url) {
  std::printf("%s\n", url.c_str());
  std::fflush(stdout);
}

int serve_recording(const std::string& path, const display::ListenAddress& address, web::PageFiles page) {
  auto frames = web::RecordedFrames::read(path);
  if (!frames) {
    return fail(frames.error().message);
  }
  auto server = web::WebServer::create(
      address, web::RecordedFrames::site(std::make_shared<const web::RecordedFrames>(std::move(frames).value()),
                                         std::move(page)));
  if (!server) {
    return fail(server.error().message);
  }
  tell(server.value()->url());
  while (!participant::stop_requested()) {
    std::this_thread::sleep_for(50ms);
  }
  return 0;
}

/// Does what a line says. False: the input has ended.
bool obey(const robot::Robot& robot, MadeUpRobot& made_up, bool& quiet, std::uint64_t now_ns) {
  pollfd input{STDIN_FILENO, POLLIN, 0};
  std::string line;
  if (std::cin.rdbuf()->in_avail() <= 0 && ::poll(&input, 1, 0) <= 0) {
    return true;
  }
  if (!std::getline(std::cin, line)) {
    return false;
  }
  std::istringstream words(line);
  std::string verb, joint;
  std::uint32_t bits = 0;
  words >> verb >> joint >> bits;
  if (verb == "faults" && robot.find(joint) != nullptr) {
    made_up.set_faults(robot.find(joint)->number, bits, now_ns);
  } else if (verb == "quiet") {
    quiet = true;
  } else if (verb == "bench" || verb == "ground") {
    made_up.stand_on_bench(verb == "bench");
  } else if (verb == "begin") {
    quiet = false;
    made_up.begin(now_ns, now_ns);
  }
  return true;
}

int serve_robot(const robot::Robot& robot, const display::ListenAddress& address, web::PageFiles page) {
  auto display = web::WebDisplay::create(address, std::move(page), robot);
  if (!display) {
    return fail(display.error().message);
  }
  monitor::RobotView view(robot);
  MadeUpRobot made_up(robot, [&](const recording::Sample& sample) { view.take(sample); });
  std::uint64_t said_ns = participant::date_now_ns();
  bool quiet = false;
  made_up.begin(1, said_ns);
  tell(display.value()->url());
  while (!participant::stop_requested()) {
    std::this_thread::sleep_for(50ms);
    const std::uint64_t now_ns = participant::date_now_ns();
    if (!obey(robot, made_up, quiet, now_ns)) {
      break;
    }
    for (; said_ns + kStep_ns <= now_ns; said_ns += kStep_ns) {
      if (!quiet) {
        made_up.step(said_ns + kStep_ns);
      }
    }
    display.value()->show(view.frame(participant::date_now_ns()));
  }
  return 0;
}

int run(const std::vector<std::string>& arguments) {
  if (arguments.size() < 3) {
    return fail("<page> <robot file> <port> [<recording>]");
  }
  std::ios::sync_with_stdio(false);  // or nobody knows that a second line is there already
  participant::install_signal_handlers();
  const auto robot = robot::load_robot(arguments[1]);
  if (!robot) {
    return fail(config::to_string(robot.error()));
  }
  if (arguments[0] == "--record") {
    write_made_up_recording(arguments[2], robot.value(), 12);
    return 0;
  }
  auto page = web::read_page(arguments[0]);
  if (!page) {
    return fail(page.error().message);
  }
  const display::ListenAddress address{"127.0.0.1", static_cast<std::uint16_t>(std::stoi(arguments[2])), false};
  return arguments.size() > 3 ? serve_recording(arguments[3], address, std::move(page).value())
                              : serve_robot(robot.value(), address, std::move(page).value());
}

}  // namespace
}  // namespace farrier::test

int main(int argc, char** argv) { return farrier::test::run({argv + 1, argv + argc}); }
