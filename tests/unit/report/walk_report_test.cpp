#include <gtest/gtest.h>

#include <algorithm>

#include "report/walk/moving_picture.hpp"
#include "report/walk/supply_section.hpp"
#include "tests/support/scratch_directory.hpp"

namespace farrier::report {
namespace walk_report_test {

constexpr Tick kSupplyTicks = 10;

const robot::Robot& hyq() {
  static const robot::Robot robot = robot::load_robot(FARRIER_ROBOTS "/hyq.yaml").value();
  return robot;
}

/// HyQ glides forward in its home pose, and half of its pump's work goes through the open valves.
struct Glide {
  explicit Glide(Tick ticks) {
    for (Tick tick = 0; tick < ticks; ++tick) {
      signals::BodyTruth body;
      body.tick = tick;
      body.position_m = {4e-4 * static_cast<double>(tick), 0.0, 0.6};
      body.attitude = {1.0, 0.0, 0.0, 0.0};
      body.foot_force_N[2] = 400.0;
      truth.push_back(body);
      for (const robot::Joint& joint : hyq().joints) {
        trace::TraceRow row;
        row.tick = tick;
        row.joint = joint.number;
        row.position_m_or_rad = joint.linkage.position(joint.home_angle_rad);
        row.pressure_a_Pa = 80e5;
        row.pressure_b_Pa = 60e5;
        row.actual_phase = joint.leg == 0 ? Phase::kStance : Phase::kSwing;
        joints.push_back(row);
      }
      if (tick % kSupplyTicks == 0) {
        trace::SupplyRow row;
        row.state.tick = row.truth.tick = tick;
        row.state.pressure_Pa = 150e5 + 1e3 * static_cast<double>(tick);
        row.state.pump_flow_m3_s = 2e-4;
        row.truth.pump_J = 2.0 * static_cast<double>(tick);
        row.truth.valve_J = static_cast<double>(tick);
        row.truth.relief_J = static_cast<double>(tick);
        supply.push_back(row);
      }
    }
  }

  WalkRun run() const { return {hyq(), plan, figures, truth, supply, {.phases = {}, .rows = joints}}; }

  WalkPlan plan{.period_s = 0.001,
                .forward_m_s = 0.4,
                .left_m_s = 0.0,
                .yaw_rate_rad_s = 0.0,
                .height_m = 0.6,
                .walk_s = 1.0,
                .normal = Eigen::Vector3d::UnitZ(),
                .plain = true};
  WalkFigures figures;
  std::vector<signals::BodyTruth> truth;
  std::vector<trace::TraceRow> joints;
  std::vector<trace::SupplyRow> supply;
};

std::size_t count(const std::string& text, const std::string& word) {
  std::size_t found = 0;
  for (std::size_t at = text.find(word); at != std::string::npos; at = text.find(word, at + word.size())) {
    ++found;
  }
  return found;
}

TEST(MovingPicture, MovesTrunkLegsAndForcesThroughTwentyFramesASecond) {
  const Glide glide(6001);
  const std::string svg = moving_picture(glide.run());
  EXPECT_TRUE(svg.starts_with("<svg xmlns"));
  EXPECT_TRUE(svg.ends_with("</svg>\n"));
  EXPECT_EQ(count(svg, "class=\"leg\""), 4u);
  EXPECT_EQ(count(svg, "fill=\"#009e73\""), 4u) << "arrows";
  EXPECT_EQ(count(svg, "<svg"), count(svg, "</svg>"));
  EXPECT_EQ(count(svg, "nan"), 0u);
  const std::size_t begin = svg.find("attributeName=\"cx\"");
  const std::string values = svg.substr(begin, svg.find("/>", begin) - begin);
  EXPECT_EQ(count(values, ";"), 100u) << "ends of a hundred intervals of 0.05 s";
  EXPECT_LT(svg.size(), 3u << 20);
}

TEST(MovingPicture, IsNotThereForARunThatIsShorterThanItsLoop) {
  const Glide glide(4000);
  EXPECT_EQ(moving_picture(glide.run()), "");
}

TEST(SupplySection, HasTheLeastPressureAndTheWorkOfThePump) {
  const test::ScratchDirectory scratch;
  const Glide glide(6001);
  Drawing drawing(scratch.file("report"));
  const std::string html = supply_section(drawing, glide.run());
  EXPECT_NE(html.find("<td>pressure, bar</td><td class=\"number\">150.0</td><td class=\"number\">180.0</td>"
                      "<td class=\"number\">210.0</td>"),
            std::string::npos)
      << html;
  EXPECT_NE(html.find("<td>open valves</td><td class=\"number\">6000.0</td><td class=\"number\">50.00</td>"
                      "<td class=\"number\">1000.0</td><td class=\"number\">50.00</td>"),
            std::string::npos)
      << html;
  EXPECT_NE(html.find("<td>residual</td><td class=\"number\">0.0</td>"), std::string::npos) << html;
  for (const gait::LegPlan& leg : hyq().plan.legs) {
    EXPECT_NE(html.find("pictures/leg_" + leg.name + ".svg"), std::string::npos) << leg.name;
  }
}

TEST(SupplySection, IsEmptyWithoutAPump) {
  const test::ScratchDirectory scratch;
  Glide glide(2000);
  glide.supply.clear();
  Drawing drawing(scratch.file("report"));
  EXPECT_EQ(supply_section(drawing, glide.run()), "");
}

}  // namespace walk_report_test
}  // namespace farrier::report
