#include "participant/loop.hpp"

#include <csignal>
#include <cstdio>

#include "participant/clock.hpp"
#include "participant/service_manager.hpp"
#include "runtime/realtime_thread.hpp"

namespace farrier::participant {
namespace {

using namespace std::chrono_literals;

// Transports may report several samples with one arrival; a short sleep bounds what that costs.
constexpr auto kLongestSleep = 2ms;
constexpr auto kSilenceWorthReporting = 2s;
constexpr auto kStatusPeriod = 1s;  // while the others are greeted

volatile std::sig_atomic_t stop_signal = 0;

void request_stop(int signal) { stop_signal = signal; }

}  // namespace

void install_signal_handlers() {
  struct sigaction action {};
  action.sa_handler = request_stop;
  sigaction(SIGTERM, &action, nullptr);
  sigaction(SIGINT, &action, nullptr);
  struct sigaction before {};
  if (sigaction(SIGHUP, nullptr, &before) == 0 && before.sa_handler == SIG_DFL) {  // nohup has it ignored
    sigaction(SIGHUP, &action, nullptr);
  }
}

bool stop_requested() noexcept { return stop_signal != 0; }

int stop_status() noexcept { return stop_signal == 0 ? 0 : 128 + stop_signal; }

int end_status(const Participant& member) {
  if (member.refusal().empty()) {
    return 0;
  }
  std::fprintf(stderr, "%s: %s\n", member.identity().name.c_str(), member.refusal().c_str());
  return 1;
}

int run(Application& application, Participant& member, const Promotion& promotion) {
  bus::Bus& bus = member.bus();
  ServiceManager manager;
  bool promoted = promotion.to == promotion.from;
  SteadyTime since = steady_now();
  SteadyTime next_status = since + kStatusPeriod;
  for (std::uint64_t turns = 1; !stop_requested() && member.refusal().empty(); ++turns) {
    const std::uint64_t before = bus.arrivals();
    application.poll(steady_now());
    bus.wait_for_arrivals(before + static_cast<std::uint64_t>(application.missing()),
                          application.finished() ? Nanoseconds(20ms) : Nanoseconds(kLongestSleep));
    const SteadyTime now = steady_now();
    if (member.has_started()) {
      if (!promoted) {
        promoted = true;
        runtime::raise_threads(promotion.from, promotion.to);
      }
      manager.ready();
    } else if (now >= next_status) {
      next_status = now + kStatusPeriod;
      manager.status("waiting for " + application.waits_for());
    }
    manager.alive({&turns, 1}, now);
    if (bus.arrivals() != before || application.finished()) {
      since = now;
    } else if (now - since > kSilenceWorthReporting) {
      std::fprintf(stderr, "%s: waiting for %s\n", member.identity().name.c_str(), application.waits_for().c_str());
      since = now;
    }
  }
  return end_status(member);
}

}  // namespace farrier::participant
