// A joint of every kind of controller, with what may come to it in any order and with any content.

#include <cmath>
#include <map>

#include "joint_node/gains_check.hpp"
#include "joint_node/joint_node.hpp"
#include "participant/arrival.hpp"
#include "supervisor/joint_design.hpp"
#include "supervisor/supervisor.hpp"
#include "tests/fuzz/input.hpp"
#include "tests/fuzz/robots.hpp"
#include "wire_gains/wire_gains.hpp"

namespace farrier::fuzz {
namespace {

using joint_node::JointNode;

constexpr std::uint64_t kSession = 77;
constexpr int kDelayTicks = 1;

struct Kind {
  robot::Robot robot;
  std::vector<signals::JointControllerGains> gains;  ///< by joint, of stance
};

const Kind& kind_of(control::Kind kind) {
  static std::map<control::Kind, Kind> kinds;
  const auto place = kinds.find(kind);
  if (place != kinds.end()) {
    return place->second;
  }
  Kind made{load_hyq({}, kind), {}};
  for (const robot::Joint& joint : made.robot.joints) {
    const auto designed = supervisor::design_joint(joint, joint.stance_load, made.robot.period_s, kDelayTicks);
    require(designed.ok(), "a shipped joint has gains");
    made.gains.push_back(
        wire_gains::with_physics(wire_gains::pack_gains(joint.number, signals::Phase::kStance, 1, 1, designed.value()),
                                 plant::nominal_physics(joint.actuator, joint.stance_load)));
  }
  return kinds.emplace(kind, std::move(made)).first->second;
}

class Bench {
 public:
  Bench(const Kind& kind, const robot::Joint& joint)
      : joint_(joint),
        good_gains_(kind.gains[joint.number]),
        node_(joint, kind.robot.safety, kind.robot.period_s, kDelayTicks, kSession) {
    node_.set_mode({.robot = 0, .epoch = 1, .session = kSession, .effective_tick = 0, .mode = signals::Mode::kArmed});
    for (signals::JointControllerGains gains = good_gains_; gains.generation <= 2; ++gains.generation) {
      gains.phase = static_cast<signals::Phase>(gains.generation - 1);
      gains.effective_tick = 0;
      offer(gains);
    }
    // Calm samples until the joint tracks.
    const double home = joint.linkage.position(joint.home_angle_rad);
    inputs_.sensors.joint = inputs_.command.joint = joint.number;
    inputs_.command.position_rad = joint.home_angle_rad;
    inputs_.command.stiffness_Nm_rad = joint.stiffness_Nm_rad;
    for (Tick tick = 0; tick < 2 * kind.robot.safety.recovery_samples; ++tick) {
      inputs_.tick = inputs_.sensors.tick = inputs_.command.tick = tick;
      inputs_.sensors.position_m_or_rad = home + 1e-6 * static_cast<double>(tick % 2);  // not frozen
      step();
    }
  }

  void next(Input& input) {
    switch (input.below(8)) {
      case 0:
        offer(input.signal<signals::JointControllerGains>());
        return;
      case 1:
        offer(gains_with_one_odd_field(input));
        return;
      case 2: {
        auto mode = input.signal<signals::SystemMode>();
        mode.session = input.byte() % 4 != 0 ? kSession : mode.session;
        mode.effective_tick = input.tick(inputs_.tick);
        node_.set_mode(mode);
        return;
      }
      case 3: {
        auto phase = input.signal<signals::GaitPhase>();
        phase.phase = static_cast<signals::Phase>(input.below(3));
        phase.switch_tick = input.tick(inputs_.tick);
        node_.announce_phase(phase);
        return;
      }
      case 4:
        command(input);
        break;
      default:
        sensors(input);
        break;
    }
    step();
  }

 private:
  void offer(const signals::JointControllerGains& signal) {
    if (joint_node::check_gains(signal, joint_.kind)) {
      node_.store_gains(signal, wire_gains::unpack_gains(signal));
    } else {
      node_.refuse_gains(signal);
    }
  }

  signals::JointControllerGains gains_with_one_odd_field(Input& input) {
    signals::JointControllerGains gains = good_gains_;
    gains.generation = node_.newest_generation() + 1;
    gains.phase = static_cast<signals::Phase>(input.below(signals::kPhaseCount));
    gains.effective_tick = input.tick(inputs_.tick);
    const std::size_t odd = input.below(32);
    std::size_t place = 0;
    signals::visit_fields(gains, [&](const char*, auto& field) {
      if constexpr (std::is_same_v<std::remove_cvref_t<decltype(field)>, double>) {
        if (place++ == odd) {
          field = input.number(1e3);
        }
      } else if constexpr (requires { field.size(); }) {
        if (place++ == odd) {
          field[input.below(field.size())] = input.number(1e3);
        }
      }
    });
    return gains;
  }

  void command(Input& input) {
    signals::JointCommand& command = inputs_.command;
    command.tick = input.tick(command.tick);
    command.position_rad = input.number(3);
    command.velocity_rad_s = input.number(30);
    command.torque_ff_Nm = input.number(300);
    command.stiffness_Nm_rad = input.number(1e3);
    command.damping_Nms_rad = input.number(50);
    inputs_.command_age_s = input.byte() % 8 == 0 ? input.number(0.1) : 0.0;
    inputs_.since_last_step_s = input.byte() % 64 == 0 ? input.number(0.1) : 0.001;
  }

  void sensors(Input& input) {
    signals::JointSensors& sensors = inputs_.sensors;
    inputs_.tick = sensors.tick = input.tick(sensors.tick);
    // Two of three channels stay near what they were, so that the joint is not at null all the time.
    const std::size_t odd = input.below(6);
    sensors.position_m_or_rad = odd == 0 ? input.number(0.1) : 0.5 * joint_.actuator.stroke + 1e-4 * input.byte();
    sensors.velocity_m_s_or_rad_s = odd == 1 ? input.number(5) : 1e-3 * input.byte();
    sensors.force_N_or_Nm = odd == 2 ? input.number(1e4) : 10.0 * input.byte();
    sensors.sample_time_ns = odd == 3 ? input.raw<std::int64_t>() : sensors.tick;
    inputs_.sensors_age_s = odd == 4 ? input.number(0.01) : 0.0;
  }

  void step() {
    const JointNode::Outputs outputs = node_.step(inputs_);
    // Written so that a NaN fails.
    require(std::abs(outputs.valve.valve_current_A) <= joint_.actuator.valve_current_max_A,
            "a valve current is within the valve's limits");
    require(outputs.valve.force_reference_N_or_Nm <= joint_.push_limit &&
                outputs.valve.force_reference_N_or_Nm >= -joint_.pull_limit,
            "a force reference is within what the actuator can do");
    require(outputs.valve.state <= signals::JointState::kTracking && known(outputs.valve.phase),
            "state and phase are some there are");
    require(outputs.measurement.valve_current_A == outputs.valve.valve_current_A, "what is measured is what is sent");
  }

  const robot::Joint& joint_;
  const signals::JointControllerGains& good_gains_;
  JointNode node_;
  JointNode::Inputs inputs_;
};

}  // namespace

void joint_node(Bytes bytes) {
  static constexpr control::Kind kKinds[] = {control::Kind::kLqr, control::Kind::kFeedbackLinearisation,
                                             control::Kind::kPid, control::Kind::kFlowInversion};
  static constexpr const char* kJoints[] = {"lf_haa", "lf_hfe", "lf_kfe"};
  Input input(bytes);
  const Kind& kind = kind_of(kKinds[input.below(std::size(kKinds))]);
  Bench bench(kind, *kind.robot.find(kJoints[input.below(std::size(kJoints))]));
  while (!input.empty()) {
    bench.next(input);
  }
}

}  // namespace farrier::fuzz
