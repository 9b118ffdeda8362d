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

void control(RealtimeApplication& application, const char* name, const std::atomic<bool>& started) {
  for (const std::string& lacking : {runtime::set_priority(runtime::kControlPriority), runtime::lock_memory()}) {
    if (!lacking.empty()) {
      std::fprintf(stderr, "%s: runs without %s\n", name, lacking.c_str());
    }
  }
  while (!started.load(std::memory_order_acquire) && !stop_requested()) {
    std::this_thread::sleep_for(1ms);
  }
  const bool on_arrival = application.trigger() == RealtimeApplication::Trigger::kArrival;
  const Nanoseconds period = on_arrival ? application.period() * 3 / 2 : application.period();
  SteadyTime previous = steady_now();
  while (!stop_requested()) {
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

void send(RealtimeApplication& application, const std::atomic<bool>& started) {
  while (!stop_requested()) {
    if (application.outputs_waiting.wait_until(machine_time(steady_now() + kHousekeeping)) && started.load(std::memory_order_acquire)) {
      application.send();
    }
  }
  if (started.load(std::memory_order_acquire)) {
    application.send();
  }
}

}  // namespace

int run_realtime(RealtimeApplication& application, bus::Bus& bus, const char* name) {
  std::atomic<bool> started{false};
  std::thread control_thread(control, std::ref(application), name, std::cref(started));
  std::thread send_thread(send, std::ref(application), std::cref(started));
  SteadyTime said = steady_now();
  while (!stop_requested()) {
    const std::uint64_t before = bus.arrivals();
    if (application.receive(steady_now())) {
      started.store(true, std::memory_order_release);
    } else if (steady_now() - said > kSilenceWorthReporting) {
      std::fprintf(stderr, "%s: waiting for %s\n", name, application.waits_for().c_str());
      said = steady_now();
    }
    bus.wait_for_arrivals(before + 1, kHousekeeping);
  }
  control_thread.join();
  send_thread.join();
  return 0;
}

}  // namespace farrier::participant
