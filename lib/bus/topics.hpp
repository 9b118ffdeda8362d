#pragma once

// The registry: every topic with its writers, route and QoS. Name, version, readers and fields come from its file in
// idl/. idl/README.md is generated from it.

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <type_traits>

#include "bus/qos.hpp"
#include "bus/roles.hpp"
#include "core/transport.hpp"
#include "signals/fields.hpp"

namespace farrier::bus {

/// One number per topic, in the order of FARRIER_SIGNALS.
enum class TopicId : std::uint8_t {
#define FARRIER_TOPIC_ID(Signal, file) k##Signal,
  FARRIER_SIGNALS(FARRIER_TOPIC_ID)
#undef FARRIER_TOPIC_ID
};

/// Receivers of a sample: every process of the robot, or only those that host joints of the sample's leg.
enum class Route : std::uint8_t { kRobot, kLeg };

/// When a sample goes out: as it is written, or with others of its writer when that is flushed.
enum class Sending : std::uint8_t { kAtOnce, kTogether };

using farrier::ClockKind;

/// A topic as idl/ states it, with its writers, route and QoS.
struct TopicSpec : signals::TopicText {
  TopicId id;
  RoleSet writers;  ///< processes that may write it; DDS Security's permissions come from here
  Route route;
  Sending sending;
  std::size_t signal_size;  ///< sizeof of our struct
  Qos realtime;             ///< QoS on the real-time clock
  int lockstep_depth;       ///< history in lock-step, where nothing ever expires
};

std::span<const TopicSpec> topics();
const TopicSpec& spec(TopicId id);

/// The QoS of a topic on a clock. In lock-step: reliable but for journals, which nobody's tick waits for, deadline and
/// lease infinite, and deep enough that a sample for tick k + 1 does not overwrite the one for tick k.
Qos qos_for(const TopicSpec& topic, ClockKind clock);

/// Name, type, version and fields of every topic, with types, array sizes and keys, as IDL has them.
std::string contract_text();
/// Hash of the contract's text. Processes that disagree on it do not start together.
std::uint64_t contract_hash();

/// Text of idl/README.md: the subset of IDL, and a table of the registry with its QoS on both clocks.
std::string topics_table_markdown();

/// DDS partition of a robot's topics that go to everybody, and of one leg's.
std::string partition(const std::string& robot);
std::string partition(const std::string& robot, const std::string& leg);

/// TopicId of a signal type.
template <class Signal>
struct TopicOf;
#define FARRIER_TOPIC_OF(Signal, file)                \
  template <>                                         \
  struct TopicOf<signals::Signal> {                   \
    static constexpr TopicId id = TopicId::k##Signal; \
  };
FARRIER_SIGNALS(FARRIER_TOPIC_OF)
#undef FARRIER_TOPIC_OF

#define FARRIER_COUNT(Signal, file) +1
inline constexpr std::size_t kTopicCount = 0 FARRIER_SIGNALS(FARRIER_COUNT);
#undef FARRIER_COUNT
static_assert(kTopicCount <= signals::kMaxTopics, "SystemHealth cannot count this many topics");

}  // namespace farrier::bus
