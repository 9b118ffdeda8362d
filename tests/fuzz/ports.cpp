// The steps of every process with a sample before its core sees it: routes, ticks, ages, greetings.

#include <memory>
#include <vector>

#include "bus/inproc/inproc_bus.hpp"
#include "participant/arrival.hpp"
#include "participant/participant.hpp"
#include "tests/fuzz/input.hpp"

namespace farrier::fuzz {
namespace {

using namespace std::chrono_literals;

constexpr std::uint64_t kSession = 77;

class Run {
 public:
  Run() {
    member_ = joined(participant::Participant::join(*here_, identity(1)));
    sensors_ = joined(member_->subscribe<signals::JointSensors>({0, 1}, {"lf", "lf"}));
    gains_ = joined(member_->subscribe<signals::JointControllerGains>({0, 1}, {"lf", "lf"}));
    phases_ = joined(member_->subscribe<signals::GaitPhase>({0}));
    modes_ = joined(member_->subscribe<signals::SystemMode>({0}));
    estimates_ = joined(member_->subscribe<signals::JointModelEstimate>({0, 1}));
    sensors_out_ = publisher<signals::JointSensors>({"lf"});
    gains_out_ = publisher<signals::JointControllerGains>({"lf"});
    phases_out_ = publisher<signals::GaitPhase>();
    modes_out_ = publisher<signals::SystemMode>();
    estimates_out_ = publisher<signals::JointModelEstimate>();
    hellos_out_ = publisher<signals::SystemHello>();
  }

  /// One sample of a topic, then what a process does every time it wakes up.
  void step(Input& input) {
    now_ += std::chrono::milliseconds(input.below(200));
    switch (input.below(6)) {
      case 0: send(*sensors_out_, sensors_of(input)); break;
      case 1: send(*gains_out_, input.signal<signals::JointControllerGains>()); break;
      case 2: send(*phases_out_, input.signal<signals::GaitPhase>()); break;
      case 3: send(*modes_out_, input.signal<signals::SystemMode>()); break;
      case 4: send(*estimates_out_, input.signal<signals::JointModelEstimate>()); break;
      default: send(*hellos_out_, hello_of(input)); break;
    }
    drain();
    member_->started(now_);
    require(member_->greeting_lacks().size() < 400, "what a greeting lacks is a sentence");
    signals::SystemHealth health;
    member_->report_health(0, false, health);
  }

 private:
  template <class Value>
  static Value joined(Result<Value> result) {
    require(result.ok(), "a port opens in process");
    return std::move(result).value();
  }
  participant::Identity identity(std::uint16_t number) const {
    return {.name = "fuzz", .robot = "hyq", .number = number, .participants = 3, .session = kSession,
            .clock = bus::ClockKind::kRealtime};
  }
  template <class Signal>
  std::unique_ptr<bus::Publisher<Signal>> publisher(const std::vector<std::string>& legs = {}) {
    return std::make_unique<bus::Publisher<Signal>>(joined(bus::Publisher<Signal>::create(
        *there_, participant::endpoint_of(identity(0), bus::TopicOf<Signal>::id, legs))));
  }
  template <class Signal>
  static void send(bus::Publisher<Signal>& out, const Signal& signal) {
    out.publish(signal);
  }

  signals::JointSensors sensors_of(Input& input) {
    auto sensors = input.signal<signals::JointSensors>();
    sensors.joint = static_cast<std::uint16_t>(input.below(3));
    sensors.tick = input.tick(sensors_tick_);
    sensors_tick_ = sensors.tick;
    return sensors;
  }
  static signals::SystemHello hello_of(Input& input) {
    auto hello = input.signal<signals::SystemHello>();
    const std::uint8_t kind = input.byte();
    hello.participant = kind % 2 == 0 ? 0 : hello.participant;
    hello.session = kind % 8 < 6 ? kSession : hello.session;
    hello.contract = kind % 16 < 12 ? bus::contract_hash() : hello.contract;
    return hello;
  }

  void drain() {
    sensors_->drain([&](const signals::JointSensors& sensors) {
      if (const auto came = arrival_.take(sensors.tick, sensors.sample_time_ns, now_)) {
        require(*came <= now_, "no sample comes from the future");
      }
      inbox_.put(sensors);
      inbox_.find(0, sensors.tick);
      inbox_.missing(sensors.tick);
      inbox_.first_missing(sensors.tick);
    });
    gains_->drain([](const auto&) {});
    phases_->drain([](const auto&) {});
    modes_->drain([](const auto&) {});
    estimates_->drain([](const auto&) {});
  }

  SteadyTime now_{1s};
  std::shared_ptr<bus::InprocDomain> domain_ = std::make_shared<bus::InprocDomain>([this] { return now_; });
  std::unique_ptr<bus::Bus> here_ = bus::create_inproc_bus(domain_);
  std::unique_ptr<bus::Bus> there_ = bus::create_inproc_bus(domain_);
  std::unique_ptr<participant::Participant> member_;
  participant::In<signals::JointSensors>* sensors_;
  participant::In<signals::JointControllerGains>* gains_;
  participant::In<signals::GaitPhase>* phases_;
  participant::In<signals::SystemMode>* modes_;
  participant::In<signals::JointModelEstimate>* estimates_;
  std::unique_ptr<bus::Publisher<signals::JointSensors>> sensors_out_;
  std::unique_ptr<bus::Publisher<signals::JointControllerGains>> gains_out_;
  std::unique_ptr<bus::Publisher<signals::GaitPhase>> phases_out_;
  std::unique_ptr<bus::Publisher<signals::SystemMode>> modes_out_;
  std::unique_ptr<bus::Publisher<signals::JointModelEstimate>> estimates_out_;
  std::unique_ptr<bus::Publisher<signals::SystemHello>> hellos_out_;
  participant::Arrival arrival_;
  participant::TickInbox<signals::JointSensors> inbox_{{0, 1}};
  Tick sensors_tick_ = kNoTick;
};

}  // namespace

void ports(Bytes bytes) {
  Run run;
  for (Input input(bytes); !input.empty();) {
    run.step(input);
  }
}

}  // namespace farrier::fuzz
