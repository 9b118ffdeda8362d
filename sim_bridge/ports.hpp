#pragma once

#include <optional>

#include "core/low_alarm.hpp"
#include "core/spsc_ring.hpp"
#include "participant/participant.hpp"
#include "robot/robot.hpp"
#include "sim_bridge/simulated_robot.hpp"
#include "sim_bridge/traces.hpp"

namespace farrier::sim_bridge {

/// The arrows that end or begin at sim_bridge. On the real-time clock no process reports ticks done.
struct Ports {
  participant::In<signals::JointValveCommand>* valves;
  participant::In<signals::ClockTickDone>* done;          ///< lock-step only, else null
  participant::In<signals::JointControllerGains>* gains;  ///< lock-step only: the gains that each joint must hold
  participant::In<signals::SystemMode>* modes;            ///< lock-step only
  participant::Out<signals::JointSensors>* sensors;
  participant::Out<signals::ClockTick>* clock;
  participant::Out<signals::BodyImu>* imu;      ///< of a world with a body, else null
  participant::Out<signals::BodyTruth>* truth;  ///< likewise

  participant::Out<signals::SupplyState>* supply;        ///< of a world with a pump, else null
  participant::Out<signals::SupplyTruth>* supply_truth;  ///< likewise

  static Result<Ports> open(participant::Participant& participant, const robot::Robot& robot,
                            const SimulatedRobot& world);
};

/// The IMU's sample of the present tick, in a world that has one.
signals::BodyImu imu_sample(const world::World& world, std::int64_t sample_time_ns) noexcept;

/// The alarm of the robot's supply; one that never goes off without a pump.
LowAlarm supply_alarm(const robot::Robot& robot) noexcept;

/// The sample of the supply that a world has at its present tick, with the truth; none between samples and without a pump.
inline std::optional<trace::SupplyRow> new_supply_sample(const SimulatedRobot& world) noexcept {
  const signals::SupplyState* newest = world.supply_state();
  return newest != nullptr && newest->tick == world.tick()
             ? std::optional(trace::SupplyRow{*newest, world.supply_truth().value_or(signals::SupplyTruth{})})
             : std::nullopt;
}

/// Reports a change of the alarm by a sample as an event.
void tell_supply(LowAlarm& alarm, const signals::SupplyState& sample, participant::Participant& participant);

/// Empties the ring onto the port.
template <class Signal, std::size_t N>
void publish_all(SpscRing<Signal, N>& ring, participant::Out<Signal>* port) {
  for (Signal sample; ring.pop(sample);) {
    port->publish(sample);
  }
}

/// Parts of sim_bridge on either clock.
struct Parts {
  std::unique_ptr<SimulatedRobot> world;
  Traces traces;
  Ports ports;

  static Result<Parts> assemble(std::unique_ptr<SimulatedRobot> world, const robot::Robot& robot,
                                const std::string& trace_path, participant::Participant& participant);
};

}  // namespace farrier::sim_bridge
