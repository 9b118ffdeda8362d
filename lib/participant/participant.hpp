#pragma once

// A process's part in a run: it opens its ports, greets the others until every route has carried a sample, then reports
// ticks done, health and events.

#include <algorithm>
#include <memory>
#include <string>
#include <vector>

#include "bus/bus.hpp"
#include "participant/event_registry.hpp"
#include "participant/ports.hpp"

namespace farrier::participant {

/// Numbers of participants in a run. Those of joint nodes follow one another from kFirstJointNode.
inline constexpr std::uint16_t kSimBridge = info(Program::kSimBridge).number;
inline constexpr std::uint16_t kEstimatorService = info(Program::kEstimatorService).number;
inline constexpr std::uint16_t kSupervisor = info(Program::kSupervisor).number;
inline constexpr std::uint16_t kLocomotion = info(Program::kLocomotion).number;
inline constexpr std::uint16_t kFirstJointNode = info(Program::kJointNode).number;

/// The rights a participant needs under DDS Security.
bus::Role role_of(std::uint16_t number, bool stands_by = false) noexcept;

struct Identity {
  std::string name;                ///< "sim_bridge", "joint_node lf", ...
  std::string robot;               ///< partition prefix
  std::uint16_t number = 0;        ///< this participant
  std::uint16_t participants = 1;  ///< of the run, numbered 0..participants-1
  std::uint64_t session = 0;
  bus::ClockKind clock = bus::ClockKind::kLockstep;
  int slow = 1;           ///< slow motion: factor of the times in DDS QoS
  int strength = 0;       ///< of its writers of topics that carry authority
  bool launches = false;  ///< it is the launcher, which starts the robot's processes and listens
};

/// Newest orders that a process has received from a supervisor.
struct Orders {
  std::uint32_t authority = 0;   ///< newest supervisor's; 0: of none yet
  std::uint32_t mode_epoch = 0;  ///< of the newest mode; 0: of none yet
};

/// Endpoint of a topic for a process of this identity: QoS by its clock, partitions by the topic's route. `legs` names
/// those of a topic routed by leg, with repetitions allowed.
bus::EndpointSpec endpoint_of(const Identity& identity, bus::TopicId topic, const std::vector<std::string>& legs = {});

/// One process's place in a run. Owned by the bus thread. On the real-time clock the sender thread also publishes on
/// ports, whose counters allow it.
class Participant {
 public:
  static Result<std::unique_ptr<Participant>> join(bus::Bus& bus, Identity identity);

  /// Opens a receiving port and expects each of `keys` to be heard on it before the run starts. The names in `legs`, by
  /// key, are for topics routed by leg, without samples of other keys; empty otherwise. If `at_leisure` is > 0, the
  /// port is polled: samples do not wake the loop, and at least this many per key are kept.
  template <class Signal>
  Result<In<Signal>*> subscribe(std::vector<std::uint16_t> keys, const std::vector<std::string>& legs = {},
                                int at_leisure = 0) {
    bus::EndpointSpec endpoint = endpoint_of(identity_, bus::TopicOf<Signal>::id, legs);
    endpoint.wakes = at_leisure == 0;
    endpoint.qos.history_depth = std::max(endpoint.qos.history_depth, at_leisure);
    auto made = FARRIER_TRY(bus::Subscription<Signal>::create(bus_, endpoint));
    auto port = std::make_unique<In<Signal>>(std::move(made), std::move(keys));
    In<Signal>* raw = port.get();
    ports_.push_back(std::move(port));
    return raw;
  }

  /// Opens a sending port that speaks for `keys`. `legs`: by key, names for topics routed by leg, each of which gets a
  /// writer; empty otherwise.
  template <class Signal>
  Result<Out<Signal>*> publish(std::vector<std::uint16_t> keys, const std::vector<std::string>& legs = {}) {
    const bus::TopicId topic = bus::TopicOf<Signal>::id;
    std::vector<bus::Publisher<Signal>> publishers;
    std::vector<std::size_t> publisher_of_key;
    std::vector<std::string> opened;  // legs, or one without a name
    for (std::size_t i = 0; i < keys.size(); ++i) {
      const std::vector<std::string> leg = legs.empty() ? legs : std::vector{legs[i]};
      const auto place = std::ranges::find(opened, legs.empty() ? std::string() : legs[i]);
      publisher_of_key.push_back(static_cast<std::size_t>(place - opened.begin()));
      if (place == opened.end()) {
        publishers.push_back(FARRIER_TRY(bus::Publisher<Signal>::create(bus_, endpoint_of(identity_, topic, leg))));
        opened.push_back(legs.empty() ? std::string() : legs[i]);
      }
    }
    auto port = std::make_unique<Out<Signal>>(std::move(publishers), std::move(keys), std::move(publisher_of_key));
    if constexpr (signals::kJournalled<Signal>) {
      auto journal = FARRIER_TRY(
          bus::Publisher<signals::SystemJournal>::create(bus_, endpoint_of(identity_, bus::TopicId::kSystemJournal)));
      port->keep_journal(std::make_unique<StreamJournal>(std::move(journal), identity_.number, topic, identity_.clock));
    }
    Out<Signal>* raw = port.get();
    ports_.push_back(std::move(port));
    return raw;
  }

  /// Greets while the run has not started. Call it after the ports were drained. True once every participant has
  /// said that it hears all it must.
  bool started(SteadyTime now);

  /// True if the last call of started() returned true.
  bool has_started() const noexcept { return started_; }

  /// Returns what the greeting still lacks, for people; empty when complete.
  std::string greeting_lacks() const;

  /// Reason why this process cannot take part or go on: another version of the topics, another process in its place, or
  /// what give_up() was told. Empty if there is none.
  const std::string& refusal() const noexcept { return refusal_; }

  /// Ends this process, with the reason on its standard error.
  void give_up(std::string reason) { refusal_ = std::move(reason); }

  /// True if orders of this authority count. Older authority than the newest received is refused, with an event.
  /// `mode_epoch`: of a mode, 0 otherwise. A newer authority or epoch is reported to every process in the hello.
  bool obey(Orders orders, Tick tick) noexcept;

  /// Returns the newest orders that any process of the run has reported, this one included.
  Orders newest_orders() const noexcept;

  /// Takes in hellos; started() does so too until the run has started.
  void hear_hellos();

  void tick_done(Tick tick, const signals::ClockTickDone& issued = {}) noexcept;
  void report_health(Tick tick, bool final_report, const signals::SystemHealth& measured = {}) noexcept;
  /// `detail`: what the angle brackets in the kind's text stand for. `joint`: signals::kNoJoint for none.
  void event(EventKind kind, Tick tick, std::uint16_t joint, std::string_view detail = {}) noexcept;

  const std::vector<signals::SystemHello>& hellos() const noexcept { return hellos_; }
  const Identity& identity() const noexcept { return identity_; }
  bus::Bus& bus() noexcept { return bus_; }

 private:
  Participant(bus::Bus& bus, Identity identity);
  Result<Done> open();
  void say_hello() noexcept;
  void tell_of_the_bus(Tick tick) noexcept;

  bus::Bus& bus_;
  Identity identity_;
  std::vector<std::unique_ptr<Port>> ports_;
  std::unique_ptr<bus::Publisher<signals::SystemHello>> hello_out_;
  std::unique_ptr<bus::Subscription<signals::SystemHello>> hello_in_;
  std::unique_ptr<bus::Publisher<signals::SystemHealth>> health_out_;
  std::unique_ptr<bus::Publisher<signals::SystemEvent>> event_out_;
  Out<signals::ClockTickDone>* tick_done_out_ = nullptr;
  std::vector<signals::SystemHello> hellos_;
  std::string refusal_;
  Orders obeyed_;
  std::uint32_t refused_authority_ = 0;  ///< newest of those refused
  std::uint32_t events_ = 0;
  SteadyTime next_greeting_{};
  bool started_ = false;
};

}  // namespace farrier::participant
