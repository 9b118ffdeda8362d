// Delivery: every signal arrives whole, in order, as deep as the history says.

#include <map>
#include <thread>
#include <tuple>

#include "conformance.hpp"
#include "random_signal.hpp"

namespace farrier::contract {
namespace conformance_delivery_test {

using signals::ClockTickDone;
using signals::JointSensors;
using signals::SystemEvent;

constexpr std::uint64_t kSeed = 20140901;

JointSensors sensors(int joint, int tick) {
  JointSensors sample;
  sample.joint = static_cast<std::uint16_t>(joint);
  sample.tick = tick;
  return sample;
}

std::map<int, std::vector<Tick>> ticks_by_joint(const std::vector<JointSensors>& samples) {
  std::map<int, std::vector<Tick>> ticks;
  for (const JointSensors& sample : samples) {
    ticks[sample.joint].push_back(sample.tick);
  }
  return ticks;
}

TEST_P(Conformance, EverySignalArrivesWithEveryFieldUnchanged) {
  constexpr int kSamples = 20;
  std::mt19937_64 random(kSeed);
#define FARRIER_ROUND_TRIP(Signal, file)                                                        \
  {                                                                                             \
    SCOPED_TRACE(#Signal);                                                                      \
    auto writer = publisher<signals::Signal>(reliable(kSamples));                               \
    auto reader = subscription<signals::Signal>(reliable(kSamples));                            \
    ASSERT_TRUE(matched(writer, reader));                                                       \
    for (int i = 0; i < kSamples; ++i) {                                                        \
      const auto sent = random_signal<signals::Signal>(random);                                 \
      ASSERT_TRUE(writer.publish(sent));                                                        \
      const auto received = receive(reader, 1);                                                 \
      ASSERT_EQ(received.size(), 1u) << "sample " << i << ", seed " << kSeed;                   \
      EXPECT_EQ(bytes_of(received[0]), bytes_of(sent)) << "sample " << i << ", seed " << kSeed; \
    }                                                                                           \
  }
  FARRIER_SIGNALS(FARRIER_ROUND_TRIP)
#undef FARRIER_ROUND_TRIP
}

TEST_P(Conformance, HistoryKeepsTheNewestSamplesOfEveryKey) {
  constexpr int kJoints = 3;
  constexpr int kTicks = 10;
  for (const int depth : {1, 4}) {
    SCOPED_TRACE("depth " + std::to_string(depth));
    use_another_robot();
    // The writer keeps all of them: a reliable reader may take its first samples from a repetition.
    auto writer = publisher<JointSensors>(reliable(kTicks));
    auto reader = subscription<JointSensors>(reliable(depth));
    ASSERT_TRUE(matched(writer, reader));
    const std::uint64_t before = reader_bus().arrivals();
    for (int tick = 0; tick < kTicks; ++tick) {
      for (int joint = 0; joint < kJoints; ++joint) {
        ASSERT_TRUE(writer.publish(sensors(joint, tick)));
      }
    }
    ASSERT_TRUE(wait_until(reader_bus(), kDeliveryBudget,
                           [&] { return reader_bus().arrivals() >= before + kJoints * kTicks; }));
    const auto ticks = ticks_by_joint(taken(reader));
    ASSERT_EQ(ticks.size(), static_cast<std::size_t>(kJoints));
    std::vector<Tick> newest;
    for (int tick = kTicks - depth; tick < kTicks; ++tick) {
      newest.push_back(tick);
    }
    for (const auto& [joint, kept] : ticks) {
      EXPECT_EQ(kept, newest) << "joint " << joint;
    }
  }
}

TEST_P(Conformance, SampleOfAnotherKeyDisplacesNothing) {
  constexpr int kJoints = 40;
  auto writer = publisher<JointSensors>(reliable(1));
  auto reader = subscription<JointSensors>(reliable(1));
  ASSERT_TRUE(matched(writer, reader));
  for (int joint = 0; joint < kJoints; ++joint) {
    ASSERT_TRUE(writer.publish(sensors(joint, 7)));
  }
  EXPECT_EQ(ticks_by_joint(receive(reader, kJoints)).size(), static_cast<std::size_t>(kJoints));
}

TEST_P(Conformance, BothKeyFieldsOfTheGainsTellSlotsApart) {
  auto writer = publisher<signals::JointControllerGains>(reliable(1));
  auto reader = subscription<signals::JointControllerGains>(reliable(1));
  ASSERT_TRUE(matched(writer, reader));
  for (const signals::Phase phase : {signals::Phase::kSwing, signals::Phase::kStance}) {
    signals::JointControllerGains gains;
    gains.joint = 3;
    gains.phase = phase;
    ASSERT_TRUE(writer.publish(gains));
  }
  EXPECT_EQ(receive(reader, 2).size(), 2u);
}

TEST_P(Conformance, SamplesOfAKeyArriveInTheOrderTheyWereWritten) {
  constexpr int kJoints = 3;
  constexpr int kTicks = 200;
  auto writer = publisher<JointSensors>(reliable(kTicks));
  auto reader = subscription<JointSensors>(reliable(kTicks));
  ASSERT_TRUE(matched(writer, reader));
  for (int tick = 0; tick < kTicks; ++tick) {
    for (int joint = 0; joint < kJoints; ++joint) {
      ASSERT_TRUE(writer.publish(sensors(joint, tick)));
    }
  }
  const auto ticks = ticks_by_joint(receive(reader, kJoints * kTicks));
  ASSERT_EQ(ticks.size(), static_cast<std::size_t>(kJoints));
  for (const auto& [joint, order] : ticks) {
    ASSERT_EQ(order.size(), static_cast<std::size_t>(kTicks)) << "joint " << joint;
    EXPECT_TRUE(std::is_sorted(order.begin(), order.end())) << "joint " << joint;
  }
}

TEST_P(Conformance, BurstOfReliableSamplesArrivesWhole) {
  constexpr std::uint32_t kBurst = 2000;
  auto writer = publisher<SystemEvent>(reliable(kBurst));
  auto reader = subscription<SystemEvent>(reliable(kBurst));
  ASSERT_TRUE(matched(writer, reader));
  std::thread burst([&] {
    SystemEvent event;
    for (event.count = 0; event.count < kBurst; ++event.count) {
      EXPECT_TRUE(writer.publish(event)) << "event " << event.count;
    }
  });
  const auto events = receive(reader, kBurst);
  burst.join();
  ASSERT_EQ(events.size(), kBurst);
  for (std::uint32_t i = 0; i < kBurst; ++i) {
    ASSERT_EQ(events[i].count, i);
  }
  EXPECT_EQ(reader.status().lost, 0u);
  EXPECT_EQ(reader.status().received, kBurst);
}

TEST_P(Conformance, WriterThatStillKeepsSamplesEnds) {
  constexpr std::uint32_t kKept = 2000;
  for (int i = 0; i < 10; ++i) {
    auto writer = publisher<SystemEvent>(reliable(kKept));
    auto reader = subscription<SystemEvent>(reliable(kKept));
    ASSERT_TRUE(matched(writer, reader));
    for (SystemEvent event; event.count < kKept; ++event.count) {
      ASSERT_TRUE(writer.publish(event));
    }
    EXPECT_EQ(receive(reader, kKept).size(), kKept);
    use_another_robot();
  }
}

// Fast DDS may count some samples more than once if the reader is polled while they come in.
TEST_P(Conformance, ArrivalsCountEverySampleOnceUntilItIsTaken) {
  constexpr std::uint64_t kSamples = 500;
  auto writer = publisher<ClockTickDone>(reliable(kSamples));
  auto reader = subscription<ClockTickDone>(reliable(kSamples));
  ASSERT_TRUE(matched(writer, reader));
  const std::uint64_t before = reader_bus().arrivals();
  for (std::uint64_t i = 0; i < kSamples; ++i) {
    ASSERT_TRUE(writer.publish({.tick = static_cast<Tick>(i)}));
  }
  ASSERT_TRUE(wait_until(reader_bus(), kDeliveryBudget, [&] { return reader_bus().arrivals() >= before + kSamples; }));
  EXPECT_EQ(reader_bus().arrivals(), before + kSamples);
  EXPECT_EQ(taken(reader).size(), kSamples);
}

TEST_P(Conformance, PolledReaderCountsNoArrivals) {
  constexpr Tick kSamples = 50;
  auto writer = publisher<ClockTickDone>(reliable(kSamples));
  auto reader = subscription<ClockTickDone>(reliable(kSamples), {}, false);
  ASSERT_TRUE(matched(writer, reader));
  const std::uint64_t before = reader_bus().arrivals();
  for (Tick tick = 0; tick < kSamples; ++tick) {
    ASSERT_TRUE(writer.publish({.tick = tick}));
  }
  EXPECT_EQ(receive(reader, kSamples).size(), static_cast<std::size_t>(kSamples));
  EXPECT_EQ(reader_bus().arrivals(), before);
}

TEST_P(Conformance, SampleCanBeTakenOnceItsArrivalIsCounted) {
  auto writer = publisher<ClockTickDone>(reliable(4));
  auto reader = subscription<ClockTickDone>(reliable(4));
  ASSERT_TRUE(matched(writer, reader));
  for (Tick tick = 0; tick < 200; ++tick) {
    const std::uint64_t before = reader_bus().arrivals();
    ASSERT_TRUE(writer.publish({.tick = tick}));
    reader_bus().wait_for_arrivals(before + 1, kDeliveryBudget);
    ASSERT_EQ(taken(reader).size(), 1u) << "tick " << tick;
  }
}

}  // namespace conformance_delivery_test
}  // namespace farrier::contract
