#include "participant/loop.hpp"

#include <csignal>
#include <cstdio>

namespace farrier::participant {
namespace {

using namespace std::chrono_literals;

// Transports may report several samples with one arrival; a short sleep bounds what that costs.
constexpr auto kLongestSleep = 2ms;
constexpr auto kSilenceWorthReporting = 2s;

volatile std::sig_atomic_t stop_signal = 0;

void request_stop(int signal) { stop_signal = signal; }

}  // namespace

void install_signal_handlers() {
  struct sigaction action {};
  action.sa_handler = request_stop;
  sigaction(SIGTERM, &action, nullptr);
  sigaction(SIGINT, &action, nullptr);
}

bool stop_requested() noexcept { return stop_signal != 0; }

SteadyTime steady_now() { return std::chrono::steady_clock::now(); }

int stop_status() noexcept { return stop_signal == 0 ? 0 : 128 + stop_signal; }

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
