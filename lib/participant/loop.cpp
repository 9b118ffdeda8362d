#include "participant/loop.hpp"

#include <sys/prctl.h>

#include <csignal>
#include <cstdio>

namespace farrier::participant {
namespace {

using namespace std::chrono_literals;

// Transports may report several samples with one arrival; a short sleep bounds what that costs.
constexpr auto kLongestSleep = 2ms;
constexpr auto kSilenceWorthReporting = 5s;

volatile std::sig_atomic_t stop = 0;

void request_stop(int) { stop = 1; }

}  // namespace

void install_signal_handlers() {
  struct sigaction action {};
  action.sa_handler = request_stop;
  sigaction(SIGTERM, &action, nullptr);
  sigaction(SIGINT, &action, nullptr);
  prctl(PR_SET_PDEATHSIG, SIGKILL);
}

bool stop_requested() noexcept { return stop != 0; }

int run(Application& application, bus::Bus& bus, const char* name) {
  std::string waited_for;
  SteadyTime since = std::chrono::steady_clock::now();
  while (!stop_requested()) {
    const std::uint64_t before = bus.arrivals();
    application.poll(std::chrono::steady_clock::now());
    bus.wait_for_arrivals(before + static_cast<std::uint64_t>(application.missing()),
                          application.finished() ? Nanoseconds(20ms) : Nanoseconds(kLongestSleep));
    const SteadyTime now = std::chrono::steady_clock::now();
    if (bus.arrivals() != before || application.finished()) {
      since = now;
    } else if (now - since > kSilenceWorthReporting) {
      std::fprintf(stderr, "%s: waiting for %s\n", name, application.waits_for().c_str());
      since = now;
    }
  }
  return 0;
}

}  // namespace farrier::participant
