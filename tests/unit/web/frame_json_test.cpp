#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>

#include "core/fault.hpp"
#include "tests/unit/monitor/feed.hpp"
#include "tools/web/frame_json.hpp"

namespace farrier::web {
namespace frame_json_test {

using monitor::testing::Feed;
using monitor::testing::hyq;
using nlohmann::json;

TEST(FrameJson, HasEveryJointWithTheSummariesSinceTheFrameBefore) {
  Feed feed;
  monitor::testing::walk_for_a_second(feed);
  feed.frame();
  feed.walk(1020, 3);
  const json frame = json::parse(frame_json(feed.frame()));
  ASSERT_EQ(frame.at("joints").size(), hyq().joints.size());
  for (const json& joint : frame.at("joints")) {
    EXPECT_EQ(joint.at("s").size(), 3u);
    EXPECT_EQ(joint.at("state"), 2);
    EXPECT_EQ(joint.at("estimate").at("poles").size(), 3u);
    EXPECT_NEAR(joint.at("nrmse").get<double>(), 0.05, 1e-6);
  }
  EXPECT_EQ(frame.at("mode"), "armed");
  EXPECT_EQ(frame.at("processes").at(1).at("name"), "supervisor");
}

TEST(FrameJson, SaysNullOfWhatIsNotKnown) {
  Feed feed;
  const json frame = json::parse(frame_json(feed.frame()));
  EXPECT_TRUE(frame.at("tick").is_null());
  EXPECT_TRUE(frame.at("mode").is_null());
  EXPECT_TRUE(frame.at("age").is_null());
  EXPECT_TRUE(frame.at("joints").at(0).at("state").is_null());
  EXPECT_TRUE(frame.at("joints").at(0).at("estimate").is_null());
  EXPECT_TRUE(frame.at("joints").at(0).at("gains").at(0).is_null());
}

TEST(FrameJson, SaysNullOfWhatIsNoFiniteNumber) {
  Feed feed;
  monitor::testing::walk_for_a_second(feed);
  monitor::Frame frame = feed.frame();
  frame.joints[0].estimate.validity = std::numeric_limits<double>::quiet_NaN();
  frame.joints[0].poles[0] = {std::numeric_limits<double>::infinity(), 1e-320};
  const json estimate = json::parse(frame_json(frame)).at("joints").at(0).at("estimate");
  EXPECT_TRUE(estimate.at("validity").is_null());
  EXPECT_TRUE(estimate.at("poles").at(0).at(0).is_null());
}

TEST(FrameJson, RoundsToSixDigits) {
  Feed feed;
  monitor::testing::walk_for_a_second(feed);
  monitor::Frame frame = feed.frame();
  for (const double value : {1.0 / 3.0, -1234567.8, 6.02214076e23, 1.6e-19, 0.1}) {
    frame.joints[0].estimate.validity = value;
    const json said = json::parse(frame_json(frame)).at("joints").at(0).at("estimate").at("validity");
    EXPECT_NEAR(said.get<double>(), value, 5e-6 * std::abs(value));
    EXPECT_LE(said.dump().size(), 13u) << said.dump();
  }
}

TEST(FrameJson, PlacesTheRobotInSpace) {
  Feed feed;
  signals::BodyTruth truth;
  truth.tick = 1000;
  truth.position_m = {1.23456, 0.0, 0.58};
  truth.foot_force_N[5] = 412.34;
  feed.take(truth);
  EXPECT_TRUE(json::parse(frame_json(feed.frame())).at("body").at("legs").at(0).is_null());
  monitor::testing::walk_for_a_second(feed);
  const json body = json::parse(frame_json(feed.frame())).at("body");
  ASSERT_EQ(body.at("legs").size(), 4u);
  EXPECT_EQ(body.at("legs").at(3).size(), 3u);
  EXPECT_TRUE(body.at("state").is_null());
  EXPECT_TRUE(body.at("truth").is_null()) << "nothing was heard for a second";
  feed.take(truth);
  const json said = json::parse(frame_json(feed.frame())).at("body").at("truth");
  EXPECT_EQ(said.at("position").dump(), "[1.2346,0.0,0.58]");
  EXPECT_EQ(said.at("forces").size(), 12u);
  EXPECT_EQ(said.at("forces").at(5), 412.3);
}

TEST(RobotJson, HasTheShapesOfARobotWithABody) {
  const json body = json::parse(robot_json(hyq(), false)).at("body");
  EXPECT_EQ(body.at("legs").size(), 4u);
  EXPECT_EQ(body.at("trunk").at("size").at(0), 2 * 0.3735);
  EXPECT_EQ(body.at("trunk").at("size").at(1), 2 * 0.207);
  // The hips are at one height: 6 (I_x + I_y - I_z) / m of HyQ's trunk, by hand.
  EXPECT_NEAR(body.at("trunk").at("size").at(2).get<double>(), std::sqrt(6.0 * (1.5726 + 8.5016 - 9.1955) / 58.96),
              1e-3);
  EXPECT_NEAR(body.at("weight").get<double>(), 84.756 * 9.81, 1.0);
  robot::Robot bench = hyq();
  bench.body.reset();
  EXPECT_TRUE(json::parse(robot_json(bench, false)).at("body").is_null());
}

TEST(FrameJson, TellsPressureFlowsChambersAndEnergiesOfTheSupply) {
  Feed feed;
  EXPECT_TRUE(json::parse(frame_json(feed.frame())).at("supply").is_null());
  signals::SupplyState state;
  state.tick = 10;
  state.pressure_Pa = 151.27e5;
  state.pump_flow_m3_s = 2e-4;
  state.flow_m3_s = -1e-5;
  feed.take(state);
  signals::SupplyTruth truth;
  truth.tick = 10;
  truth.pressure_a_Pa[2] = 80.04e5;
  truth.pressure_b_Pa[11] = 60e5;
  truth.pump_J = 100.0;
  truth.work_J = 0.5;
  feed.take(truth);
  const json supply = json::parse(frame_json(feed.frame())).at("supply");
  EXPECT_EQ(supply.at("s").dump(), "[[10,151.3,12.0,-0.6]]");
  EXPECT_EQ(supply.at("pressure"), 151.3);
  ASSERT_EQ(supply.at("chambers").size(), 1u);
  EXPECT_EQ(supply.at("chambers").at(0).at(1).size(), 12u);
  EXPECT_EQ(supply.at("chambers").at(0).at(1).at(2), 80);
  EXPECT_EQ(supply.at("chambers").at(0).at(2).at(11), 60);
  const json facts = json::parse(robot_json(hyq(), false)).at("supply");
  ASSERT_EQ(supply.at("energy").size(), facts.at("terms").size());
  EXPECT_EQ(supply.at("energy").at(0), 100.0);
  EXPECT_EQ(supply.at("energy").back(), 0.5);
  EXPECT_EQ(facts.at("terms").at(0), "pump");
  EXPECT_TRUE(json::parse(frame_json(feed.frame())).at("supply").at("s").empty());
}

TEST(FrameJson, AcceptsTextsThatAreNoUtf8) {
  monitor::EventFrame event;
  event.text = "caf\xe9 \xff</script>\n";
  EXPECT_NO_THROW(json::parse(event_json(event)));
}

TEST(RobotJson, NamesJointsLegsAndFaultsInTheOrderOfTheirNumbers) {
  const json robot = json::parse(robot_json(hyq(), false));
  ASSERT_EQ(robot.at("joints").size(), hyq().joints.size());
  EXPECT_EQ(robot.at("joints").at(4).at("name"), hyq().joints[4].name);
  EXPECT_EQ(robot.at("legs").size(), hyq().plan.legs.size());
  for (std::size_t bit = 0; bit < kFaults.size(); ++bit) {
    EXPECT_EQ(robot.at("faults").at(bit), to_string(static_cast<Fault>(1u << bit)));
    EXPECT_EQ(robot.at("failures").at(bit), kFaults[bit].severity >= FaultSeverity::kError) << kFaults[bit].name;
  }
  EXPECT_EQ(robot.at("silent_s"), monitor::kSilent_s);
  EXPECT_FALSE(robot.at("recorded").get<bool>());
}

}  // namespace frame_json_test
}  // namespace farrier::web
