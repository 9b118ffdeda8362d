#include "cli/processes/dds_run.hpp"

#include <cstdio>
#include <filesystem>
#include <optional>
#include <thread>

#include "bus/settings/user_settings.hpp"
#include "bus_factory/bus_factory.hpp"
#include "run/run_listener.hpp"
#include "run/run_monitor.hpp"
#include "participant/clock.hpp"
#include "participant/loop.hpp"
#include "process/process.hpp"
#include "recorder/run_recording.hpp"
#include "robot/keys.hpp"
#include "runtime/realtime_thread.hpp"
#include "cli/processes/child_process.hpp"
#include "cli/processes/domain_lock.hpp"
#include "cli/processes/helm.hpp"
#include "cli/base/progress.hpp"
#include "cli/processes/run_children.hpp"
#include "cli/processes/run_clock.hpp"
#include "cli/processes/run_limits.hpp"

namespace farrier::cli {
namespace {

using namespace std::chrono_literals;

constexpr auto kHousekeeping = 20ms;
constexpr Tick kRecordedTogether = 16;  // ticks kept by the bus before they are recorded; it can keep 256
/// Time after the end of all other processes, for samples that are still on their way to the recording.
constexpr auto kLastSamples = 2s;

using participant::steady_now;

/// Objects of a run that this process owns besides its children.
struct Seat {
  std::unique_ptr<bus::Bus> bus;
  std::unique_ptr<participant::Participant> participant;
  std::optional<run::RunListener> listener;
  std::unique_ptr<recorder::RunRecording> recording;  ///< lock-step; in real time another process records
  std::optional<RunActs> acts;
  std::optional<Helm> helm;  ///< of a run that is steered
};

Result<Seat> take_seat(const robot::Robot& robot, const DdsRun& run, const participant::ProcessOptions& common,
                       const run::Member& member, const std::optional<HostClock>& clock) {
  Seat seat;
  if (common.clock == bus::ClockKind::kRealtime) {
    // If the limits forbid it this process listens without: the node processes report that in their logs.
    participant::set_slow_motion(common.slow);
    static_cast<void>(runtime::set_priority(runtime::kServicePriority));
  }
  bus::NetworkOptions network = participant::network_of(common);
  const bus::Vendor vendor = vendor_of(run.dds, member);
  FARRIER_TRY(process::secure(network, common.security, run::role_of(member), vendor));
  auto bus = bus_factory::create_bus(vendor, network);
  if (!bus) {
    return bus.error();
  }
  seat.bus = std::move(bus).value();
  participant::Identity identity{member.name,    robot.name,   member.number, common.participants,
                                 common.session, common.clock, common.slow};
  identity.launches = true;
  auto participant = FARRIER_TRY(participant::Participant::join(*seat.bus, identity));
  seat.participant = std::move(participant);
  seat.listener.emplace(FARRIER_TRY(run::RunListener::create(*seat.participant, common.ticks)));
  auto acts = FARRIER_TRY(RunActs::create(run.acts, *seat.participant, clock));
  seat.acts = std::move(acts);
  if (run.steers) {
    seat.helm.emplace(FARRIER_TRY(Helm::create(*seat.participant, run.steers)));
  }
  if (!run.record_path.empty() && common.clock == bus::ClockKind::kLockstep) {
    auto recording =
        FARRIER_TRY(recorder::RunRecording::create(run.record_path, run.record_facts, robot, *seat.participant));
    seat.recording = std::move(recording);
  }
  return seat;
}

bool has(const std::vector<ChildProcess>& children, const std::string& name) {
  return std::ranges::find(children, name, &ChildProcess::name) != children.end();
}

/// Listens until the run is over. In lock-step every process has then sent its final report. In real time sim_bridge
/// has, or it has died and the ticks of the run have passed. Refuses as bury and RunLimits do, and when the user
/// interrupts.
Result<double> attend(Seat& seat, run::RunMonitor& monitor, std::vector<ChildProcess>& children,
                      const RunActs::Start& start, Progress& progress, const DdsRun& run, Nanoseconds period,
                      RunLimits& limits, GrowthWatch& watch, Onlookers& onlookers, RunOutcome& outcome) {
  const bool realtime = run.common.clock == bus::ClockKind::kRealtime;
  const Tick ticks = run.common.ticks;
  RunClock clock(realtime ? period : Nanoseconds::zero());
  SteadyTime next_housekeeping{};
  SteadyTime first_tick{};
  SteadyTime moved = steady_now();
  Tick last = 0;
  Tick next_recorded = 0;
  for (;;) {
    const std::uint64_t before = seat.bus->arrivals();
    seat.listener->poll(steady_now());
    if (seat.recording && (!seat.participant->has_started() || seat.listener->tick() >= next_recorded)) {
      next_recorded = seat.listener->tick() + kRecordedTogether;
      seat.recording->poll();  // the others need not wait for it
    }
    clock.heard(seat.listener->tick(), steady_now());
    FARRIER_TRY(seat.acts->perform(clock.at(steady_now()), seat.listener->tick(), children, start));
    if (run.looks_on) {
      run.looks_on(seat.listener->tick());
      monitor.poll(clock.at(steady_now()));
    }
    if (seat.helm && seat.helm->steer(seat.listener->tick())) {
      monitor.poll(clock.at(steady_now()));
      return std::chrono::duration<double>(moved - first_tick).count();
    }
    if (seat.listener->tick() != last) {
      watch.tick(seat.listener->tick());
      onlookers.look(seat.listener->tick(), steady_now());
      first_tick = last == 0 ? steady_now() : first_tick;
      last = seat.listener->tick();
      moved = steady_now();
    }
    if (steady_now() >= next_housekeeping) {
      next_housekeeping = steady_now() + kHousekeeping;
      if (participant::stop_requested()) {
        return Error{"interrupted"};
      }
      FARRIER_TRY(bury(children, run, outcome.members, last, outcome.warnings));
      if (!seat.participant->refusal().empty()) {
        return Error{seat.participant->refusal()};
      }
      monitor.poll(clock.at(steady_now()));
      if (seat.recording) {
        seat.recording->poll();
      }
      const bool over = !realtime ? monitor.all_final()
                                  : monitor.healths()[participant::kSimBridge].final_report != 0 ||
                                        (!has(children, outcome.members[participant::kSimBridge].name) &&
                                         clock.at(steady_now()) >= ticks);
      if (over && (!seat.recording || seat.recording->has(ticks) || steady_now() - moved > kLastSamples)) {
        return std::chrono::duration<double>(moved - first_tick).count();
      }
      if (!seat.helm) {
        progress.update(last);
      }
      FARRIER_TRY(limits.check(*seat.participant, *seat.listener, monitor, children));
      if (steady_now() - moved > kSilenceWorthSaying) {
        progress.note(standstill(*seat.listener, children));
        moved = steady_now();
      }
    }
    seat.bus->wait_for_arrivals(before + 1, 2ms);
  }
}

}  // namespace

const char* to_string(DdsChoice choice) noexcept {
  switch (choice) {
    case DdsChoice::kCyclone:
      return "cyclone";
    case DdsChoice::kFast:
      return "fast";
    case DdsChoice::kMixed:
      return "mixed";
    case DdsChoice::kInproc:
      return "inproc";
  }
  return "";
}

bus::Vendor vendor_of(DdsChoice choice, const run::Member& member) noexcept {
  switch (choice) {
    case DdsChoice::kCyclone:
      return bus::Vendor::kCyclone;
    case DdsChoice::kFast:
      return bus::Vendor::kFast;
    case DdsChoice::kMixed:
      return member.number == participant::kSimBridge || member.number == participant::kEstimatorService ||
                     member.stands_by
                 ? bus::Vendor::kCyclone
                 : bus::Vendor::kFast;
    case DdsChoice::kInproc:
      break;
  }
  return bus::Vendor::kInproc;
}

Result<RunOutcome> run_over_dds(const robot::Robot& robot, const DdsRun& run) {
  participant::install_signal_handlers();
  auto lock = FARRIER_TRY(DomainLock::acquire());
  RunOutcome outcome;
  outcome.members = run::plan_processes(robot, run.grouping, run.standby);
  participant::ProcessOptions common = run.common;
  common.network.domain = lock.domain();
  std::fputs(bus::lines_of_user_settings(common.network, run.title + ": note: ").c_str(), stderr);
  common.participants = static_cast<std::uint16_t>(outcome.members.size());

  std::error_code refused;
  std::filesystem::create_directories(run.log_directory, refused);
  if (refused) {
    return Error{"cannot write logs to " + run.log_directory + ": " + refused.message()};
  }
  std::optional<HostClock> clock;
  if (std::ranges::any_of(run.acts, [](const Act& act) { return run::sets_clock(act.signal); })) {
    auto created = FARRIER_TRY(HostClock::create(run.executables, run.log_directory + "/clock"));
    clock = std::move(created);
  }
  const HostClock* const seen = clock ? &*clock : nullptr;
  auto onlookers = FARRIER_TRY(Onlookers::start(run, common.network.domain));
  auto children = FARRIER_TRY(start_children(run, common, outcome.members, seen));
  if (common.clock == bus::ClockKind::kRealtime && !run.record_path.empty()) {
    children.push_back(FARRIER_TRY(start_recorder(robot, run, common)));
  }
  GrowthWatch watch(run.soak ? pids_of(outcome.members, children) : std::vector<pid_t>{}, common.ticks);
  auto seat = FARRIER_TRY(take_seat(robot, run, common, outcome.members.back(), clock));
  auto monitor =
      FARRIER_TRY(run::RunMonitor::create(*seat.bus, seat.participant->identity(), robot::legs_of_joints(robot)));
  Progress progress(run.title, common.ticks);
  const RunActs::Start start_anew = [&](const std::string& member, const std::string& name) {
    if (member == run::kMonitor) {
      return start_monitor(run, common, name, robot.joints.front().name);
    }
    const auto place = std::ranges::find(outcome.members, member, &run::Member::name);
    return start_child(run, common, *place, name, name + "_anew", seen);
  };
  RunLimits limits(run, common, outcome.members);
  auto attended = attend(seat, monitor, children, start_anew, progress, run,
                         std::chrono::duration_cast<Nanoseconds>(std::chrono::duration<double>(robot.period_s)), limits,
                         watch, onlookers, outcome);
  auto uses = onlookers.finish();
  const std::string hard_ends = end_all(children);
  if (!attended || !hard_ends.empty()) {
    return Error{(attended ? hard_ends : attended.error().message) +
                 (seat.recording ? recording::left_behind(run.record_path) : "")};
  }
  if (seat.recording) {
    FARRIER_TRY(seat.recording->finish(common.ticks));
  }
  if (!uses) {
    return uses.error();
  }
  outcome.onlookers = std::move(uses).value();
  outcome.wall_s = attended.value();
  outcome.growths = watch.growths();
  outcome.acted = seat.acts->performed();
  outcome.hellos = seat.participant->hellos();
  outcome.healths = monitor.healths();
  outcome.events = monitor.events();
  outcome.events_heard = monitor.heard();
  outcome.decisions = monitor.decisions();
  outcome.gains = monitor.gains();
  outcome.phases = monitor.phases();
  return outcome;
}

}  // namespace farrier::cli
