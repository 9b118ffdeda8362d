// Faults on the way of samples: what is asked for happens to the samples concerned, and to no other.

#include <gtest/gtest.h>

#include <cmath>
#include <optional>

#include "bus/inproc/inproc_bus.hpp"
#include "bus_faults/faulty_bus.hpp"

namespace farrier::bus_faults {
namespace bus_faults_test {

using namespace std::chrono_literals;
using signals::JointSensors;
using signals::SystemMode;

ArrowFault fault(const std::string& text) {
  auto parsed = parse_arrow_fault(text);
  EXPECT_TRUE(parsed.ok()) << (parsed ? "" : parsed.error().message);
  return parsed ? parsed.value() : ArrowFault{};
}

/// A writer's process and one that hears it through faults.
class Faulty {
 public:
  explicit Faulty(const std::vector<std::string>& faults, std::uint64_t seed = 1) {
    std::vector<ArrowFault> parsed;
    for (const std::string& text : faults) {
      parsed.push_back(fault(text));
    }
    there_ = bus::create_inproc_bus(domain_);
    here_ = with_faults(bus::create_inproc_bus(domain_), parsed, seed, "joint_node_lf",
                        {[] { return std::chrono::steady_clock::now(); }});
    const bus::Qos qos{.history_depth = 4096};
    writer_.emplace(bus::Publisher<JointSensors>::create(*there_, {bus::TopicId::kJointSensors, qos, {}}).value());
    reader_.emplace(bus::Subscription<JointSensors>::create(*here_, {bus::TopicId::kJointSensors, qos, {}}).value());
    orders_out_.emplace(bus::Publisher<SystemMode>::create(*there_, {bus::TopicId::kSystemMode, qos, {}}).value());
    orders_in_.emplace(bus::Subscription<SystemMode>::create(*here_, {bus::TopicId::kSystemMode, qos, {}}).value());
  }

  void send(Tick tick, std::uint16_t joint = 0, double force = 1.0) {
    JointSensors sensors;
    sensors.joint = joint;
    sensors.tick = tick;
    sensors.position_m_or_rad = static_cast<double>(tick);
    sensors.force_N_or_Nm = force;
    writer_->publish(sensors);
  }
  void send_all(Tick ticks) {
    for (Tick tick = 0; tick < ticks; ++tick) {
      send(tick);
    }
  }
  std::vector<JointSensors> heard() {
    std::vector<JointSensors> all;
    reader_->drain([&](const JointSensors& sensors) { all.push_back(sensors); });
    return all;
  }
  std::vector<Tick> ticks() {
    std::vector<Tick> all;
    for (const JointSensors& sensors : heard()) {
      all.push_back(sensors.tick);
    }
    return all;
  }
  void order(Tick effective_tick) {
    SystemMode mode;
    mode.effective_tick = effective_tick;
    orders_out_->publish(mode);
  }
  std::size_t orders() {
    std::size_t heard = 0;
    orders_in_->drain([&](const SystemMode&) { ++heard; });
    return heard;
  }
  bus::Bus& bus() { return *here_; }

 private:
  std::shared_ptr<bus::InprocDomain> domain_ =
      std::make_shared<bus::InprocDomain>([] { return std::chrono::steady_clock::now(); });
  std::unique_ptr<bus::Bus> there_, here_;
  std::optional<bus::Publisher<JointSensors>> writer_;
  std::optional<bus::Subscription<JointSensors>> reader_;
  std::optional<bus::Publisher<SystemMode>> orders_out_;
  std::optional<bus::Subscription<SystemMode>> orders_in_;
};

using Ticks = std::vector<Tick>;

TEST(FaultyBus, LetsThroughWhatNoFaultConcerns) {
  Faulty faulty({"joint/sensors:cut@2..4", "joint/sensors:nan=force_N_or_Nm#7", "joint/command:cut"});
  faulty.send_all(6);
  const auto heard = faulty.heard();
  ASSERT_EQ(heard.size(), 4u);
  EXPECT_EQ(heard[2].tick, 4);
  EXPECT_EQ(heard[2].force_N_or_Nm, 1.0);
}

// A mode is repeated with the tick at which it took effect, long before.
TEST(FaultyBus, CutsRepeatedOrdersByTheTickThatOthersTell) {
  Faulty faulty({"system/mode:cut@2..4"});
  faulty.send_all(2);
  faulty.ticks();
  faulty.order(0);
  EXPECT_EQ(faulty.orders(), 1u);
  faulty.send(2);
  faulty.ticks();
  faulty.order(0);
  EXPECT_EQ(faulty.orders(), 0u);
  faulty.send(4);
  faulty.ticks();
  faulty.order(0);
  EXPECT_EQ(faulty.orders(), 1u);
}

TEST(FaultyBus, ReportsAFaultOnceWhenItFirstActs) {
  const std::string cut = "joint/sensors:cut@1..3", never = "joint/sensors:loss=0", later = "joint/sensors:cut@5..9#1";
  Faulty faulty({cut, never, later});
  using Texts = std::vector<std::string>;
  faulty.send(0);
  faulty.ticks();
  EXPECT_EQ(faulty.bus().take_faults_begun(), Texts{});
  faulty.send(1);
  faulty.send(2);
  faulty.ticks();
  EXPECT_EQ(faulty.bus().take_faults_begun(), Texts{cut});
  faulty.send(5, 0);
  faulty.ticks();
  EXPECT_EQ(faulty.bus().take_faults_begun(), Texts{}) << "it is about joint 1";
  faulty.send(6, 1);
  faulty.ticks();
  EXPECT_EQ(faulty.bus().take_faults_begun(), Texts{later});
}

TEST(FaultyBus, LetsProbesThrough) {
  Faulty faulty({"joint/sensors:cut"});
  faulty.send(kNoTick);
  faulty.send(0);
  EXPECT_EQ(faulty.ticks(), Ticks{kNoTick});
}

TEST(FaultyBus, LosesTheShareAskedForBySeed) {
  const auto survivors = [](std::uint64_t seed) {
    Faulty faulty({"joint/sensors:loss=0.2"}, seed);
    faulty.send_all(2000);
    return faulty.ticks();
  };
  const Ticks once = survivors(1);
  EXPECT_NEAR(static_cast<double>(once.size()), 1600.0, 60.0);
  EXPECT_EQ(survivors(1), once);
  EXPECT_NE(survivors(2), once);
}

TEST(FaultyBus, LosesRowsInABurst) {
  Faulty faulty({"joint/sensors:burst=0.01x20"});
  faulty.send_all(4000);
  const Ticks ticks = faulty.ticks();
  ASSERT_LT(ticks.size(), 4000u);
  for (std::size_t i = 1; i < ticks.size(); ++i) {
    const Tick lost = ticks[i] - ticks[i - 1] - 1;
    EXPECT_EQ(lost % 20, 0) << "before tick " << ticks[i];
  }
}

TEST(FaultyBus, BringsSamplesTwice) {
  Faulty faulty({"joint/sensors:duplicate=1@1..2"});
  faulty.send_all(3);
  EXPECT_EQ(faulty.ticks(), (Ticks{0, 1, 1, 2}));
}

TEST(FaultyBus, ExchangesNeighboursOfAKey) {
  Faulty faulty({"joint/sensors:reorder=1@1..2"});
  faulty.send(0);
  faulty.send(1);
  faulty.send(1, 5);
  faulty.send(2, 6);
  faulty.send(2);
  const auto heard = faulty.heard();
  ASSERT_EQ(heard.size(), 4u);  // joint 5 has no successor yet
  EXPECT_EQ(heard[1].joint, 6);
  EXPECT_EQ(heard[2].tick, 2);
  EXPECT_EQ(heard[3].tick, 1);
}

TEST(FaultyBus, HoldsADelayedSampleBackAndWakesTheSleeperForIt) {
  Faulty faulty({"joint/sensors:delay=20..30"});
  const SteadyTime sent = std::chrono::steady_clock::now();
  faulty.send(0);
  EXPECT_TRUE(faulty.ticks().empty());
  const std::uint64_t before = faulty.bus().arrivals();
  faulty.bus().wait_for_arrivals(before + 1, 5s);
  const auto waited = std::chrono::steady_clock::now() - sent;
  EXPECT_GE(waited, 20ms);
  EXPECT_LT(waited, 5s);
  EXPECT_EQ(faulty.ticks(), Ticks{0});
}

TEST(FaultyBus, CorruptsNumbers) {
  Faulty faulty({"joint/sensors:nan=force_N_or_Nm@1..2", "joint/sensors:offset=force_N_or_Nm-0.25@2..3",
                 "joint/sensors:noise=force_N_or_Nm+0.5@3..4", "joint/sensors:frozen@4..7"});
  faulty.send_all(8);
  const auto heard = faulty.heard();
  ASSERT_EQ(heard.size(), 8u);
  EXPECT_TRUE(std::isnan(heard[1].force_N_or_Nm));
  EXPECT_EQ(heard[1].position_m_or_rad, 1.0);
  EXPECT_EQ(heard[2].force_N_or_Nm, 0.75);
  EXPECT_NE(heard[3].force_N_or_Nm, 1.0);
  EXPECT_TRUE(std::isfinite(heard[3].force_N_or_Nm));
  EXPECT_EQ(heard[6].position_m_or_rad, 4.0);
  EXPECT_EQ(heard[6].tick, 6);
  EXPECT_EQ(heard[7].position_m_or_rad, 7.0);
}

class FaultText : public testing::TestWithParam<const char*> {};

TEST_P(FaultText, IsReadAndWrittenAlike) { EXPECT_EQ(to_string(fault(GetParam())), GetParam()); }

INSTANTIATE_TEST_SUITE_P(Of, FaultText,
                         testing::Values("joint/sensors:loss=0.05@2000..3000#4", "joint/command:cut",
                                         "gait/phase:burst=0.01x20", "joint/valve_command:delay=1..5@10..20",
                                         "joint/sensors:offset=force_N_or_Nm-250.5", "joint/sensors:frozen#0",
                                         "joint/sensors:nan=velocity_m_s_or_rad_s", "joint/command:reorder=0.5",
                                         "joint/measurement:duplicate=1", "joint/sensors:noise=force_N_or_Nm+3"));

struct Wrong {
  const char* text;
  const char* says;
};

class WrongFaultText : public testing::TestWithParam<Wrong> {};

TEST_P(WrongFaultText, IsRefusedWithThePartAndWhatMayStandThere) {
  const auto refused = parse_arrow_fault(GetParam().text);
  ASSERT_FALSE(refused.ok());
  EXPECT_NE(refused.error().message.find(GetParam().says), std::string::npos) << refused.error().message;
}

INSTANTIATE_TEST_SUITE_P(
    For, WrongFaultText,
    testing::Values(Wrong{"", "'' is no topic: joint/sensors"}, Wrong{"joint/sensor:cut", "'joint/sensor' is no topic"},
                    Wrong{"joint/sensors", "'' is no kind of fault: loss"},
                    Wrong{"joint/sensors:loss", "'' is no probability"},
                    Wrong{"joint/sensors:loss=1.5", "'1.5' is no probability"},
                    Wrong{"joint/sensors:loss=nan", "'nan' is no probability"},
                    Wrong{"joint/sensors:burst=0.1", "'0.1' is no burst"},
                    Wrong{"joint/sensors:burst=0.1x0", "'0.1x0' is no burst"},
                    Wrong{"joint/sensors:delay=5..1", "'5..1' is no delay"},
                    Wrong{"joint/sensors:delay=1e9", "'1e9' is no delay"},
                    Wrong{"joint/sensors:cut=1", "this kind has no value"},
                    Wrong{"joint/sensors:nan=tick", "'tick' is no number of this topic: it has position_m_or_rad"},
                    Wrong{"joint/sensors:offset=force_N_or_Nm", "lacks how much"},
                    Wrong{"joint/sensors:cut@5", "'5' is no span of ticks"},
                    Wrong{"joint/sensors:cut@5..5", "'5..5' is no span of ticks"},
                    Wrong{"joint/sensors:cut@1..2#x", "'x' is no key"}));

}  // namespace bus_faults_test
}  // namespace farrier::bus_faults
