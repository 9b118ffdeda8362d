#include "locomotion/body_locomotion.hpp"

#include <algorithm>
#include <cmath>

#include "core/ensure.hpp"
#include "locomotion/body_state_signal.hpp"
#include "participant/clock.hpp"
#include "robot/keys.hpp"
#include "robot/locomotion_params.hpp"

namespace farrier::locomotion {
namespace {

bool finite(const signals::JointSensors& sensors) noexcept {
  return std::isfinite(sensors.position_m_or_rad) && std::isfinite(sensors.velocity_m_s_or_rad_s) &&
         std::isfinite(sensors.force_N_or_Nm);
}

bool finite(const signals::BodyImu& imu) noexcept {
  const auto is_finite = [](double number) { return std::isfinite(number); };
  return std::ranges::all_of(imu.angular_velocity_rad_s, is_finite) &&
         std::ranges::all_of(imu.specific_force_m_s2, is_finite);
}

/// Samples of one tick of all joints and of the IMU. In real time the newest of each count. A sample with a number
/// that is not finite gives its tick only: one such number would stay in the estimated state for ever.
class ReadingsInbox {
 public:
  explicit ReadingsInbox(const robot::Robot& robot)
      : robot_(robot), joints_(robot::joint_numbers(robot)), newest_(robot.joints.size()) {}

  void put(const signals::JointSensors& sensors) noexcept {
    joints_.put(sensors);
    if (finite(sensors)) {
      newest_[sensors.joint] = sensors;
    }
  }
  void put(const signals::BodyImu& imu) noexcept {
    imu_.put(imu);
    if (finite(imu)) {
      newest_imu_ = imu;
    }
  }

  bool complete(Tick tick) const noexcept { return joints_.missing(tick) == 0 && imu_.missing(tick) == 0; }

  /// Oldest tick among the newest samples; kNoTick while one has never come.
  Tick oldest() const noexcept {
    Tick oldest = newest_imu_.tick;
    for (const signals::JointSensors& sensors : newest_) {
      oldest = std::min(oldest, sensors.tick);
    }
    return oldest;
  }

  /// Readings of the newest samples, in joint coordinates.
  Readings read() const noexcept {
    Readings readings;
    for (const robot::Joint& joint : robot_.joints) {
      const signals::JointSensors& sensors = newest_[joint.number];
      const double angle_rad = joint.linkage.angle(sensors.position_m_or_rad);
      LegReadings& leg = readings.legs[static_cast<std::size_t>(joint.leg)];
      leg.position_rad[joint.index_in_leg] = angle_rad;
      leg.velocity_rad_s[joint.index_in_leg] = joint.linkage.angular_velocity(angle_rad, sensors.velocity_m_s_or_rad_s);
      leg.torque_Nm[joint.index_in_leg] = joint.linkage.torque(angle_rad, sensors.force_N_or_Nm);
    }
    readings.imu = {.angular_velocity_rad_s = Eigen::Vector3d(newest_imu_.angular_velocity_rad_s.data()),
                    .specific_force_m_s2 = Eigen::Vector3d(newest_imu_.specific_force_m_s2.data())};
    return readings;
  }

 private:
  const robot::Robot& robot_;
  participant::TickInbox<signals::JointSensors> joints_;
  participant::TickInbox<signals::BodyImu> imu_{{0}};
  std::vector<signals::JointSensors> newest_;  // by joint
  signals::BodyImu newest_imu_;
};

class BodyLocomotion final : public Locomotion {
 public:
  static Result<std::unique_ptr<Locomotion>> create(const robot::Robot& robot, std::unique_ptr<Controller> controller,
                                                    std::vector<TimedCommand> script,
                                                    participant::Participant& participant, Tick ticks,
                                                    bool hears_supply) {
    const Ports ports = FARRIER_TRY(Ports::open(participant, robot));
    if (hears_supply && !robot.supply_guard) {
      return Error{robot.name + " has no pump to hear of: give supply.pump in its file"};
    }
    const Inputs inputs{
        FARRIER_TRY(
            participant.subscribe<signals::JointSensors>(robot::joint_numbers(robot), robot::legs_of_joints(robot))),
        FARRIER_TRY(participant.subscribe<signals::BodyImu>({0})),
        // An operator may come and go: no command has to be heard before the run starts.
        FARRIER_TRY(participant.subscribe<signals::BodyCommand>({})),
        FARRIER_TRY(participant.publish<signals::BodyState>({0})),
        hears_supply ? FARRIER_TRY(participant.subscribe<signals::SupplyState>({0})) : nullptr,
    };
    return std::unique_ptr<Locomotion>(
        new BodyLocomotion(robot, std::move(controller), std::move(script), participant, ports, inputs, ticks));
  }

 private:
  struct Inputs {
    participant::In<signals::JointSensors>* sensors;
    participant::In<signals::BodyImu>* imu;
    participant::In<signals::BodyCommand>* commands;
    participant::Out<signals::BodyState>* state;
    participant::In<signals::SupplyState>* supply;  ///< null for a robot without a pump
  };

  BodyLocomotion(const robot::Robot& robot, std::unique_ptr<Controller> controller, std::vector<TimedCommand> script,
                 participant::Participant& participant, Ports ports, Inputs inputs, Tick ticks)
      : Locomotion(robot, participant, ports, ticks),
        controller_(std::move(controller)),
        script_(std::move(script)),
        inputs_(inputs),
        inbox_(robot),
        guard_(robot.supply_guard.value_or(SupplyGuardParams{}), robot.period_s) {}

  void prime() override;
  void drain() override;
  bool ready(Tick tick) const override {
    return !lockstep() ||
           (inbox_.complete(tick) && (inputs_.supply == nullptr || supply_tick_ >= robot().due_supply(tick)));
  }
  void begin(Tick first, Tick tick) override;
  MotionCommand command_at_tick(Tick tick) const noexcept;
  void tell_demand(SupplyDemand before, Tick tick);
  void tell_dead_joint(const LocomotionState& state, Tick tick);
  void command_joints(const Readings& readings, const LegTorques& torques_Nm, Tick tick);
  void announce_switches(Tick tick);

  // In real time joints damp, and trip later, when samples are older than this: no torque answers stale readings.
  static constexpr Tick kStale = 5;
  // In real time an operator who steers repeats the command; after so long a silence the robot stands.
  static constexpr auto kOperatorSilent = std::chrono::milliseconds(500);
  // After a pause the controller makes up for at most so many ticks.
  static constexpr Tick kMostTicks = 100;

  std::unique_ptr<Controller> controller_;
  std::vector<TimedCommand> script_;
  Inputs inputs_;
  ReadingsInbox inbox_;
  std::optional<MotionCommand> asked_;  ///< by an operator
  SteadyTime asked_at_{};
  SupplyGuard guard_;
  std::optional<SupplyReading> supply_;  ///< the newest
  Tick supply_tick_ = kNoTick;           ///< of it
  std::optional<LegJoint> dead_joint_;   ///< that was reported
};

// Tick 0 begins at rest in the home pose, before any reading: no torque.
void BodyLocomotion::prime() {
  Readings home;
  for (const robot::Joint& joint : robot().joints) {
    home.legs[static_cast<std::size_t>(joint.leg)].position_rad[joint.index_in_leg] = joint.home_angle_rad;
  }
  LegTorques none;
  none.fill(Eigen::Vector3d::Zero());
  command_joints(home, none, 0);
}

void BodyLocomotion::drain() {
  inputs_.sensors->drain([this](const signals::JointSensors& sensors) { inbox_.put(sensors); });
  inputs_.imu->drain([this](const signals::BodyImu& imu) { inbox_.put(imu); });
  if (inputs_.supply != nullptr) {
    inputs_.supply->drain([this](const signals::SupplyState& supply) {
      supply_ = {supply.pressure_Pa, supply.pump_flow_m3_s};
      supply_tick_ = supply.tick;
    });
  }
  inputs_.commands->drain([this](const signals::BodyCommand& command) {
    if (command.session == participant().identity().session && is_possible(command)) {
      asked_ = {.request = command.request,
                .forward_m_s = command.forward_m_s,
                .left_m_s = command.left_m_s,
                .yaw_rate_rad_s = command.yaw_rate_rad_s,
                .height_m = command.height_m};
      asked_at_ = participant::steady_now();
    }
  });
}

MotionCommand BodyLocomotion::command_at_tick(Tick tick) const noexcept {
  return asked_.value_or(command_at(script_, static_cast<double>(tick) * robot().period_s));
}

void BodyLocomotion::announce_switches(Tick tick) {
  for (std::size_t leg = 0; leg < robot().plan.legs.size(); ++leg) {
    if (const auto next = controller_->announcement(static_cast<int>(leg))) {
      const auto number = static_cast<std::uint16_t>(leg);
      announce(number,
               {number, next->count, tick, next->tick, next->phase, static_cast<std::uint8_t>(next->felt ? 1 : 0)});
    }
  }
}

void BodyLocomotion::command_joints(const Readings& readings, const LegTorques& torques_Nm, Tick tick) {
  for (const robot::Joint& joint : robot().joints) {
    const auto leg = static_cast<std::size_t>(joint.leg);
    signals::JointCommand command = command_for(joint, tick);
    command.position_rad =
        std::clamp(readings.legs[leg].position_rad[joint.index_in_leg], joint.angle_min_rad, joint.angle_max_rad);
    command.torque_ff_Nm = torques_Nm[leg][joint.index_in_leg];
    ports().commands->publish(command);
  }
  ports().commands->flush();
}

void BodyLocomotion::begin(Tick first, Tick tick) {
  if (!lockstep() && inbox_.oldest() < tick - kStale) {
    return;
  }
  if (!lockstep() && asked_ && asked_->request == Request::kTrot &&
      participant::steady_now() - asked_at_ > kOperatorSilent) {
    asked_ = {.request = Request::kStand};
  }
  const Readings readings = inbox_.read();
  const LegTorques* torques_Nm = nullptr;
  MotionCommand command;
  for (Tick each = std::max(first, tick - kMostTicks); each <= tick; ++each) {
    const SupplyDemand before = guard_.demand();
    command = guard_.step(command_at_tick(each), supply_);
    tell_demand(before, each);
    torques_Nm = &controller_->step(each, readings, command);
    announce_switches(each + 1);
  }
  FARRIER_ENSURE(torques_Nm != nullptr, "a tick has begun");
  command_joints(readings, *torques_Nm, tick + 1);
  if (const LocomotionState* state = controller_->published_state()) {
    tell_dead_joint(*state, tick);
    inputs_.state->publish(body_state_signal(*state, command, tick));
  }
}

void BodyLocomotion::tell_demand(SupplyDemand before, Tick tick) {
  using enum participant::EventKind;
  const SupplyDemand now = guard_.demand();
  if (now > before) {
    const auto kind =
        now == SupplyDemand::kLie ? kSupplyLie : (now == SupplyDemand::kStand ? kSupplyStand : kSupplySlow);
    participant().event(kind, tick, signals::kNoJoint);
  } else if (now == SupplyDemand::kNone && before == SupplyDemand::kSlow) {
    participant().event(kSupplyFast, tick, signals::kNoJoint);
  }
}

void BodyLocomotion::tell_dead_joint(const LocomotionState& state, Tick tick) {
  if (state.dead_joint && state.dead_joint != dead_joint_) {
    for (const robot::Joint& joint : robot().joints) {
      if (joint.leg == state.dead_joint->leg && joint.index_in_leg == state.dead_joint->index) {
        participant().event(participant::EventKind::kJointDead, tick, joint.number);
      }
    }
  }
  dead_joint_ = state.dead_joint;
}

}  // namespace

Result<std::unique_ptr<Locomotion>> create_body_locomotion(const robot::Robot& robot,
                                                           std::unique_ptr<Controller> controller,
                                                           std::vector<TimedCommand> script,
                                                           participant::Participant& participant, Tick ticks,
                                                           bool hears_supply) {
  return BodyLocomotion::create(robot, std::move(controller), std::move(script), participant, ticks, hears_supply);
}

}  // namespace farrier::locomotion
