#include "participant/realtime_loop.hpp"

#include <array>
#include <cstdio>
#include <thread>

#include "participant/clock.hpp"
#include "participant/loop.hpp"
#include "participant/service_manager.hpp"
#include "runtime/awake_processors.hpp"
#include "runtime/deadline.hpp"
#include "runtime/realtime_thread.hpp"

namespace farrier::participant {
namespace {

using namespace std::chrono_literals;

constexpr auto kHousekeeping = 5ms;
constexpr auto kSilenceReportedAfter = 5s;
constexpr auto kHealthPeriod = 1s;

/// State that the threads of a process share.
struct Threads {
  std::atomic<bool> started{false};
  std::atomic<bool> refused{false};
  std::atomic<pid_t> sender{0};  ///< 0 until it runs
  std::atomic<std::uint64_t> control_turns{0}, send_turns{0};

  bool over() const noexcept { return stop_requested() || refused.load(std::memory_order_relaxed); }
};

// Waits for complete inputs until `latest`. If this thread could not run by then, the bus thread could not receive
// either, so this one waits half a period more. Returns false if inputs are not complete.
bool wait_for_inputs(RealtimeApplication& application, SteadyTime latest) {
  if (application.inputs_complete.wait_until(machine_time(latest))) {
    return true;
  }
  const Nanoseconds patience = application.period() / 2;
  const SteadyTime woken = steady_now();
  return woken - latest > patience && application.inputs_complete.wait_until(machine_time(woken + patience));
}

void control(RealtimeApplication& application, const char* name, const Priorities& priorities, Threads& threads) {
  runtime::name_thread("control");
  const std::string unlocked = runtime::lock_memory();  // takes milliseconds, for which no running process shall wait
  const runtime::AwakeProcessors awake;
  for (const std::string& lacking : {unlocked, awake.lacking(), runtime::set_priority(priorities.control)}) {
    if (!lacking.empty()) {
      std::fprintf(stderr, "%s: runs without %s\n", name, lacking.c_str());
    }
  }
  const std::atomic<bool>& started = threads.started;
  while ((!started.load(std::memory_order_acquire) || threads.sender == 0) && !threads.over()) {
    std::this_thread::sleep_for(1ms);
  }
  const pid_t sender = threads.sender;
  const bool on_arrival = application.trigger() == RealtimeApplication::Trigger::kArrival;
  const Nanoseconds period = on_arrival ? application.period() * 3 / 2 : application.period();
  SteadyTime previous = steady_now();
  for (; !threads.over(); threads.control_turns.fetch_add(1, std::memory_order_relaxed)) {
    runtime::Deadline deadline = runtime::next_deadline(previous, steady_now(), period);
    if (on_arrival) {
      deadline.missed += wait_for_inputs(application, deadline.next) ? 0 : 1;
      previous = steady_now();
    } else {
      runtime::sleep_until(machine_time(deadline.next));
      previous = deadline.next;
    }
    if (!application.finished()) {
      application.step({steady_now(), deadline.next, deadline.missed});
      application.outputs_waiting.post();
      runtime::set_priority_of(sender, priorities.bus);  // it may have the lower priority of sends that nothing waits
                                                         // for
    }
  }
}

void send(RealtimeApplication& application, const Priorities& priorities, Threads& threads) {
  runtime::name_thread("send");
  const pid_t self = runtime::thread_id();
  threads.sender = self;
  const std::atomic<bool>& started = threads.started;
  for (; !threads.over(); threads.send_turns.fetch_add(1, std::memory_order_relaxed)) {
    if (!application.outputs_waiting.wait_until(machine_time(steady_now() + kHousekeeping)) ||
        !started.load(std::memory_order_acquire)) {
      continue;
    }
    application.send();
    runtime::set_priority_of(self, priorities.leisure);
    if (!application.outputs_waiting.posted()) {  // a post from here on raises this thread
      application.send_at_leisure();
    } else {
      runtime::set_priority_of(self, priorities.bus);
    }
  }
  if (started.load(std::memory_order_acquire)) {
    application.send();
    application.send_at_leisure();
  }
}

}  // namespace

Priorities priorities_of(const RealtimeApplication& application, int shift, bool secured) noexcept {
  using namespace runtime;
  const bool bus_steps = secured && application.publishes_in_step();
  return {.joining = kJoiningPriority + shift,
          .control = (bus_steps ? kBusPriority : kControlPriority) + shift,
          .bus = kBusPriority + shift,
          .leisure = (secured ? kBusPriority : kLeisurePriority) + shift};
}

int run_realtime(RealtimeApplication& application, Participant& member, const Priorities& priorities) {
  const char* const name = member.identity().name.c_str();
  bus::Bus& bus = member.bus();
  Threads threads;
  ServiceManager manager;
  std::thread control_thread(control, std::ref(application), name, std::cref(priorities), std::ref(threads));
  std::thread send_thread(send, std::ref(application), std::cref(priorities), std::ref(threads));
  SteadyTime said = steady_now();
  SteadyTime next_status = said + kHealthPeriod;
  while (!threads.over()) {
    const std::uint64_t before = bus.arrivals();
    if (application.receive(steady_now())) {
      if (!threads.started.load(std::memory_order_relaxed)) {
        runtime::raise_threads(priorities.joining, priorities.bus);
      }
      threads.started.store(true, std::memory_order_release);
      manager.ready();
      manager.alive(std::array{threads.control_turns.load(), threads.send_turns.load()}, steady_now());
    } else if (steady_now() >= next_status) {
      next_status = steady_now() + kHealthPeriod;
      const std::string waiting = "waiting for " + application.waits_for();
      manager.status(waiting);
      if (steady_now() - said > kSilenceReportedAfter) {
        std::fprintf(stderr, "%s: %s\n", name, waiting.c_str());
        said = steady_now();
      }
    }
    threads.refused.store(!member.refusal().empty(), std::memory_order_relaxed);
    bus.wait_for_arrivals(before + 1, kHousekeeping);
  }
  control_thread.join();
  send_thread.join();
  return end_status(member);
}

}  // namespace farrier::participant
