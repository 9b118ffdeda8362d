#include "tests/unit/participant/run.hpp"

namespace farrier::participant {
namespace greeting_test {

using namespace std::chrono_literals;
using namespace testing;
using signals::ClockTick;
using signals::SystemHello;

/// Participant 0 speaks for the clock; participant 1 listens to `keys` of it.
class Greeting : public ::testing::Test {
 protected:
  explicit Greeting(std::uint16_t participants = 2) : run(participants) {}

  void listen(std::vector<std::uint16_t> keys) {
    listener = run.join(1, "listener");
    ticks = opened(listener->subscribe<ClockTick>(std::move(keys)));
  }

  bool poll_clock() {
    run.pass(1ms);
    return clock->started(run.now());
  }
  bool poll_listener() {
    ticks->drain([&](const ClockTick& tick) { delivered.push_back(tick.tick); });
    return listener->started(run.now());
  }
  /// True when both have started within a simulated second.
  bool greet() {
    bool clock_started = false, listener_started = false;
    for (int i = 0; i < 1000 && !(clock_started && listener_started); ++i) {
      clock_started = poll_clock();
      listener_started = poll_listener();
    }
    return clock_started && listener_started;
  }

  /// Says hello as somebody who is not there.
  void say(const SystemHello& hello) {
    if (!stranger) {
      stranger_bus = run.bus();
      stranger = std::make_unique<bus::Publisher<SystemHello>>(
          bus::Publisher<SystemHello>::create(*stranger_bus,
                                              endpoint_of(run.identity(1, ""), bus::TopicId::kSystemHello))
              .value());
    }
    stranger->publish(hello);
  }
  SystemHello hello_of_listener() const {
    SystemHello hello;
    hello.participant = 1;
    hello.session = kSession;
    hello.contract = bus::contract_hash();
    signals::assign(hello.name, "listener");
    return hello;
  }

  TestRun run;
  Member clock = run.join(kSimBridge, "clock");
  Out<ClockTick>* clock_out = opened(clock->publish<ClockTick>({0}));
  Member listener;
  In<ClockTick>* ticks = nullptr;
  std::vector<Tick> delivered;
  std::unique_ptr<bus::Bus> stranger_bus;
  std::unique_ptr<bus::Publisher<SystemHello>> stranger;
};

class GreetingOfThree : public Greeting {
 protected:
  GreetingOfThree() : Greeting(3) {}
};

TEST_F(Greeting, StartsOnceEveryRouteWasHeard) {
  listen({0});
  EXPECT_TRUE(greet());
  EXPECT_EQ(clock->greeting_lacks(), "");
  EXPECT_EQ(listener->greeting_lacks(), "");
}

TEST_F(Greeting, DoesNotStartBeforeTheOthersSayTheyHear) {
  listen({0});
  EXPECT_FALSE(poll_clock());
  EXPECT_FALSE(poll_clock()) << "the listener has not spoken yet";
}

TEST_F(Greeting, StartsWhenSomebodyJoinsLate) {
  for (int i = 0; i < 500; ++i) {
    ASSERT_FALSE(poll_clock());
  }
  EXPECT_EQ(clock->greeting_lacks(), "a hello of participant 1");
  listen({0});
  EXPECT_TRUE(greet());
}

TEST_F(Greeting, DoesNotStartWhileARouteIsSilentAndNamesIt) {
  listen({0, 7});  // nobody speaks for clock 7
  EXPECT_FALSE(greet());
  EXPECT_EQ(listener->greeting_lacks(), "listener hears 1 of 2 routes, not yet clock/tick of 7");
  EXPECT_EQ(clock->greeting_lacks(), "listener hears 1 of 2 routes");
}

TEST_F(GreetingOfThree, NamesTheParticipantThatIsNotThere) {
  listen({0});
  EXPECT_FALSE(greet());
  EXPECT_EQ(clock->greeting_lacks(), "a hello of participant 2");
}

TEST_F(Greeting, IgnoresTheHelloOfAnotherSession) {
  SystemHello hello = hello_of_listener();
  hello.session = kSession + 1;
  for (int i = 0; i < 100; ++i) {
    say(hello);
    EXPECT_FALSE(poll_clock());
  }
  EXPECT_EQ(clock->greeting_lacks(), "a hello of participant 1");
  EXPECT_EQ(clock->refusal(), "");
}

TEST_F(Greeting, IgnoresAHelloBeyondTheRunsParticipants) {
  SystemHello hello = hello_of_listener();
  hello.participant = 900;
  say(hello);
  EXPECT_FALSE(poll_clock());
  EXPECT_EQ(clock->hellos().size(), 2u);
}

TEST_F(Greeting, RefusesAParticipantThatSpeaksAnotherContract) {
  SystemHello hello = hello_of_listener();
  hello.contract ^= 1;
  say(hello);
  for (int i = 0; i < 100; ++i) {
    EXPECT_FALSE(poll_clock());
  }
  EXPECT_EQ(clock->refusal(), "listener speaks another version of the topics: rebuild both");
  EXPECT_EQ(clock->greeting_lacks(), clock->refusal()) << "what a process that waits prints";
}

TEST_F(Greeting, StartsWithAHelloThatIsComplete) {
  say(hello_of_listener());
  EXPECT_TRUE(poll_clock() || poll_clock());
}

TEST_F(Greeting, NeverDeliversAProbe) {
  listen({0});
  ASSERT_TRUE(greet());
  poll_listener();
  EXPECT_TRUE(delivered.empty());
  EXPECT_GT(ticks->status().received, 0u) << "probes did come";
  clock_out->publish({0, 0});
  poll_listener();
  EXPECT_EQ(delivered, std::vector<Tick>{0}) << "tick 0 is data";
}

TEST_F(Greeting, StopsProbingOnceStarted) {
  listen({0});
  ASSERT_TRUE(greet());
  poll_listener();
  const std::uint64_t before = ticks->status().received;
  for (int i = 0; i < 100; ++i) {
    EXPECT_TRUE(poll_clock());
    EXPECT_TRUE(poll_listener());
  }
  EXPECT_EQ(ticks->status().received, before);
}

TEST_F(Greeting, TellsWhoIsThere) {
  listen({0});
  ASSERT_TRUE(greet());
  const SystemHello& hello = clock->hellos().at(1);
  EXPECT_EQ(signals::text_of(hello.name), "listener");
  EXPECT_EQ(hello.vendor, static_cast<std::uint8_t>(bus::Vendor::kInproc));
  EXPECT_EQ(hello.routes_expected, 1);
  EXPECT_EQ(hello.routes_heard, 1);
  EXPECT_GT(hello.pid, 0u);
}

TEST_F(Greeting, DoesNotReachAnotherRobot) {
  Identity elsewhere = run.identity(1, "listener");
  elsewhere.robot = "fc1d";
  listener = run.join(elsewhere);
  ticks = opened(listener->subscribe<ClockTick>({0}));
  EXPECT_FALSE(greet());
  EXPECT_EQ(ticks->status().received, 0u);
}

TEST_F(Greeting, CountsOnlyDataInTheHealthReports) {
  listen({0});
  ASSERT_TRUE(greet());
  auto health = bus::Subscription<signals::SystemHealth>::create(
                    *listener.bus, endpoint_of(run.identity(1, ""), bus::TopicId::kSystemHealth))
                    .value();
  for (Tick tick = 0; tick < 3; ++tick) {
    clock_out->publish({0, tick});
    poll_listener();
  }
  clock->report_health(3, true);
  listener->report_health(3, false);
  std::vector<signals::SystemHealth> reports;
  health.drain([&](const signals::SystemHealth& report) { reports.push_back(report); });
  constexpr auto kClockTick = static_cast<std::size_t>(bus::TopicId::kClockTick);
  ASSERT_EQ(reports.size(), 2u);
  EXPECT_EQ(reports[0].participant, kSimBridge);
  EXPECT_EQ(reports[0].tick, 3);
  EXPECT_EQ(reports[0].final_report, 1);
  EXPECT_EQ(reports[0].sent[kClockTick], 3u);
  EXPECT_EQ(reports[1].participant, 1);
  EXPECT_EQ(reports[1].final_report, 0);
  EXPECT_EQ(reports[1].received[kClockTick], 3u);
  EXPECT_EQ(reports[1].lost[kClockTick], 0u);
}

TEST_F(Greeting, NumbersItsEvents) {
  listen({0});
  auto events = bus::Subscription<signals::SystemEvent>::create(
                    *listener.bus, endpoint_of(run.identity(1, ""), bus::TopicId::kSystemEvent))
                    .value();
  clock->event(EventKind::kGainsRefused, 12, 4, "not finite");
  clock->event(EventKind::kEstimatesBegin, 13, signals::kNoJoint);
  std::vector<signals::SystemEvent> heard;
  events.drain([&](const signals::SystemEvent& event) { heard.push_back(event); });
  ASSERT_EQ(heard.size(), 2u);
  EXPECT_EQ(heard[0].count, 1u);
  EXPECT_EQ(heard[0].tick, 12);
  EXPECT_EQ(heard[0].joint, 4);
  EXPECT_EQ(heard[0].severity, signals::Severity::kWarning);
  EXPECT_EQ(signals::text_of(heard[0].text), "gains refused: not finite");
  EXPECT_EQ(heard[1].count, 2u);
  EXPECT_EQ(signals::text_of(heard[1].text), "estimates from now on");
}

}  // namespace greeting_test
}  // namespace farrier::participant
