#include "tools/faults/fault_rows.hpp"

#include <csignal>

#include "core/fault.hpp"
#include "joint_node/fault_assessor.hpp"
#include "participant/event_registry.hpp"

namespace farrier::faults {
namespace {

// Limits of the shipped robots. On top of each come a control period of each of the two loops, one and a half of the
// joint's where nothing arrives, and the way between them.
constexpr robot::Safety kLimits{.frozen_samples = 10};
constexpr double kPeriod_s = 0.001;
constexpr double kReach_s = 0.004;
constexpr double kStale_s = kLimits.sensors_stale_s + kReach_s;
constexpr double kFrozen_s = kLimits.frozen_samples * kPeriod_s + kReach_s;
constexpr double kDamped_s = kLimits.command_damping_s + kReach_s;
constexpr double kUnread_s = 0.005;  // age of readings that locomotion of a body no longer answers
constexpr double kTripped_s = kLimits.command_trip_s + kReach_s;
constexpr double kSilent_s = kLimits.valve_silent_s + kReach_s;
constexpr double kAtOnce_s = kReach_s;
constexpr double kGoodAgain_s = kLimits.recovery_samples * kPeriod_s + kReach_s;
constexpr double kNever = 0.0;
constexpr double kArmed_s = 0.020 + kReach_s;  // a request's way over two processes, and gain_lead_ticks
constexpr double kTakenOver_s = 0.050;
constexpr double kStartAgain_s = 0.050;
constexpr double kGreeted_s = 1.0;      // a process starts, finds the others and hears every route
constexpr double kCatchesUp_s = 0.006;  // a process that was stopped first takes what has come meanwhile
constexpr double kAfterStop_s = kGoodAgain_s + kCatchesUp_s;
constexpr double kLeaseAndMore_s = 12.0;  // of machine time: by then a process that renews no lease is dropped
constexpr double kHeard_s = 0.020;        // an event's way to the operator
constexpr double kMissed_s = 0.100;       // 50 ms of silence, the period of the silent topic, an event's way

constexpr const char* kJointNode = to_string(Program::kJointNode);
constexpr const char* kSimBridge = to_string(Program::kSimBridge);
constexpr const char* kEstimator = to_string(Program::kEstimatorService);
constexpr const char* kSupervisor = to_string(Program::kSupervisor);
constexpr const char* kLocomotion = to_string(Program::kLocomotion);
constexpr const char* kEverybody = "every process";

Expectation says(participant::EventKind kind, double within_s) {
  return {.event = participant::spec(kind).text, .event_within_s = within_s};
}
Expectation says_estimates_silent() { return says(participant::EventKind::kEstimatesSilent, kMissed_s); }
Expectation says_supervisor_silent() { return says(participant::EventKind::kSupervisorSilent, kMissed_s); }

/// Output, latch and event of the fault's row in the safety table.
Expectation reacts(Fault fault, double within_s, double recovers_s) {
  const FaultInfo& info = info_of(fault);
  return {.reaction = joint_node::state_of(info.output),
          .within_s = within_s,
          .recovers_s = recovers_s,
          .latches = info.latched(),
          .event = info.event_text()};
}

/// `recovers_s`: after the valve's commands come again; 0: they do not.
Expectation spool_to_null(double recovers_s) {
  Expectation expected = reacts(Fault::kActuatorSilent, kSilent_s, recovers_s);
  expected.event_within_s = kSilent_s + kHeard_s;
  return expected;
}

}  // namespace

const std::vector<Row>& rows() {
  // clang-format off
  static const std::vector<Row> all{
      {"sensors_cut", "A joint's sensors stop.",
       "joint_node puts its valve to null; by itself back after 10 good samples.",
       Hit::kJoint, kJointNode, {"joint/sensors:cut"}, 0.1, {},
       reacts(Fault::kSensorsStale, kStale_s, kGoodAgain_s)},
      {"sensors_cut_short", "A joint's sensors stop for 10 ms.", "As when they stop for longer.", Hit::kJoint,
       kJointNode, {"joint/sensors:cut"}, 0.01, {},
       reacts(Fault::kSensorsStale, kStale_s, kGoodAgain_s)},
      {"sensors_cut_long", "A joint's sensors stop for 2 s.", "As when they stop for shorter.", Hit::kJoint, kJointNode,
       {"joint/sensors:cut"}, 2.0, {},
       reacts(Fault::kSensorsStale, kStale_s, kGoodAgain_s)},
      {"sensors_nan", "A joint's encoder reads no number.", "joint_node puts its valve to null; by itself back.",
       Hit::kJoint, kJointNode, {"joint/sensors:nan=position_m_or_rad"}, 0.1, {},
       reacts(Fault::kSensorsStale, kAtOnce_s, kGoodAgain_s)},
      {"force_cell_lost", "A joint's load cell reads no number.",
       "joint_node damps by position: back to where the force was lost, slowly; by itself back.", Hit::kJoint,
       kJointNode, {"joint/sensors:nan=force_N_or_Nm"}, 0.1, {},
       reacts(Fault::kForceLost, kAtOnce_s, kGoodAgain_s)},
      {"sensors_frozen", "A joint's readings stay what they are while samples go on coming.",
       "joint_node takes 10 samples alike for stale ones: valve to null; by itself back.", Hit::kJoint, kJointNode,
       {"joint/sensors:frozen"}, 0.1, {},
       reacts(Fault::kSensorsStale, kFrozen_s, kGoodAgain_s)},
      {"sensors_late", "A joint's sensors come 6 ms late.",
       "joint_node measures how much longer than ever their way is: valve to null; by itself back.", Hit::kJoint,
       kJointNode, {"joint/sensors:delay=6"}, 0.1, {},
       reacts(Fault::kSensorsStale, kStale_s, kGoodAgain_s + 0.006)},
      {"sensors_jitter", "A joint's sensors come 1 to 5 ms late, each by its own.",
       "joint_node puts the valve to null while they are more than 3 ms old.", Hit::kJoint, kJointNode,
       {"joint/sensors:delay=1..5"}, 0.1, {}, {.recovers_s = kGoodAgain_s + 0.006, .may_stutter = true}},
      {"sensors_noisy", "A joint's load cell has noise of 20 N more.", "Everybody goes on.", Hit::kJoint, kJointNode,
       {"joint/sensors:noise=force_N_or_Nm+20"}, 0.1, {}, {}},
      {"sensors_offset", "A joint's load cell reads 50 N too much.", "Everybody goes on.", Hit::kJoint, kJointNode,
       {"joint/sensors:offset=force_N_or_Nm+50"}, 0.1, {}, {}},
      {"command_cut_short", "A joint's commands stop for 20 ms.", "joint_node damps; by itself back.", Hit::kJoint,
       kJointNode, {"joint/command:cut"}, 0.02, {},
       reacts(Fault::kCommandStale, kDamped_s, kReach_s)},
      {"command_cut_long", "A joint's commands stop for 0.1 s.",
       "joint_node damps, then trips: valve to null until an operator arms it again.", Hit::kJoint, kJointNode,
       {"joint/command:cut"}, 0.1, {},
       reacts(Fault::kTripped, kTripped_s, kArmed_s)},
      {"command_cut_for_seconds", "A joint's commands stop for 2 s.", "As when they stop for 0.1 s.", Hit::kJoint,
       kJointNode, {"joint/command:cut"}, 2.0, {},
       reacts(Fault::kTripped, kTripped_s, kArmed_s)},
      {"command_nan", "A joint's commands are no numbers.",
       "joint_node damps; by itself back.", Hit::kJoint, kJointNode,
       {"joint/command:nan=torque_ff_Nm"}, 0.02, {},
       reacts(Fault::kCommandStale, kAtOnce_s, kReach_s)},
      {"valve_cut", "A joint's valve commands do not reach the valve.",
       "sim_bridge puts the spool to null; by itself back.",
       Hit::kJoint, kSimBridge, {"joint/valve_command:cut"}, 0.1, {},
       spool_to_null(kReach_s)},
      {"valve_cut_short", "A joint's valve commands do not reach the valve for 10 ms.", "As when they stop for longer.",
       Hit::kJoint, kSimBridge, {"joint/valve_command:cut"}, 0.01, {},
       spool_to_null(kReach_s)},
      {"valve_cut_long", "A joint's valve commands do not reach the valve for 2 s.", "As when they stop for shorter.",
       Hit::kJoint, kSimBridge, {"joint/valve_command:cut"}, 2.0, {},
       spool_to_null(kReach_s)},
      {"valve_nan", "A joint's valve commands are no numbers.", "sim_bridge takes none: as when they do not come.",
       Hit::kJoint, kSimBridge, {"joint/valve_command:nan=valve_current_A"}, 0.1, {},
       spool_to_null(kReach_s)},
      {"loss_1", "1 % of a leg's sensors and commands are lost.", "joint_node goes on with the last ones.", Hit::kLeg,
       kJointNode, {"joint/sensors:loss=0.01", "joint/command:loss=0.01"}, 0.2, {},
       {.recovers_s = kGoodAgain_s, .may_stutter = true}},
      {"loss_5", "5 % of a leg's sensors and commands are lost.", "joint_node goes on with the last ones.", Hit::kLeg,
       kJointNode, {"joint/sensors:loss=0.05", "joint/command:loss=0.05"}, 0.2, {},
       {.recovers_s = kGoodAgain_s, .may_stutter = true}},
      {"loss_20", "20 % of a leg's sensors and commands are lost.",
       "joint_node goes on with the last ones; four lost in a row are stale sensors.", Hit::kLeg, kJointNode,
       {"joint/sensors:loss=0.2", "joint/command:loss=0.2"}, 0.2, {},
       {.recovers_s = kGoodAgain_s, .may_stutter = true}},
      {"bursts", "A leg's sensors and commands are lost in rows of 8.", "As when they are cut for 8 ms.", Hit::kLeg,
       kJointNode, {"joint/sensors:burst=0.01x8", "joint/command:burst=0.01x8"}, 0.2, {},
       {.recovers_s = kGoodAgain_s, .may_stutter = true}},
      {"duplicates", "Half of a leg's sensors and commands come twice.", "joint_node takes the first.", Hit::kLeg,
       kJointNode, {"joint/sensors:duplicate=0.5", "joint/command:duplicate=0.5"}, 0.1, {}, {}},
      {"reordered", "A third of a leg's sensors and commands come after their successors.",
       "joint_node takes none that is older than what it has.", Hit::kLeg, kJointNode,
       {"joint/sensors:reorder=0.33", "joint/command:reorder=0.33"}, 0.1, {},
       {.recovers_s = kGoodAgain_s, .may_stutter = true}},
      {"measurement_cut", "The estimator hears no joint.", "Gains stay as they are.", Hit::kAll, kEstimator,
       {"joint/measurement:cut"}, 0.2, {}, says_estimates_silent()},
      {"estimate_cut", "The supervisor hears no estimate.", "Gains stay as they are.", Hit::kAll, kSupervisor,
       {"joint/model_estimate:cut"}, 0.2, {}, says_estimates_silent()},
      {"measurement_cut_long", "The estimator hears no joint for 2 s.", "Gains stay as they are.", Hit::kAll,
       kEstimator, {"joint/measurement:cut"}, 2.0, {}, says_estimates_silent()},
      {"estimate_cut_long", "The supervisor hears no estimate for 2 s.", "Gains stay as they are.", Hit::kAll,
       kSupervisor, {"joint/model_estimate:cut"}, 2.0, {}, says_estimates_silent()},
      {"gains_cut", "A leg's gains stop for 2 s.", "joint_node goes on with those it has.", Hit::kLeg, kJointNode,
       {"joint/controller_gains:cut"}, 2.0, {}, {}, false, robot::Design::kAdaptive, Where::kBench},
      {"phase_cut", "A leg does not hear for 0.2 s when it will lift off or land.", "joint_node goes on with the gains it has.",
       Hit::kLeg, kJointNode, {"gait/phase:cut"}, 0.2, {}, {}},
      {"mode_cut", "The mode does not reach a leg for 2 s.", "joint_node goes on in the mode it knows.", Hit::kLeg,
       kJointNode, {"system/mode:cut"}, 2.0, {}, says_supervisor_silent()},
      {"clock_cut_short", "Locomotion does not hear the clock for 20 ms.",
       "It commands nothing: joint_node of every leg damps; by itself back.", Hit::kAll, kLocomotion,
       {"clock/tick:cut"}, 0.02, {},
       reacts(Fault::kCommandStale, kDamped_s, kReach_s)},
      {"clock_cut_long", "Locomotion does not hear the clock for 2 s.",
       "It commands nothing: joint_node of every leg damps, then trips: valve to null until an operator arms it again.",
       Hit::kAll, "locomotion", {"clock/tick:cut"}, 2.0, {},
       reacts(Fault::kTripped, kTripped_s, kArmed_s)},
      {"imu_cut_short", "Locomotion does not hear the IMU for 20 ms.",
       "It commands nothing from 5 ms on: joint_node of every leg damps; by itself back.", Hit::kAll, kLocomotion,
       {"body/imu:cut"}, 0.02, {},
       reacts(Fault::kCommandStale, kUnread_s + kDamped_s, kReach_s), false, robot::Design::kPhases, Where::kGround},
      {"imu_cut_long", "Locomotion does not hear the IMU for 0.1 s.",
       "It commands nothing from 5 ms on: joint_node of every leg damps, then trips: valve to null until an operator "
       "arms it again.",
       Hit::kAll, kLocomotion, {"body/imu:cut"}, 0.1, {},
       reacts(Fault::kTripped, kUnread_s + kTripped_s, kArmed_s), false, robot::Design::kPhases, Where::kGround},
      {"readings_nan", "Locomotion reads no numbers from the encoders for 20 ms.",
       "It commands nothing from 5 ms on: joint_node of every leg damps; by itself back.", Hit::kAll, kLocomotion,
       {"joint/sensors:nan=position_m_or_rad"}, 0.02, {},
       reacts(Fault::kCommandStale, kUnread_s + kDamped_s, kReach_s), false, robot::Design::kPhases, Where::kGround},
      {"supply_cut", "Locomotion does not hear the state of the supply for 2 s.", "Everybody goes on.", Hit::kAll,
       kLocomotion, {"supply/state:cut"}, 2.0, {}, {}, false, robot::Design::kPhases, Where::kSupply},
      {"joint_node_killed", "joint_node of a leg dies (kill -9).",
       "sim_bridge puts its three spools to null.", Hit::kLeg,
       nullptr, {}, 0.1, {{kJointNode, SIGKILL, 0.0}},
       spool_to_null(0.0)},
      {"joint_node_stopped_short", "joint_node of a leg stands still for 30 ms (SIGSTOP).",
       "sim_bridge puts its three spools to null; by itself back.", Hit::kLeg, nullptr, {}, 0.03,
       {{kJointNode, SIGSTOP, 0.0}, {kJointNode, SIGCONT, 0.03}},
       spool_to_null(kAfterStop_s)},
      {"joint_node_stopped_long", "joint_node of a leg stands still for 0.1 s (SIGSTOP).",
       "sim_bridge puts its three spools to null; its joints, which obeyed no command for more than 50 ms when it goes "
       "on, trip: null until an operator arms them again.",
       Hit::kLeg, nullptr, {}, 0.1, {{kJointNode, SIGSTOP, 0.0}, {kJointNode, SIGCONT, 0.1}},
       reacts(Fault::kTripped, kSilent_s, kArmed_s)},
      {"sim_bridge_killed", "sim_bridge, or the driver in its place, dies (kill -9).",
       "joint_node has no sensors: its commands are null. No clock: locomotion is silent, joints trip.", Hit::kAll,
       nullptr, {}, 0.2, {{kSimBridge, SIGKILL, 0.0}},
       {.event = info_of(Fault::kSensorsStale).event_text(), .event_within_s = kStale_s + kHeard_s}},
      {"sim_bridge_stopped_short", "sim_bridge, or the driver in its place, stands still for 30 ms (SIGSTOP).",
       "joint_node puts its valves to null; by itself back.", Hit::kAll, nullptr, {}, 0.03,
       {{kSimBridge, SIGSTOP, 0.0}, {kSimBridge, SIGCONT, 0.03}},
       reacts(Fault::kSensorsStale, kStale_s, kAfterStop_s)},
      {"sim_bridge_stopped_long", "sim_bridge, or the driver in its place, stands still for 0.1 s (SIGSTOP).",
       "joint_node puts its valves to null. No clock: locomotion is silent, joints trip: null until an operator arms "
       "them again.",
       Hit::kAll, nullptr, {}, 0.1, {{kSimBridge, SIGSTOP, 0.0}, {kSimBridge, SIGCONT, 0.1}},
       reacts(Fault::kTripped, kStale_s, kArmed_s)},
      {"locomotion_killed", "locomotion, or the planner in its place, dies (kill -9).",
       "joint_node of every leg damps, then trips: valve to null until an operator arms it again.", Hit::kAll, nullptr, {}, 0.2,
       {{kLocomotion, SIGKILL, 0.0}},
       reacts(Fault::kTripped, kTripped_s, kNever)},
      {"locomotion_restarted", "locomotion, or the planner in its place, dies (kill -9) and is started again.",
       "joint_node of every leg damps, then trips: valve to null until an operator arms it again.", Hit::kAll, nullptr,
       {}, 1.2, {{kLocomotion, SIGKILL, 0.0}, {kLocomotion, run::kStart, kStartAgain_s}},
       reacts(Fault::kTripped, kTripped_s, kArmed_s)},
      {"locomotion_stopped_short", "locomotion, or the planner in its place, stands still for 30 ms (SIGSTOP).",
       "joint_node of every leg damps; by itself back.", Hit::kAll, nullptr, {}, 0.03,
       {{kLocomotion, SIGSTOP, 0.0}, {kLocomotion, SIGCONT, 0.03}},
       reacts(Fault::kCommandStale, kDamped_s, kReach_s + kCatchesUp_s)},
      {"locomotion_stopped_long", "locomotion, or the planner in its place, stands still for 0.1 s (SIGSTOP).",
       "joint_node of every leg damps, then trips: valve to null until an operator arms it again.", Hit::kAll, nullptr,
       {}, 0.1, {{kLocomotion, SIGSTOP, 0.0}, {kLocomotion, SIGCONT, 0.1}},
       reacts(Fault::kTripped, kTripped_s, kArmed_s)},
      {"clock_forward", "The computer's clock is set an hour forward.", "Everybody goes on: ages are of the steady clock.",
       Hit::kAll, nullptr, {}, kLeaseAndMore_s, {{kEverybody, run::kClockForward, 0.0}}, {}},
      {"clock_back", "The computer's clock is set an hour back.", "Everybody goes on: ages are of the steady clock.",
       Hit::kAll, nullptr, {}, kLeaseAndMore_s, {{kEverybody, run::kClockBack, 0.0}}, {}},
      {"estimator_killed", "estimator_service dies (kill -9).", "Gains stay as they are.", Hit::kAll, nullptr, {}, 0.2,
       {{kEstimator, SIGKILL, 0.0}}, says_estimates_silent()},
      {"estimator_restarted", "estimator_service dies (kill -9) and is started again.",
       "Gains stay as they are; it greets the others and estimates anew.", Hit::kAll, nullptr, {}, 1.2,
       {{kEstimator, SIGKILL, 0.0}, {kEstimator, run::kStart, kStartAgain_s}},
       {.event = "estimates from now on", .event_within_s = kStartAgain_s + kGreeted_s}},
      {"estimator_stopped", "estimator_service stands still for 0.2 s (SIGSTOP).", "Gains stay as they are.", Hit::kAll,
       nullptr, {}, 0.2, {{kEstimator, SIGSTOP, 0.0}, {kEstimator, SIGCONT, 0.2}}, says_estimates_silent()},
      {"supervisor_killed", "supervisor dies (kill -9).",
       "Gains and mode stay as they are.", Hit::kAll, nullptr, {}, 0.2,
       {{kSupervisor, SIGKILL, 0.0}}, says_supervisor_silent()},
      {"supervisor_stopped", "supervisor stands still for 0.2 s (SIGSTOP).", "Gains and mode stay as they are.",
       Hit::kAll, nullptr, {}, 0.2, {{kSupervisor, SIGSTOP, 0.0}, {kSupervisor, SIGCONT, 0.2}}, says_supervisor_silent()},
      {"supervisor_restarted", "supervisor dies (kill -9) and is started again.",
       "Gains and mode stay as they are; it leads under the next authority and issues what estimates ask for.",
       Hit::kAll, nullptr, {}, 1.2, {{kSupervisor, SIGKILL, 0.0}, {kSupervisor, run::kStart, kStartAgain_s}},
       {.event = "leads with authority 2", .event_within_s = kStartAgain_s + kGreeted_s}},
      {"supervisor_replaced", "supervisor dies (kill -9) while another stands by.",
       "The other leads under the next authority and writes every gain and the mode again.", Hit::kAll, nullptr, {},
       0.2, {{kSupervisor, SIGKILL, 0.0}}, {.event = "leads with authority 2", .event_within_s = kTakenOver_s}, true},
      {"monitor_stopped", "A monitor of all streams joins, stands still (SIGSTOP) and dies (kill -9).",
       "Everybody goes on: no writer waits for one who only watches.", Hit::kAll, nullptr, {}, 1.5,
       {{run::kMonitor, run::kStart, 0.0}, {run::kMonitor, SIGSTOP, 0.8}, {run::kMonitor, SIGKILL, 1.5}}, {}},
      {"monitor_slow", "A monitor of all streams runs for 20 ms of every 0.2 s.",
       "Everybody goes on: what the monitor does not take is overwritten.", Hit::kAll, nullptr, {}, 1.6,
       {{run::kMonitor, run::kStart, 0.0}, {run::kMonitor, SIGSTOP, 0.8}, {run::kMonitor, SIGCONT, 1.0}, {run::kMonitor, SIGSTOP, 1.02},
        {run::kMonitor, SIGCONT, 1.2}, {run::kMonitor, SIGSTOP, 1.22}, {run::kMonitor, SIGCONT, 1.4}, {run::kMonitor, SIGSTOP, 1.42},
        {run::kMonitor, SIGKILL, 1.6}}, {}},
      {"two_joint_nodes", "A second joint_node claims the joints of a leg.",
       "It finds its place taken, says so and ends with status 1.", Hit::kAll, nullptr, {}, 0.5,
       {{kJointNode, run::kStartTwin, 0.0}}, {.event = "of this run already", .event_within_s = 0.5}},
      {"supervisor_stale", "supervisor stands still for 0.1 s (SIGSTOP) while another stands by.",
       "The other leads; the first finds that it was replaced and stands by; joints refuse what it still writes.",
       Hit::kAll, nullptr, {}, 0.1, {{kSupervisor, SIGSTOP, 0.0}, {kSupervisor, SIGCONT, 0.1}},
       {.event = "stands by: another supervisor leads", .event_within_s = 0.1 + kTakenOver_s}, true},
  };
  // clang-format on
  return all;
}

}  // namespace farrier::faults
