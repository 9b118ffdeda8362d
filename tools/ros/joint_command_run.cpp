#include "tools/ros/joint_command_run.hpp"

#include <unistd.h>

#include "process/process.hpp"

namespace farrier::ros_bridge {
namespace {

constexpr const char* kName = "ros_commands";
constexpr const char* kLauncher = "launcher";

}  // namespace

JointCommandRun::JointCommandRun(participant::ProcessOptions options, JointCommandReaders readers, Nanoseconds timeout)
    : options_(std::move(options)), readers_(std::move(readers)), timeout_(timeout) {
  options_.name = kName;
  options_.clock = bus::ClockKind::kRealtime;
  options_.number = participant::kLocomotion;
}

JointCommandRun::~JointCommandRun() { leave(); }

std::string JointCommandRun::look(const monitor::Frame& frame, int participants) {
  std::uint64_t session = 0;
  for (const monitor::ParticipantFrame& process : frame.participants) {
    if (signals::text_of(process.hello.name) == kLauncher && participants == 0) {
      session = process.hello.session;
      participants = process.hello.participant + 1;
    } else if (participants > 0 && process.hello.session != 0) {
      session = process.hello.session;
    }
  }
  if (session == 0 || session == session_) {
    return "";
  }
  if (frame.participants.size() > participant::kLocomotion) {
    const signals::SystemHello& taken = frame.participants[participant::kLocomotion].hello;
    if (taken.session == session && taken.pid != static_cast<std::uint32_t>(::getpid())) {
      return "process " + std::to_string(taken.pid) + " (" + std::string(signals::text_of(taken.name)) +
             ") commands the joints of this run: start the robot with --no-locomotion";
    }
  }
  leave();
  join(session, participants);
  return "";
}

void JointCommandRun::join(std::uint64_t session, int participants) {
  session_ = session;
  options_.session = session;
  options_.participants = static_cast<std::uint16_t>(participants);
  thread_ = std::thread([this, options = options_] {
    const process::Factory<participant::Application> make = [this](participant::Participant& member,
                                                                   const robot::Robot& robot) {
      return create_joint_command_source(robot, member, timeout_, readers_, state_);
    };
    if (process::run(options, make) != 0 && !state_.ends) {
      state_.notices.put(signals::Severity::kError, "joint commands have no part in the run: its reason is above");
    }
    state_.commands = false;
  });
}

void JointCommandRun::leave() {
  if (thread_.joinable()) {
    state_.ends = true;
    thread_.join();
    state_.ends = false;
  }
  session_ = 0;
}

}  // namespace farrier::ros_bridge
