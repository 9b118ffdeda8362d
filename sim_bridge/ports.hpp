#pragma once

#include <optional>

#include "participant/participant.hpp"
#include "trace/trace.hpp"
#include "robot/robot.hpp"
#include "sim_bridge/sim_world.hpp"

namespace farrier::sim_bridge {

/// The arrows that end or begin at sim_bridge. On the real-time clock no process reports ticks done.
struct Ports {
  participant::In<signals::JointValveCommand>* valves;
  participant::In<signals::ClockTickDone>* done;            ///< lock-step only, else null
  participant::In<signals::JointControllerGains>* gains;    ///< lock-step only: the gains that each joint must hold
  participant::In<signals::SystemMode>* modes;              ///< lock-step only
  participant::Out<signals::JointSensors>* sensors;
  participant::Out<signals::ClockTick>* clock;

  static Result<Ports> open(participant::Participant& participant, const robot::Robot& robot);
};

/// Parts of sim_bridge on either clock.
struct Parts {
  SimWorld world;
  std::optional<trace::TraceWriter> trace;  ///< none for an empty path
  Ports ports;

  static Result<Parts> assemble(const robot::Robot& robot, std::uint64_t seed, const std::string& trace_path,
                                participant::Participant& participant,
                                std::vector<robot::LoadChange> load_changes = {});
};

}  // namespace farrier::sim_bridge
