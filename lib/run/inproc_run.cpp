#include "run/inproc_run.hpp"

#include <algorithm>

#include "bus/inproc/inproc_bus.hpp"
#include "estimator_service/ports.hpp"
#include "joint_node/joint_node_lockstep.hpp"
#include "run/run_monitor.hpp"
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
    case participant::kSimBridge:
      return sim_bridge::create_lockstep(run.world != nullptr ? *run.world : robot, run.seed, run.trace_path,
                                         participant, run.ticks, run.load_changes, run.sink);
    case participant::kEstimatorService: return estimator_service::create_application(robot, participant, run.ticks);
    case participant::kSupervisor:
      return supervisor::create_application(run.designer != nullptr ? *run.designer : robot, run.design, participant,
                                            run.ticks, false, run.known_loads, run.first_gains);
    case participant::kGaitSource: {
      auto gait = gait_source::GaitSource::create(robot, run.seed, participant, run.ticks, run.announce);
      if (!gait) {
        return gait.error();
      }
      return std::unique_ptr<participant::Application>(std::move(gait).value());
    }
    default: return joint_node::create_lockstep(robot, member.joints, participant, run.ticks);
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
    auto joined = participant::Participant::join(
        *seat.bus, {member.name, robot.name, member.number, static_cast<std::uint16_t>(members.size()), kSession,
                    bus::ClockKind::kLockstep});
    if (!joined) {
      return joined.error();
    }
    seat.participant = std::move(joined).value();
    auto application = create_application(member, robot, run, *seat.participant);
    if (!application) {
      return application.error();
    }
    seat.application = std::move(application).value();
  }
  Seat& gait = seats[participant::kGaitSource];
  auto monitor = RunMonitor::create(*gait.bus, gait.participant->identity(), robot::legs_of_joints(robot));
  if (!monitor) {
    return monitor.error();
  }
  auto estimates = bus::Subscription<signals::JointModelEstimate>::create(
      *gait.bus, participant::endpoint_of(gait.participant->identity(), bus::TopicId::kJointModelEstimate));
  if (!estimates) {
    return estimates.error();
  }
  std::unique_ptr<recorder::RunRecording> recording;
  if (!run.record_path.empty()) {
    auto made = recorder::RunRecording::create(run.record_path, run.record_facts, robot, *gait.participant);
    if (!made) {
      return made.error();
    }
    recording = std::move(made).value();
  }
  const auto listen = [&] {
    monitor.value().poll();
    estimates.value().drain([&](const signals::JointModelEstimate& estimate) {
      if (run.estimates && !signals::is_probe(estimate)) {
        run.estimates(estimate);
      }
    });
  };
  InprocResult result;
  const auto& source = static_cast<const gait_source::GaitSource&>(*gait.application);
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
    if (auto recorded = recording->finish(run.ticks); !recorded) {
      return recorded.error();
    }
  }
  result.hellos = gait.participant->hellos();
  result.healths = monitor.value().healths();
  result.events = monitor.value().events();
  result.decisions = monitor.value().decisions();
  result.gains = monitor.value().gains();
  return result;
}

}  // namespace farrier::run
