#include "run/inproc_run.hpp"

#include <algorithm>

#include "bus/inproc/inproc_bus.hpp"
#include "joint_node/joint_node_lockstep.hpp"
#include "run/run_monitor.hpp"
#include "locomotion/body_locomotion.hpp"
#include "participant/plain_processes.hpp"
#include "recorder/run_recording.hpp"
#include "robot/keys.hpp"
#include "signals/tick_of.hpp"
#include "supervisor/ports.hpp"

namespace farrier::run {
namespace {

using namespace std::chrono_literals;

constexpr std::uint64_t kSession = 1;
// Polls of everybody without a tick done after which a run counts as standing still.
constexpr int kStandstill = 10'000;

/// One member with its bus. Declaration order is destruction order: ports go before the bus they are on.
struct Seat {
  std::unique_ptr<bus::Bus> bus;
  std::unique_ptr<participant::Participant> participant;
  std::unique_ptr<participant::Application> application;
};

Result<std::unique_ptr<participant::Application>> create_application(const Member& member, const robot::Robot& robot,
                                                                     const InprocRun& run,
                                                                     participant::Participant& participant) {
  switch (member.number) {
    case participant::kSimBridge: {
      const robot::Robot& simulated = run.simulated != nullptr ? *run.simulated : robot;
      FARRIER_TRY(sim_bridge::check_supply(robot, simulated));
      auto world = FARRIER_TRY(
          participant::is_on_ground(run.world)
              ? sim_bridge::simulated_body(simulated, run.scene_path, run.seed, run.world == participant::World::kIdeal)
              : sim_bridge::simulated_bench(simulated, run.seed, run.load_changes));
      return sim_bridge::create_lockstep(std::move(world), simulated, run.trace_path, participant, run.ticks, run.sink);
    }
    case participant::kSupervisor:
      return supervisor::create_application(run.designer != nullptr ? *run.designer : robot, run.design, participant,
                                            run.ticks, false, run.known_loads, run.first_gains);
    case participant::kLocomotion: {
      auto made = FARRIER_TRY(
          participant::is_on_ground(run.world)
              ? locomotion::create_trot_locomotion(robot, locomotion::script_of(run.velocity), participant, run.ticks,
                                                   participant::tells_supply(run.world, robot.supply.has_value()))
              : locomotion::create_gait_source(robot, run.seed, participant, run.ticks, run.announce));
      return std::unique_ptr<participant::Application>(std::move(made));
    }
#define FARRIER_MAKE_plain(constant, program) \
  case info(Program::constant).number:        \
    return program::create_application(robot, run.world, participant, run.ticks);
#define FARRIER_MAKE_specially(constant, program)
#define FARRIER_PROCESS(constant, program, number, needed, made) FARRIER_MAKE_##made(constant, program)
#include "core/processes.def"
#undef FARRIER_PROCESS
#undef FARRIER_MAKE_specially
#undef FARRIER_MAKE_plain
    default:
      return joint_node::create_lockstep(robot, member.joints, participant, run.ticks);
  }
}

}  // namespace

Result<InprocResult> run_inproc(const robot::Robot& robot, const InprocRun& run) {
  SteadyTime now{};
  const auto domain = std::make_shared<bus::InprocDomain>([&now] { return now; });
  const std::vector<Member> members = plan_members(robot, run.grouping);
  std::vector<Seat> seats(members.size());
  for (const Member& member : members) {
    Seat& seat = seats[member.number];
    seat.bus = bus::create_inproc_bus(domain);
    auto joined = FARRIER_TRY(participant::Participant::join(
        *seat.bus, {member.name, robot.name, member.number, static_cast<std::uint16_t>(members.size()), kSession,
                    bus::ClockKind::kLockstep}));
    seat.participant = std::move(joined);
    auto application = FARRIER_TRY(create_application(member, robot, run, *seat.participant));
    seat.application = std::move(application);
  }
  Seat& gait = seats[participant::kLocomotion];
  auto monitor = FARRIER_TRY(RunMonitor::create(*gait.bus, gait.participant->identity(), robot::legs_of_joints(robot)));
  auto estimates = FARRIER_TRY(bus::Subscription<signals::JointModelEstimate>::create(
      *gait.bus, participant::endpoint_of(gait.participant->identity(), bus::TopicId::kJointModelEstimate)));
  std::unique_ptr<recorder::RunRecording> recording;
  if (!run.record_path.empty()) {
    auto made =
        FARRIER_TRY(recorder::RunRecording::create(run.record_path, run.record_facts, robot, *gait.participant));
    recording = std::move(made);
  }
  const auto listen = [&] {
    monitor.poll();
    estimates.drain([&](const signals::JointModelEstimate& estimate) {
      if (run.estimates && !signals::is_probe(estimate)) {
        run.estimates(estimate);
      }
    });
  };
  InprocResult result;
  const auto& source = static_cast<const locomotion::Locomotion&>(*gait.application);
  int idle_polls = 0;
  Tick last = kNoTick;
  while (!std::all_of(seats.begin(), seats.end(), [](const Seat& seat) { return seat.application->finished(); })) {
    now += 1ms;
    if (recording) {
      recording->poll();
    }
    for (Seat& seat : seats) {
      seat.application->poll(now);
    }
    idle_polls = source.tick() == last ? idle_polls + 1 : 0;
    if (source.tick() != last) {
      listen();
    }
    if (idle_polls > kStandstill) {
      return Error{"the run stands still: " + seats[participant::kSimBridge].application->waits_for() +
                   recording::left_behind(run.record_path)};
    }
    if (source.tick() != last && source.tick() % 100 == 0 && run.progress && !run.progress(source.tick())) {
      return Error{"interrupted" + recording::left_behind(run.record_path)};
    }
    last = source.tick();
  }
  listen();
  if (recording) {
    FARRIER_TRY(recording->finish(run.ticks));
  }
  result.hellos = gait.participant->hellos();
  result.healths = monitor.healths();
  result.events = monitor.events();
  result.decisions = monitor.decisions();
  result.gains = monitor.gains();
  result.phases = monitor.phases();
  return result;
}

}  // namespace farrier::run
