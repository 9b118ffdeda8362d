#include "monitor/watch.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "bus/inproc/inproc_bus.hpp"
#include "feed.hpp"
#include "participant/participant.hpp"
#include "recorder/watching_endpoint.hpp"

namespace farrier::monitor {
namespace watch_test {

using namespace testing;

class Watched : public ::testing::Test {
 protected:
  template <class Signal>
  bus::Publisher<Signal> writer(const bus::Qos& qos) {
    bus::EndpointSpec endpoint =
        participant::endpoint_of({.name = {}, .robot = hyq().name}, bus::TopicOf<Signal>::id, {hyq().plan.legs[0].name});
    endpoint.qos = qos;
    return bus::Publisher<Signal>::create(*robot_, endpoint).value();
  }
  template <class Signal>
  bus::Publisher<Signal> writer() {
    return writer<Signal>(bus::spec(bus::TopicOf<Signal>::id).realtime);
  }

  std::shared_ptr<bus::InprocDomain> domain_ = std::make_shared<bus::InprocDomain>([] { return SteadyTime{}; });
  std::unique_ptr<bus::Bus> robot_ = bus::create_inproc_bus(domain_);
  std::unique_ptr<bus::Bus> bus_ = bus::create_inproc_bus(domain_);
  Watch watch_ = Watch::create(*bus_, hyq()).value();
};

TEST_F(Watched, BlocksNoWriter) {
  for (const bus::TopicId topic : RobotView::topics()) {
    const bus::Qos asked = recorder::watching_endpoint(hyq(), topic).qos;
    const bool stream = bus::spec(topic).realtime.durability == bus::Durability::kVolatile;
    EXPECT_EQ(asked.reliability, stream ? bus::Reliability::kBestEffort : bus::Reliability::kReliable);
    EXPECT_EQ(asked.liveliness, bus::Liveliness::kAutomatic);
  }
  // No process takes these samples: writers go on, and the next look finds the newest.
  auto summaries = writer<signals::JointSummary>();
  for (Tick tick = 20; tick <= 20'000; tick += kTicksPerSummary) {
    EXPECT_TRUE(summaries.publish(summary(0, tick)));
  }
  EXPECT_EQ(watch_.look().joints[0].newest.tick, 20'000);
}

TEST_F(Watched, IsSeenInTheNextFrame) {
  auto summaries = writer<signals::JointSummary>();
  EXPECT_TRUE(std::isinf(watch_.look().age_s));
  summaries.publish(summary(2, 20));
  summaries.publish(summary(2, 40));
  const Frame frame = watch_.look();
  EXPECT_EQ(frame.tick, 40);
  EXPECT_EQ(frame.joints[2].summaries.size(), 2u);
  EXPECT_LT(frame.age_s, 10.0);
  EXPECT_EQ(frame.lost_samples, 0u);
  EXPECT_TRUE(frame.events.empty());
}

TEST_F(Watched, GivesALateJoinerTheAnnouncements) {
  auto hellos = writer<signals::SystemHello>();
  hellos.publish(hello(1, "supervisor"));
  Watch late = Watch::create(*bus_, hyq()).value();
  const Frame frame = late.look();
  ASSERT_EQ(frame.participants.size(), 2u);
  EXPECT_EQ(signals::text_of(frame.participants[1].hello.name), "supervisor");
}

TEST_F(Watched, NotesWhatGotLostOnTheWay) {
  auto events = writer<signals::SystemEvent>();
  signals::SystemEvent event;
  event.tick = 1;
  for (const std::uint32_t count : {1u, 2u, 5u}) {
    event.count = count;
    events.publish(event);
  }
  const Frame frame = watch_.look();
  EXPECT_EQ(frame.lost_samples, 2u);
  ASSERT_EQ(frame.events.size(), 4u);
  EXPECT_EQ(frame.events[3].who, "monitor");
  EXPECT_EQ(frame.events[3].text, "2 samples of system/event lost on the way to this monitor");
  EXPECT_TRUE(watch_.look().events.empty());
}

TEST_F(Watched, NotesAWriterItCannotHearForItsQos) {
  bus::Qos qos = bus::spec(bus::TopicId::kSystemMode).realtime;
  qos.reliability = bus::Reliability::kBestEffort;
  auto mode = writer<signals::SystemMode>(qos);
  const Frame frame = watch_.look();
  ASSERT_EQ(frame.events.size(), 1u);
  EXPECT_EQ(frame.events[0].text, "cannot hear a writer of system/mode for its QoS; which: farrier topics");
}

}  // namespace watch_test
}  // namespace farrier::monitor
