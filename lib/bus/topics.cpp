#include "bus/topics.hpp"

#include "bus/key.hpp"
#include "core/ensure.hpp"
#include "core/noise.hpp"
#include "signals/idl_text.hpp"

namespace farrier::bus {
namespace {

using namespace std::chrono_literals;

// Freshness is what counts. A reader that waits for a stream judges the age of its samples. A DDS deadline or lease
// would report the same later, and would wake a timer thread of the vendor with every sample (docs/decisions/0047).
constexpr Qos kLatest{Reliability::kBestEffort, Durability::kVolatile, 1, kInfinite, Liveliness::kAutomatic,
                        kInfinite, Ownership::kShared};
// Authority over the robot. A standby supervisor takes over after silence, and its samples carry a higher authority
// number (docs/decisions/0040).
constexpr Qos kAuthority{Reliability::kReliable, Durability::kTransientLocal, 1, kInfinite,
                         Liveliness::kManualByTopic, 20ms, Ownership::kExclusive};
constexpr Qos announcements(int depth) {
  return {Reliability::kReliable, Durability::kTransientLocal, depth, kInfinite, Liveliness::kAutomatic, kInfinite,
          Ownership::kShared};
}
constexpr Qos kRequests{Reliability::kReliable, Durability::kVolatile, 4, kInfinite, Liveliness::kAutomatic, kInfinite,
                        Ownership::kShared};
constexpr Qos kLockstepOnly{Reliability::kReliable, Durability::kVolatile, 1, kInfinite, Liveliness::kAutomatic,
                            kInfinite, Ownership::kShared};

// Journals of one stream that a recorder in lock-step may leave lying.
constexpr int kJournals = 64;

// A sample for tick k + 1 may arrive before the one for tick k is taken; four leave room to spare.
constexpr int kTwoTicks = 4;

// Decisions of a joint that a monitor may leave lying, or join too late for; a joint is redesigned a few times a run.
constexpr int kDecisions = 64;

// Events of a participant that a monitor may leave lying, or join too late for. Cyclone DDS keeps 4 KiB for each, so
// this bounds by how much a process grows while it reports. Lock-step may report many between two looks.
constexpr int kEvents = 200;
constexpr int kEventsLockstep = 1000;

#define FARRIER_TOPIC(Signal, name, file, writers, readers, key, version, route, sending, qos, depth) \
  TopicSpec{TopicId::k##Signal, name, "wire::" #Signal, #file ".idl", writers, readers, key, version, route, sending, sizeof(signals::Signal), qos, depth}

// All but the clock itself.
constexpr RoleSet kTickers{Role::kEstimatorService, Role::kSupervisor, Role::kGaitSource, Role::kJointNode,
                           Role::kLauncher};

constexpr RoleSet kRequesters{Role::kOperator, Role::kLauncher};

// clang-format off
constexpr std::array<TopicSpec, kTopicCount> kTopics{
    FARRIER_TOPIC(JointSensors, "joint/sensors", joint_sensors, {Role::kSimBridge}, "joint_node", "joint", 1, Route::kLeg, Sending::kTogether, kLatest, kTwoTicks),
    FARRIER_TOPIC(JointCommand, "joint/command", joint_command, {Role::kGaitSource}, "joint_node", "joint", 1, Route::kLeg, Sending::kTogether, kLatest, kTwoTicks),
    FARRIER_TOPIC(JointValveCommand, "joint/valve_command", joint_valve_command, {Role::kJointNode}, "sim_bridge", "joint", 1, Route::kRobot, Sending::kTogether, kLatest, kTwoTicks),
    FARRIER_TOPIC(JointMeasurement, "joint/measurement", joint_measurement, {Role::kJointNode}, "estimator_service", "joint", 1, Route::kRobot, Sending::kTogether, kLatest, kTwoTicks),
    FARRIER_TOPIC(JointModelEstimate, "joint/model_estimate", joint_model_estimate, {Role::kEstimatorService}, "supervisor", "joint", 3, Route::kRobot, Sending::kAtOnce, kLatest, kTwoTicks),
    FARRIER_TOPIC(JointControllerGains, "joint/controller_gains", joint_controller_gains, {Role::kSupervisor}, "joint_node, sim_bridge", "joint, phase", 3, Route::kLeg, Sending::kAtOnce, kAuthority, kTwoTicks),
    FARRIER_TOPIC(JointUpdateDecision, "joint/update_decision", joint_update_decision, {Role::kSupervisor}, "monitors", "joint", 2, Route::kRobot, Sending::kAtOnce, announcements(kDecisions), kDecisions),
    FARRIER_TOPIC(GaitPhase, "gait/phase", gait_phase, {Role::kGaitSource}, "joint_node", "leg", 1, Route::kRobot, Sending::kAtOnce, announcements(4), 4),
    FARRIER_TOPIC(SystemHello, "system/hello", system_hello, kParticipantRoles, "all", "participant", 2, Route::kRobot, Sending::kAtOnce, announcements(1), 1),
    FARRIER_TOPIC(SystemHealth, "system/health", system_health, kParticipantRoles, "monitors", "participant", 3, Route::kRobot, Sending::kAtOnce, announcements(1), 1),
    FARRIER_TOPIC(SystemEvent, "system/event", system_event, kParticipantRoles, "monitors", "participant", 1, Route::kRobot, Sending::kAtOnce, announcements(kEvents), kEventsLockstep),
    FARRIER_TOPIC(SystemMode, "system/mode", system_mode, {Role::kSupervisor}, "joint_node, sim_bridge", "robot", 2, Route::kRobot, Sending::kAtOnce, kAuthority, kTwoTicks),
    FARRIER_TOPIC(SystemRequest, "system/request", system_request, kRequesters, "supervisor", "robot", 1, Route::kRobot, Sending::kAtOnce, kRequests, kTwoTicks),
    FARRIER_TOPIC(ClockTick, "clock/tick", clock_tick, {Role::kSimBridge}, "gait_source, supervisor, launcher", "clock", 1, Route::kRobot, Sending::kAtOnce, kLatest, kTwoTicks),
    FARRIER_TOPIC(ClockTickDone, "clock/tick_done", clock_tick_done, kTickers, "sim_bridge", "participant", 1, Route::kRobot, Sending::kAtOnce, kLockstepOnly, kTwoTicks),
    FARRIER_TOPIC(JointSummary, "lf/joint/summary", joint_summary, {Role::kJointNode}, "monitors", "joint", 2, Route::kRobot, Sending::kTogether, kLatest, kTwoTicks),
    FARRIER_TOPIC(JointModelEstimateCopy, "lf/joint/model_estimate", joint_model_estimate_copy, {Role::kEstimatorService}, "monitors", "joint", 1, Route::kRobot, Sending::kTogether, kLatest, kTwoTicks),
    FARRIER_TOPIC(SystemJournal, "system/journal", system_journal, kParticipantRoles, "recorders", "stream", 2, Route::kRobot, Sending::kAtOnce, kLatest, kJournals),
};
// clang-format on
#undef FARRIER_TOPIC

constexpr bool in_order() {
  for (std::size_t i = 0; i < kTopics.size(); ++i) {
    if (static_cast<std::size_t>(kTopics[i].id) != i) {
      return false;
    }
  }
  return true;
}
static_assert(in_order(), "the registry is indexed by TopicId");

/// "JointCommand: @key unsigned short joint; unsigned long long tick; ...".
template <class Signal>
std::string struct_text(const char* name) {
  std::string text = std::string(name) + ":";
  std::size_t index = 0;
  signals::visit_fields(Signal{}, [&](const char* field_name, const auto& field) {
    text += (index++ < kKeyFields<Signal> ? " @key " : " ") + signals::idl_text(field_name, field) + ';';
  });
  return text + '\n';
}

}  // namespace

std::span<const TopicSpec> topics() { return kTopics; }

const TopicSpec& spec(TopicId id) { return kTopics[static_cast<std::size_t>(id)]; }

Qos qos_for(const TopicSpec& topic, ClockKind clock) {
  if (clock == ClockKind::kRealtime) {
    return topic.realtime;
  }
  Qos qos = topic.realtime;
  if (topic.id != TopicId::kSystemJournal) {
    qos.reliability = Reliability::kReliable;
  }
  qos.history_depth = topic.lockstep_depth;
  qos.deadline = kInfinite;
  qos.liveliness = Liveliness::kAutomatic;
  qos.lease = kInfinite;
  return qos;
}

std::string contract_text() {
  std::string text;
  for (const TopicSpec& topic : kTopics) {
    text += std::string(topic.name) + ' ' + topic.type_name + ' ' + std::to_string(topic.version) + '\n';
  }
#define FARRIER_SIGNAL_TEXT(Signal, file) text += struct_text<signals::Signal>(#Signal);
  FARRIER_SIGNALS(FARRIER_SIGNAL_TEXT)
#undef FARRIER_SIGNAL_TEXT
  return text;
}

std::uint64_t contract_hash() {
  static const std::uint64_t hash = stable_hash(contract_text());
  return hash;
}

std::string partition(const std::string& robot) { return robot; }

std::string partition(const std::string& robot, const std::string& leg) { return robot + '/' + leg; }

}  // namespace farrier::bus
