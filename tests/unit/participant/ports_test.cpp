#include "participant/options.hpp"
#include "tests/unit/participant/run.hpp"

namespace farrier::participant {
namespace ports_test {

using namespace testing;
using signals::JointSensors;

JointSensors sensors_of(std::uint16_t joint, Tick tick) { return {.joint = joint, .tick = tick}; }

TEST(EndpointOf, RoutesByRobotOrByJoint) {
  const Identity identity = TestRun(2).identity(0, "sim_bridge");
  EXPECT_EQ(endpoint_of(identity, bus::TopicId::kClockTick).partitions, std::vector<std::string>{"hyq"});
  EXPECT_EQ(endpoint_of(identity, bus::TopicId::kJointSensors, {"lf_haa", "lf_kfe"}).partitions,
            (std::vector<std::string>{"hyq/lf_haa", "hyq/lf_kfe"}));
}

TEST(EndpointOf, TakesTheQosOfTheClock) {
  Identity identity = TestRun(2).identity(0, "sim_bridge");
  for (const auto clock : {bus::ClockKind::kLockstep, bus::ClockKind::kRealtime}) {
    identity.clock = clock;
    for (const bus::TopicSpec& topic : bus::topics()) {
      EXPECT_EQ(endpoint_of(identity, topic.id).qos, bus::qos_for(topic, clock)) << topic.name;
    }
  }
}

TEST(Ports, GiveAProcessOnlyTheJointsItHosts) {
  const TestRun run(2);
  const Member sender = run.join(0, "sim_bridge");
  const Member receiver = run.join(1, "joint_node_lf_kfe");
  auto* out = opened(sender->publish<JointSensors>({3, 4}, {"lf_hfe", "lf_kfe"}));
  auto* in = opened(receiver->subscribe<JointSensors>({4}, {"lf_kfe"}));
  out->publish(sensors_of(3, 0));
  out->publish(sensors_of(4, 0));
  std::vector<std::uint16_t> heard;
  in->drain([&](const JointSensors& sensors) { heard.push_back(sensors.joint); });
  EXPECT_EQ(heard, std::vector<std::uint16_t>{4});
  EXPECT_EQ(in->status().received, 1u) << "the other joint's sample must not even travel";
}

TEST(Ports, ProbeEveryRouteTheySpeakFor) {
  const TestRun run(2);
  const Member sender = run.join(0, "sim_bridge");
  const Member receiver = run.join(1, "joint_node_lf");
  auto* out = opened(sender->publish<JointSensors>({3, 4}, {"lf_hfe", "lf_kfe"}));
  auto* in = opened(receiver->subscribe<JointSensors>({3, 4}, {"lf_hfe", "lf_kfe"}));
  EXPECT_EQ(in->routes_expected(), 2);
  EXPECT_EQ(in->first_unheard(), "joint/sensors of 3");
  out->publish(sensors_of(3, 0));
  in->drain([](const JointSensors&) {});
  EXPECT_EQ(in->routes_heard(), 1);
  EXPECT_EQ(in->first_unheard(), "joint/sensors of 4");
  out->probe();
  in->drain([](const JointSensors& sensors) { FAIL() << "a probe of joint " << sensors.joint << " was delivered"; });
  EXPECT_EQ(in->routes_heard(), 2);
  EXPECT_EQ(in->first_unheard(), "");
  EXPECT_EQ(out->sent(), 1u) << "probes do not count";
}

TEST(Ports, DoNotCountAKeyTheyNeedNotHear) {
  const TestRun run(2);
  const Member sender = run.join(0, "sim_bridge");
  const Member receiver = run.join(1, "other");
  auto* out = opened(sender->publish<JointSensors>({9}, {"lf_kfe"}));
  auto* in = opened(receiver->subscribe<JointSensors>({4}, {"lf_kfe"}));
  out->probe();
  in->drain([](const JointSensors&) {});
  EXPECT_EQ(in->routes_heard(), 0);
}

/// Ticks of a port's samples in the journals of `heard`, one list a journal.
std::vector<std::vector<Tick>> journals_of(bus::Subscription<signals::SystemJournal>& heard) {
  std::vector<std::vector<Tick>> journals;
  heard.drain([&](const signals::SystemJournal& journal) {
    EXPECT_EQ(journal.stream, signals::stream_of(0, static_cast<std::uint8_t>(bus::TopicId::kJointSensors)));
    EXPECT_EQ(journal.contract, bus::contract_hash());
    journals.emplace_back();
    EXPECT_TRUE(signals::visit_journal<JointSensors>(
        journal, [&](const JointSensors& sensors, auto, std::uint32_t) { journals.back().push_back(sensors.tick); }));
    EXPECT_EQ(journal.tick, journals.back().back());
  });
  return journals;
}

bus::Subscription<signals::SystemJournal> recorder_of(bus::Bus& bus, const Identity& identity) {
  return bus::Subscription<signals::SystemJournal>::create(bus, endpoint_of(identity, bus::TopicId::kSystemJournal))
      .value();
}

TEST(Ports, GatherWhatTheyPublishForRecorders) {
  constexpr Tick kTicks = 200;
  const TestRun run(2);
  const Member sender = run.join(0, "sim_bridge");
  const auto bus = run.bus();
  auto recorder = recorder_of(*bus, run.identity(1, "recorder"));
  auto* out = opened(sender->publish<JointSensors>({3}, {"lf_hfe"}));
  out->start();
  for (Tick tick = 0; tick < kTicks; ++tick) {
    out->publish(sensors_of(3, tick));
    out->flush();
  }
  std::vector<std::vector<Tick>> journals = journals_of(recorder);
  ASSERT_EQ(journals.size(), 1u) << "one of 192 ticks and more";
  EXPECT_EQ(journals[0].size(), 193u);
  EXPECT_EQ(journals[0].front(), 0);
  out->finish();
  out->publish(sensors_of(3, kTicks));
  out->flush();
  std::vector<std::pair<std::uint64_t, int>> last;
  recorder.drain(
      [&](const signals::SystemJournal& journal) { last.emplace_back(journal.samples_before, journal.samples); });
  EXPECT_EQ(last, (std::vector<std::pair<std::uint64_t, int>>{{193, 7}, {200, 1}}));
}

TEST(Ports, KeepNoJournalWithoutARecorderAndBeginWhenOneComes) {
  const TestRun run(2);
  const Member sender = run.join(0, "sim_bridge");
  auto* out = opened(sender->publish<JointSensors>({3}, {"lf_hfe"}));
  out->start();
  Tick tick = 0;
  for (; tick < 100; ++tick) {
    out->publish(sensors_of(3, tick));
    out->flush();
  }
  const auto bus = run.bus();
  auto recorder = recorder_of(*bus, run.identity(1, "recorder"));
  for (; tick < 400; ++tick) {
    out->publish(sensors_of(3, tick));
    out->flush();
  }
  const std::vector<std::vector<Tick>> journals = journals_of(recorder);
  ASSERT_FALSE(journals.empty());
  EXPECT_GE(journals[0].front(), 100);
  EXPECT_LT(journals[0].front(), 116) << "looks every sixteen samples";
}

TEST(TickInbox, GivesTheSampleOfExactlyTheTickAsked) {
  TickInbox<JointSensors> inbox({7, 8});
  inbox.put(sensors_of(8, 5));
  EXPECT_EQ(inbox.find(1, 4), nullptr);
  ASSERT_NE(inbox.find(1, 5), nullptr);
  EXPECT_EQ(inbox.find(1, 5)->joint, 8);
  EXPECT_EQ(inbox.find(0, 5), nullptr);
}

TEST(TickInbox, KeepsTheNextTicksUntilTheyAreDue) {
  TickInbox<JointSensors> inbox({7});
  for (Tick tick = 10; tick < 14; ++tick) {
    inbox.put(sensors_of(7, tick));
  }
  for (Tick tick = 10; tick < 14; ++tick) {
    EXPECT_NE(inbox.find(0, tick), nullptr) << "tick " << tick;
  }
  inbox.put(sensors_of(7, 14));
  EXPECT_EQ(inbox.find(0, 10), nullptr) << "its place is taken";
}

TEST(TickInbox, SaysWhoIsMissing) {
  TickInbox<JointSensors> inbox({7, 8, 9});
  EXPECT_EQ(inbox.missing(0), 3);
  inbox.put(sensors_of(7, 0));
  inbox.put(sensors_of(9, 0));
  EXPECT_EQ(inbox.missing(0), 1);
  EXPECT_EQ(inbox.first_missing(0), 8);
  EXPECT_EQ(inbox.missing(1), 3);
}

TEST(TickInbox, IgnoresAKeyThatIsNotItsOwn) {
  TickInbox<JointSensors> inbox({7});
  inbox.put(sensors_of(99, 0));
  EXPECT_EQ(inbox.missing(0), 1);
}

ProcessOptions parsed(std::vector<std::string> arguments, const char* process = "process") {
  arguments.insert(arguments.begin(), process);
  std::vector<char*> argv;
  for (std::string& argument : arguments) {
    argv.push_back(argument.data());
  }
  return parse_options(process, "", static_cast<int>(argv.size()), argv.data());
}

TEST(ProcessOptions, SurviveTheCommandLine) {
  ProcessOptions options;
  options.name = "joint_node_lf";
  options.robot_path = "robots/a b.yaml";
  options.vendor = bus::Vendor::kFast;
  options.clock = bus::ClockKind::kRealtime;
  options.network.domain = 42;
  options.network.address = "127.0.0.1";
  options.network.peers = {"10.0.0.1", "10.0.0.2"};
  options.number = kFirstJointNode;
  options.participants = 8;
  options.session = 0xffff'ffff'ffff'fff0ull;
  options.seed = 9;
  options.ticks = 4000;
  options.joints = {"lf_haa", "lf_hfe"};
  options.gait = "stand";
  options.frequency_Hz = 4.0 / 3.0;
  options.no_dither = true;
  options.estimator = "greybox";
  options.controller = "flow_inversion";
  const ProcessOptions back = parsed(to_arguments(options));
  EXPECT_EQ(back.name, options.name);
  EXPECT_EQ(back.robot_path, options.robot_path);
  EXPECT_EQ(back.vendor, options.vendor);
  EXPECT_EQ(back.clock, options.clock);
  EXPECT_EQ(back.network.domain, options.network.domain);
  EXPECT_EQ(back.network.address, options.network.address);
  EXPECT_EQ(back.network.peers, options.network.peers);
  EXPECT_EQ(back.number, options.number);
  EXPECT_EQ(back.participants, options.participants);
  EXPECT_EQ(back.session, options.session);
  EXPECT_EQ(back.seed, options.seed);
  EXPECT_EQ(back.ticks, options.ticks);
  EXPECT_EQ(back.joints, options.joints);
  EXPECT_EQ(back.gait, options.gait);
  EXPECT_EQ(back.frequency_Hz, options.frequency_Hz) << "to the last bit: it shapes the trace";
  EXPECT_TRUE(back.no_dither);
  EXPECT_EQ(back.estimator, options.estimator);
  EXPECT_EQ(back.controller, options.controller);
}

TEST(ProcessOptions, LeaveDitherOnUnlessTold) {
  EXPECT_FALSE(parsed({"--number", "0", "--participants", "3"}).no_dither);
}

TEST(ProcessOptions, GoToTheProcessThatTheyConcern) {
  ProcessOptions options;
  options.participants = 8;
  options.joints = {"lf_haa"};
  options.trace_path = "trace.csv";
  options.simulated_path = "out/log/world.yaml";
  options.design = "swing";
  options.number = kSimBridge;
  const ProcessOptions sim_bridge = parsed(to_arguments(options), "sim_bridge");
  EXPECT_EQ(sim_bridge.simulated_path, options.simulated_path);
  EXPECT_EQ(sim_bridge.trace_path, options.trace_path);
  options.number = kSupervisor;
  EXPECT_EQ(parsed(to_arguments(options), "supervisor").design, options.design);
  options.number = kFirstJointNode;
  const ProcessOptions joint_node = parsed(to_arguments(options), "joint_node");
  EXPECT_EQ(joint_node.joints, options.joints);
  EXPECT_EQ(joint_node.simulated_path, "");
  EXPECT_EQ(joint_node.trace_path, "");
}

TEST(ProcessOptions, RefuseTheOptionOfAnotherProcess) {
  GTEST_FLAG_SET(death_test_style, "threadsafe");
  EXPECT_EXIT(parsed({"--number", "2", "--participants", "3", "--joints", "lf_haa"}, "supervisor"),
              ::testing::ExitedWithCode(2), "--joints");
}

TEST(ProcessOptions, RefuseANumberBeyondTheParticipants) {
  GTEST_FLAG_SET(death_test_style, "threadsafe");
  EXPECT_EXIT(parsed({"--number", "3", "--participants", "3"}), ::testing::ExitedWithCode(2), "must be below");
}

}  // namespace ports_test
}  // namespace farrier::participant
