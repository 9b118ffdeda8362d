#include "participant/realtime_loop.hpp"

#include <cstdio>
#include <thread>

#include "participant/clock.hpp"
#include "participant/loop.hpp"
#include "runtime/deadline.hpp"
#include "runtime/realtime_thread.hpp"

namespace farrier::participant {
namespace {

using namespace std::chrono_literals;

constexpr auto kHousekeeping = 5ms;
constexpr auto kSilenceWorthReporting = 5s;

/// Between the three threads.
struct State {
  std::atomic<bool> started{false};
  std::atomic<bool> refused{false};

  bool over() const noexcept { return stop_requested() || refused.load(std::memory_order_relaxed); }
};

void control(RealtimeApplication& application, const char* name, const State& state) {
  for (const std::string& lacking : {runtime::set_priority(runtime::kControlPriority), runtime::lock_memory()}) {
    if (!lacking.empty()) {
      std::fprintf(stderr, "%s: runs without %s\n", name, lacking.c_str());
    }
  }
  while (!state.started.load(std::memory_order_acquire) && !state.over()) {
    std::this_thread::sleep_for(1ms);
  }
  const bool on_arrival = application.trigger() == RealtimeApplication::Trigger::kArrival;
  const Nanoseconds period = on_arrival ? application.period() * 3 / 2 : application.period();
  SteadyTime previous = steady_now();
  while (!state.over()) {
    runtime::Deadline deadline = runtime::next_deadline(previous, steady_now(), period);
    if (on_arrival) {
      deadline.missed += application.inputs_complete.wait_until(machine_time(deadline.next)) ? 0 : 1;
      previous = steady_now();
    } else {
      runtime::sleep_until(machine_time(deadline.next));
      previous = deadline.next;
    }
    if (!application.finished()) {
      application.step({steady_now(), deadline.next, deadline.missed});
      application.outputs_waiting.post();
    }
  }
}

void send(RealtimeApplication& application, const State& state) {
  while (!state.over()) {
    if (application.outputs_waiting.wait_until(machine_time(steady_now() + kHousekeeping)) && state.started.load(std::memory_order_acquire)) {
      application.send();
    }
  }
  if (state.started.load(std::memory_order_acquire)) {
    application.send();
  }
}

}  // namespace

int run_realtime(RealtimeApplication& application, Participant& participant) {
  bus::Bus& bus = participant.bus();
  const char* const name = participant.identity().name.c_str();
  State state;
  std::thread control_thread(control, std::ref(application), name, std::cref(state));
  std::thread send_thread(send, std::ref(application), std::cref(state));
  SteadyTime said = steady_now();
  while (!state.over()) {
    const std::uint64_t before = bus.arrivals();
    if (application.receive(steady_now())) {
      state.started.store(true, std::memory_order_release);
    } else if (steady_now() - said > kSilenceWorthReporting) {
      std::fprintf(stderr, "%s: waiting for %s\n", name, application.waits_for().c_str());
      said = steady_now();
    }
    state.refused.store(!participant.refusal().empty(), std::memory_order_relaxed);
    bus.wait_for_arrivals(before + 1, kHousekeeping);
  }
  control_thread.join();
  send_thread.join();
  return end_status(participant);
}

}  // namespace farrier::participant
