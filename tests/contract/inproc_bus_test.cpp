// Tests of the in-process bus alone: a simulated clock decides, and it costs next to nothing.

#include <gtest/gtest.h>

#include "bus/inproc/inproc_bus.hpp"
#include "bus/key.hpp"
#include "tests/support/allocation_guard.hpp"
#include "tests/support/slowness.hpp"

namespace farrier::bus {
namespace inproc_bus_test {

using namespace std::chrono_literals;
using signals::JointSensors;
using signals::SystemMode;

constexpr Qos kSupervision{
    Reliability::kReliable, Durability::kVolatile, 4, kInfinite, Liveliness::kManualByTopic, 20ms,
    Ownership::kExclusive};

class InprocBus : public testing::Test {
 protected:
  Publisher<SystemMode> supervisor(int strength, const Qos& qos = kSupervision) {
    return Publisher<SystemMode>::create(*bus_, {TopicId::kSystemMode, qos, {}, strength}).value();
  }
  Subscription<SystemMode> robot(const Qos& qos = kSupervision) {
    return Subscription<SystemMode>::create(*bus_, {TopicId::kSystemMode, qos, {}}).value();
  }
  static std::vector<std::uint32_t> epochs(Subscription<SystemMode>& reader) {
    std::vector<std::uint32_t> taken;
    reader.drain([&](const SystemMode& mode) { taken.push_back(mode.epoch); });
    return taken;
  }

  SteadyTime now_{};
  std::shared_ptr<InprocDomain> domain_ = std::make_shared<InprocDomain>([this] { return now_; });
  std::unique_ptr<Bus> bus_ = create_inproc_bus(domain_);
};

SystemMode mode(std::uint32_t epoch) { return {.epoch = epoch}; }

using Epochs = std::vector<std::uint32_t>;

TEST_F(InprocBus, StrongerWriterOwnsTheKeyWhileItsLeaseLasts) {
  auto weak = supervisor(5);
  auto strong = supervisor(10);
  auto reader = robot();
  weak.publish(mode(1));
  strong.publish(mode(2));
  now_ += 20ms;
  weak.publish(mode(3));
  EXPECT_EQ(epochs(reader), (Epochs{1, 2}));
  now_ += 1ns;
  weak.publish(mode(4));
  EXPECT_EQ(epochs(reader), (Epochs{4}));
  EXPECT_EQ(reader.status().liveliness_lost, 1u);
}

TEST_F(InprocBus, StrongerWriterRegainsTheKeyWhenItReturns) {
  auto weak = supervisor(5);
  auto strong = supervisor(10);
  auto reader = robot();
  strong.publish(mode(1));
  now_ += 21ms;
  weak.publish(mode(2));
  strong.publish(mode(3));
  weak.publish(mode(4));
  EXPECT_EQ(epochs(reader), (Epochs{1, 2, 3}));
}

TEST_F(InprocBus, WeakerWriterOwnsTheKeyOnceTheStrongerIsDestroyed) {
  auto weak = supervisor(5);
  auto reader = robot();
  {
    auto strong = supervisor(10);
    strong.publish(mode(1));
    weak.publish(mode(2));
  }
  weak.publish(mode(3));
  EXPECT_EQ(epochs(reader), (Epochs{1, 3}));
  EXPECT_EQ(reader.status().liveliness_lost, 0u);
}

TEST_F(InprocBus, MissedDeadlineReleasesTheKey) {
  Qos qos = kSupervision;
  qos.lease = kInfinite;
  qos.deadline = 10ms;
  auto weak = supervisor(5, qos);
  auto strong = supervisor(10, qos);
  auto reader = robot(qos);
  strong.publish(mode(1));
  now_ += 11ms;
  weak.publish(mode(2));
  EXPECT_EQ(epochs(reader), (Epochs{1, 2}));
}

TEST_F(InprocBus, CountsEachMissedPeriodOnceUntilTheWriterLeaves) {
  Qos qos = kSupervision;
  qos.deadline = 10ms;
  auto reader = robot(qos);
  {
    auto writer = supervisor(0, qos);
    writer.publish(mode(1));
    now_ += 35ms;
    EXPECT_EQ(reader.status().deadline_missed, 3u);
    EXPECT_EQ(reader.status().deadline_missed, 3u);
  }
  now_ += 1s;
  EXPECT_EQ(reader.status().deadline_missed, 3u);
}

TEST_F(InprocBus, LateReaderGetsAnExclusiveKeyFromItsOwnerAlone) {
  Qos qos = kSupervision;
  qos.durability = Durability::kTransientLocal;
  auto weak = supervisor(5, qos);
  auto strong = supervisor(10, qos);
  weak.publish(mode(1));
  strong.publish(mode(2));
  auto reader = robot(qos);
  EXPECT_EQ(epochs(reader), (Epochs{2}));
}

TEST_F(InprocBus, RequestBeyondTheOfferIsRefusedPolicyByPolicy) {
  const Qos offered{Reliability::kReliable, Durability::kVolatile, 1, 10ms, Liveliness::kAutomatic, 50ms};
  auto writer = supervisor(0, offered);
  const auto refused = [&](auto change) {
    Qos requested = offered;
    change(requested);
    auto reader = robot(requested);
    return reader.status().incompatible_qos == 1 && reader.status().matched_writers == 0;
  };
  EXPECT_FALSE(refused([](Qos&) {}));
  EXPECT_FALSE(refused([](Qos& qos) { qos.reliability = Reliability::kBestEffort; }));
  EXPECT_TRUE(refused([](Qos& qos) { qos.durability = Durability::kTransientLocal; }));
  EXPECT_TRUE(refused([](Qos& qos) { qos.deadline = 9ms; }));
  EXPECT_TRUE(refused([](Qos& qos) { qos.lease = 49ms; }));
  EXPECT_TRUE(refused([](Qos& qos) { qos.liveliness = Liveliness::kManualByTopic; }));
  EXPECT_TRUE(refused([](Qos& qos) { qos.ownership = Ownership::kExclusive; }));
}

TEST_F(InprocBus, ReplacedSamplesAreCountedAsOverwrittenNotAsLost) {
  auto writer = supervisor(0);
  auto reader = robot();
  for (std::uint32_t epoch = 1; epoch <= 10; ++epoch) {
    writer.publish(mode(epoch));
  }
  EXPECT_EQ(epochs(reader), (Epochs{7, 8, 9, 10}));
  EXPECT_EQ(domain_->overwritten(), 6u);
  EXPECT_EQ(reader.status().lost, 0u);
}

TEST_F(InprocBus, SamplesOfDifferentKeysAreTakenInTheOrderTheyWereWritten) {
  auto writer = Publisher<JointSensors>::create(*bus_, {TopicId::kJointSensors, {}, {}}).value();
  auto reader = Subscription<JointSensors>::create(*bus_, {TopicId::kJointSensors, {}, {}}).value();
  for (const int joint : {3, 1, 2, 3}) {
    writer.publish({.joint = static_cast<std::uint16_t>(joint)});
  }
  std::vector<int> joints;
  reader.drain([&](const JointSensors& sample) { joints.push_back(sample.joint); });
  EXPECT_EQ(joints, (std::vector<int>{1, 2, 3}));
}

TEST_F(InprocBus, KeyOfTheGainsHoldsJointAndPhase) {
  EXPECT_NE(key_of(signals::JointControllerGains{.joint = 1, .phase = signals::Phase::kSwing}),
            key_of(signals::JointControllerGains{.joint = 1, .phase = signals::Phase::kStance}));
  EXPECT_EQ(key_of(JointSensors{.joint = 7, .tick = 3}), 7u);
}

TEST_F(InprocBus, WriteAndTakeNeitherAllocateNorCostAMicrosecond) {
  constexpr int kJoints = 12;
  constexpr int kTicks = 20000;
  constexpr double kBudget_ns = 1000 * test::kSlowness;
  auto writer = Publisher<JointSensors>::create(*bus_, {TopicId::kJointSensors, {}, {}}).value();
  auto reader = Subscription<JointSensors>::create(*bus_, {TopicId::kJointSensors, {}, {}}).value();
  std::uint64_t taken = 0;
  const auto run = [&](int ticks) {
    for (int tick = 0; tick < ticks; ++tick) {
      for (std::uint16_t joint = 0; joint < kJoints; ++joint) {
        writer.publish({.joint = joint});
      }
      taken += reader.drain([](const JointSensors&) {});
    }
  };
  run(1);
  const test::AllocationGuard guard;
  const auto start = std::chrono::steady_clock::now();
  run(kTicks);
  const double spent_ns = static_cast<double>((std::chrono::steady_clock::now() - start).count());
  EXPECT_EQ(guard.allocations(), 0u);
  EXPECT_EQ(taken, static_cast<std::uint64_t>((kTicks + 1) * kJoints));
  const double per_sample_ns = spent_ns / (kTicks * kJoints);
  RecordProperty("per_sample_ns", static_cast<int>(per_sample_ns));
  std::cout << "write and take: " << per_sample_ns << " ns per sample\n";
  EXPECT_LT(per_sample_ns, kBudget_ns);
}

}  // namespace inproc_bus_test
}  // namespace farrier::bus
