#include "participant/participant.hpp"

#include <unistd.h>

#include <algorithm>

namespace farrier::participant {
namespace {

using namespace std::chrono_literals;
using signals::SystemHello;

constexpr auto kGreetingPeriod = 20ms;

}  // namespace

bus::Role role_of(std::uint16_t number, bool stands_by) noexcept {
  if (stands_by) {
    return bus::Role::kSupervisor;
  }
  return bus::role_of(number < kFirstJointNode ? kPrograms[number].program : Program::kJointNode);
}

bus::EndpointSpec endpoint_of(const Identity& identity, bus::TopicId topic, const std::vector<std::string>& legs) {
  bus::EndpointSpec endpoint{topic, bus::qos_for(bus::spec(topic), identity.clock), {}, identity.strength};
  for (Nanoseconds* time : {&endpoint.qos.deadline, &endpoint.qos.lease}) {
    *time = *time == bus::kInfinite ? *time : *time * identity.slow;
  }
  if (bus::spec(topic).route == bus::Route::kRobot) {
    endpoint.partitions = {bus::partition(identity.robot)};
  } else {
    for (const std::string& leg : legs) {
      const std::string partition = bus::partition(identity.robot, leg);
      if (std::ranges::find(endpoint.partitions, partition) == endpoint.partitions.end()) {
        endpoint.partitions.push_back(partition);
      }
    }
  }
  return endpoint;
}

Participant::Participant(bus::Bus& bus, Identity identity) : bus_(bus), identity_(std::move(identity)) {
  hellos_.resize(identity_.participants);
}

Result<std::unique_ptr<Participant>> Participant::join(bus::Bus& bus, Identity identity) {
  FARRIER_ENSURE(identity.number < identity.participants, "a participant's number is below their count");
  std::unique_ptr<Participant> participant(new Participant(bus, std::move(identity)));
  FARRIER_TRY(participant->open());
  return participant;
}

Result<Done> Participant::open() {
  const auto open_port = [&](auto& port, auto made) -> Result<Done> {
    if (!made) {
      return made.error();
    }
    port = std::make_unique<std::decay_t<decltype(made.value())>>(std::move(made).value());
    return Done{};
  };
  using bus::Publisher;
  using bus::Subscription;
  using bus::TopicId;
  if (auto r =
          open_port(hello_out_, Publisher<SystemHello>::create(bus_, endpoint_of(identity_, TopicId::kSystemHello)));
      !r) {
    return r;
  }
  if (auto r =
          open_port(hello_in_, Subscription<SystemHello>::create(bus_, endpoint_of(identity_, TopicId::kSystemHello)));
      !r) {
    return r;
  }
  if (auto r = open_port(
          health_out_, Publisher<signals::SystemHealth>::create(bus_, endpoint_of(identity_, TopicId::kSystemHealth)));
      !r) {
    return r;
  }
  if (auto r = open_port(event_out_,
                         Publisher<signals::SystemEvent>::create(bus_, endpoint_of(identity_, TopicId::kSystemEvent)));
      !r) {
    return r;
  }
  if (identity_.clock == bus::ClockKind::kLockstep && identity_.number != kSimBridge) {
    auto made = FARRIER_TRY(publish<signals::ClockTickDone>({identity_.number}));
    tick_done_out_ = made;
  }
  return Done{};
}

void Participant::say_hello() noexcept {
  SystemHello hello;
  hello.participant = identity_.number;
  hello.session = identity_.session;
  hello.contract = bus::contract_hash();
  hello.pid = static_cast<std::uint32_t>(::getpid());
  hello.vendor = static_cast<std::uint8_t>(bus_.vendor());
  for (const auto& port : ports_) {
    hello.routes_expected = static_cast<std::uint16_t>(hello.routes_expected + port->routes_expected());
    hello.routes_heard = static_cast<std::uint16_t>(hello.routes_heard + port->routes_heard());
  }
  hello.authority = obeyed_.authority;
  hello.mode_epoch = obeyed_.mode_epoch;
  signals::assign(hello.name, identity_.name);
  hellos_[identity_.number] = hello;
  hello_out_->publish(hello);
}

void Participant::hear_hellos() {
  hello_in_->drain([&](const SystemHello& hello) {
    if (hello.session != identity_.session || hello.participant >= hellos_.size()) {
      return;
    }
    if (hello.contract != bus::contract_hash()) {
      refusal_ = std::string(signals::text_of(hello.name)) + " speaks another version of the topics: rebuild both";
      return;
    }
    const auto own_pid = static_cast<std::uint32_t>(::getpid());
    if (hello.participant == identity_.number && hello.pid != own_pid && !started_) {
      refusal_ = "process " + std::to_string(hello.pid) + " (" + std::string(signals::text_of(hello.name)) +
                 ") is participant " + std::to_string(identity_.number) + " of this run already: end it first";
      event(EventKind::kNumberTaken, kNoTick, signals::kNoJoint, refusal_);
      return;
    }
    hellos_[hello.participant] = hello;
  });
}

bool Participant::started(SteadyTime now) {
  if (started_) {
    return true;
  }
  hear_hellos();
  if (now >= next_greeting_) {
    next_greeting_ = now + kGreetingPeriod;
    for (const auto& port : ports_) {
      port->probe();
    }
    say_hello();
    tell_of_the_bus(0);
  }
  started_ = greeting_lacks().empty();
  if (started_) {
    say_hello();
    for (const auto& port : ports_) {
      port->start();
    }
  }
  return started_;
}

std::string Participant::greeting_lacks() const {
  if (!refusal_.empty()) {
    return refusal_;
  }
  for (std::size_t i = 0; i < hellos_.size(); ++i) {
    const SystemHello& hello = hellos_[i];
    if (hello.session == 0) {
      return i == identity_.number ? "its own hello" : "a hello of participant " + std::to_string(i);
    }
    if (hello.routes_heard < hello.routes_expected) {
      std::string lack = std::string(signals::text_of(hello.name)) + " hears " + std::to_string(hello.routes_heard) +
                         " of " + std::to_string(hello.routes_expected) + " routes";
      for (const auto& port : ports_) {
        if (i == identity_.number && !port->first_unheard().empty()) {
          return lack + ", not yet " + port->first_unheard();
        }
      }
      return lack;
    }
  }
  return {};
}

bool Participant::obey(Orders orders, Tick tick) noexcept {
  if (orders.authority < obeyed_.authority) {
    if (orders.authority > refused_authority_) {
      refused_authority_ = orders.authority;
      event(EventKind::kReplacedSupervisorRefused, tick, signals::kNoJoint,
            std::to_string(orders.authority) + " after " + std::to_string(obeyed_.authority));
    }
    return false;
  }
  if (orders.authority > obeyed_.authority || orders.mode_epoch > obeyed_.mode_epoch) {
    obeyed_ = {orders.authority, std::max(orders.mode_epoch, obeyed_.mode_epoch)};
    say_hello();
  }
  return true;
}

Orders Participant::newest_orders() const noexcept {
  Orders newest = obeyed_;
  for (const SystemHello& hello : hellos_) {
    newest.authority = std::max(newest.authority, hello.authority);
    newest.mode_epoch = std::max(newest.mode_epoch, hello.mode_epoch);
  }
  return newest;
}

void Participant::tick_done(Tick tick, const signals::ClockTickDone& issued) noexcept {
  signals::ClockTickDone done = issued;
  done.participant = identity_.number;
  done.tick = tick;
  tick_done_out_->publish(done);
}

void Participant::report_health(Tick tick, bool final_report, const signals::SystemHealth& measured) noexcept {
  tell_of_the_bus(tick);
  signals::SystemHealth health = measured;
  health.participant = identity_.number;
  health.tick = tick;
  health.final_report = final_report ? 1 : 0;
  for (const auto& port : ports_) {
    port->count(health);
  }
  health.sent[static_cast<std::size_t>(bus::TopicId::kSystemHello)] = hello_out_->sent();
  health.sent[static_cast<std::size_t>(bus::TopicId::kSystemHealth)] = health_out_->sent() + 1;
  health.sent[static_cast<std::size_t>(bus::TopicId::kSystemEvent)] = event_out_->sent();
  health.received[static_cast<std::size_t>(bus::TopicId::kSystemHello)] = hello_in_->status().received;
  health_out_->publish(health);
  if (final_report && identity_.clock == bus::ClockKind::kLockstep) {
    for (const auto& port : ports_) {
      port->finish();
    }
  }
}

void Participant::tell_of_the_bus(Tick tick) noexcept {
  for (const std::string& sentence : bus_.take_security_warnings()) {
    event(EventKind::kSecurity, tick, signals::kNoJoint, sentence);
  }
  for (const std::string& fault : bus_.take_faults_begun()) {
    event(EventKind::kFaultOnPurpose, tick, signals::kNoJoint, fault);
  }
}

void Participant::event(EventKind kind, Tick tick, std::uint16_t joint, std::string_view detail) noexcept {
  signals::SystemEvent event;
  event.participant = identity_.number;
  event.count = ++events_;
  event.tick = tick;
  event.severity = spec(kind).severity;
  event.joint = joint;
  signals::assign(event.text, text_of(kind, detail));
  event_out_->publish(event);
}

}  // namespace farrier::participant
