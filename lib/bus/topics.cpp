#include "bus/topics.hpp"

#include "core/ensure.hpp"
#include "core/noise.hpp"

namespace farrier::bus {
namespace {

using namespace std::chrono_literals;

// Freshness is what counts. A reader that waits for a stream judges the age of its samples. A DDS deadline or lease
// would report the same later, and would wake a timer thread of the vendor with every sample (docs/decisions/0047).
constexpr Qos kLatest{Reliability::kBestEffort, Durability::kVolatile, 1, kInfinite, Liveliness::kAutomatic, kInfinite,
                      Ownership::kShared};
// Authority over the robot. A standby supervisor takes over after silence, and its samples carry a higher authority
// number (docs/decisions/0040).
constexpr Qos kAuthority{
    Reliability::kReliable, Durability::kTransientLocal, 1, kInfinite, Liveliness::kManualByTopic, 20ms,
    Ownership::kExclusive};
constexpr Qos announcements(int depth) {
  return {Reliability::kReliable, Durability::kTransientLocal, depth, kInfinite, Liveliness::kAutomatic, kInfinite,
          Ownership::kShared};
}
constexpr Qos kRequests{Reliability::kReliable, Durability::kVolatile, 4, kInfinite, Liveliness::kAutomatic, kInfinite,
                        Ownership::kShared};
constexpr Qos kLockstepOnly{
    Reliability::kReliable, Durability::kVolatile, 1, kInfinite, Liveliness::kAutomatic, kInfinite, Ownership::kShared};

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

#define FARRIER_TOPIC(Signal, writers, route, sending, qos, depth)                                                   \
  TopicSpec {                                                                                                        \
    signals::kTopicText<signals::Signal>, TopicId::k##Signal, writers, route, sending, sizeof(signals::Signal), qos, \
        depth                                                                                                        \
  }

// All but the clock itself.
constexpr RoleSet kTickers = kParticipantRoles.without(Role::kSimBridge);

constexpr RoleSet kRequesters{Role::kOperator, Role::kLauncher};

// clang-format off
constexpr std::array<TopicSpec, kTopicCount> kTopics{
    FARRIER_TOPIC(JointSensors, {Role::kSimBridge}, Route::kLeg, Sending::kTogether, kLatest, kTwoTicks),
    FARRIER_TOPIC(JointCommand, {Role::kLocomotion}, Route::kLeg, Sending::kTogether, kLatest, kTwoTicks),
    FARRIER_TOPIC(JointValveCommand, {Role::kJointNode}, Route::kRobot, Sending::kTogether, kLatest, kTwoTicks),
    FARRIER_TOPIC(JointMeasurement, {Role::kJointNode}, Route::kRobot, Sending::kTogether, kLatest, kTwoTicks),
    FARRIER_TOPIC(JointModelEstimate, {Role::kEstimatorService}, Route::kRobot, Sending::kAtOnce, kLatest, kTwoTicks),
    FARRIER_TOPIC(JointControllerGains, {Role::kSupervisor}, Route::kLeg, Sending::kAtOnce, kAuthority, kTwoTicks),
    FARRIER_TOPIC(JointUpdateDecision, {Role::kSupervisor}, Route::kRobot, Sending::kAtOnce, announcements(kDecisions), kDecisions),
    FARRIER_TOPIC(GaitPhase, {Role::kLocomotion}, Route::kRobot, Sending::kAtOnce, announcements(4), 4),
    FARRIER_TOPIC(SystemHello, kParticipantRoles, Route::kRobot, Sending::kAtOnce, announcements(1), 1),
    FARRIER_TOPIC(SystemHealth, kParticipantRoles, Route::kRobot, Sending::kAtOnce, announcements(1), 1),
    FARRIER_TOPIC(SystemEvent, kParticipantRoles, Route::kRobot, Sending::kAtOnce, announcements(kEvents), kEventsLockstep),
    FARRIER_TOPIC(SystemMode, {Role::kSupervisor}, Route::kRobot, Sending::kAtOnce, kAuthority, kTwoTicks),
    FARRIER_TOPIC(SystemRequest, kRequesters, Route::kRobot, Sending::kAtOnce, kRequests, kTwoTicks),
    FARRIER_TOPIC(ClockTick, {Role::kSimBridge}, Route::kRobot, Sending::kAtOnce, kLatest, kTwoTicks),
    FARRIER_TOPIC(ClockTickDone, kTickers, Route::kRobot, Sending::kAtOnce, kLockstepOnly, kTwoTicks),
    FARRIER_TOPIC(JointSummary, {Role::kJointNode}, Route::kRobot, Sending::kTogether, kLatest, kTwoTicks),
    FARRIER_TOPIC(JointModelEstimateCopy, {Role::kEstimatorService}, Route::kRobot, Sending::kTogether, kLatest, kTwoTicks),
    FARRIER_TOPIC(SystemJournal, kParticipantRoles, Route::kRobot, Sending::kAtOnce, kLatest, kJournals),
    FARRIER_TOPIC(BodyImu, {Role::kSimBridge}, Route::kRobot, Sending::kAtOnce, kLatest, kTwoTicks),
    FARRIER_TOPIC(BodyTruth, {Role::kSimBridge}, Route::kRobot, Sending::kAtOnce, kLatest, kTwoTicks),
    FARRIER_TOPIC(BodyState, {Role::kLocomotion}, Route::kRobot, Sending::kAtOnce, kLatest, kTwoTicks),
    FARRIER_TOPIC(BodyCommand, kRequesters, Route::kRobot, Sending::kAtOnce, kRequests, kTwoTicks),
    FARRIER_TOPIC(SupplyState, {Role::kSimBridge}, Route::kRobot, Sending::kAtOnce, kLatest, kTwoTicks),
    FARRIER_TOPIC(SupplyTruth, {Role::kSimBridge}, Route::kRobot, Sending::kAtOnce, kLatest, kTwoTicks),
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
    text += std::string(topic.name) + ", version " + std::to_string(topic.version) + ", wire::" + topic.declaration;
  }
  return text;
}

std::uint64_t contract_hash() {
  static const std::uint64_t hash = stable_hash(contract_text());
  return hash;
}

std::string partition(const std::string& robot) { return robot; }

std::string partition(const std::string& robot, const std::string& leg) { return robot + '/' + leg; }

}  // namespace farrier::bus
