// Cells of a robot that walks on a ground: which rows it has, which cells are drawn, and what its body must do.

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <set>

#include "tests/support/scratch_directory.hpp"
#include "tools/faults/cell_plan.hpp"
#include "tools/faults/cells_file.hpp"
#include "tools/faults/fault_page.hpp"

namespace farrier::faults {
namespace ground_test {

std::vector<CellPlan> all_on_ground() {
  return plan_cells(chosen_rows({}, Where::kSupply).value(), {"cyclone", "fast"}, 3);
}

std::vector<std::string> places(const std::vector<CellPlan>& plans) {
  std::vector<std::string> texts;
  for (const CellPlan& plan : plans) {
    texts.push_back(place_text(plan.cell()));
  }
  return texts;
}

TEST(ChosenRows, AreThoseOfTheRobot) {
  const auto has = [](Where robot, const char* name) {
    const auto rows = chosen_rows({}, robot).value();
    return std::ranges::find(rows, find_row(name)) != rows.end();
  };
  for (const Where robot : {Where::kBench, Where::kGround, Where::kSupply}) {
    EXPECT_TRUE(has(robot, "sensors_cut"));
  }
  EXPECT_TRUE(has(Where::kBench, "gains_cut"));
  EXPECT_FALSE(has(Where::kSupply, "gains_cut")) << "gains do not adapt on a ground";
  EXPECT_FALSE(has(Where::kBench, "imu_cut_short"));
  EXPECT_TRUE(has(Where::kGround, "imu_cut_short"));
  EXPECT_TRUE(has(Where::kSupply, "imu_cut_short"));
  EXPECT_FALSE(has(Where::kGround, "supply_cut")) << "ideal joints have no supply";
  EXPECT_TRUE(has(Where::kSupply, "supply_cut"));
}

TEST(ChosenRows, RefuseAnUnknownNameAndARowOfAnotherRobot) {
  EXPECT_EQ(chosen_rows({"sensors_cut"}, Where::kBench).value().size(), 1u);
  EXPECT_NE(chosen_rows({"sensors_gone"}, Where::kBench).error().message.find("no row is called 'sensors_gone'"),
            std::string::npos);
  EXPECT_EQ(chosen_rows({"imu_cut_long"}, Where::kBench).error().message,
            "--rows: imu_cut_long does not happen to joints on a bench: leave it out, or add --world body");
  EXPECT_EQ(chosen_rows({"gains_cut"}, Where::kSupply).error().message,
            "--rows: gains_cut does not happen to this robot on a ground: leave it out, or add --world bench");
}

TEST(DrawnCells, ShowEveryRowBeforeOneComesTwice) {
  const auto all = all_on_ground();
  const std::size_t rows = chosen_rows({}, Where::kSupply).value().size();
  const auto drawn = draw_cells(all, rows + 7, 1);
  std::map<const Row*, int> of_row;
  for (std::size_t i = 0; i < rows; ++i) {
    ++of_row[drawn[i].row];
  }
  EXPECT_EQ(of_row.size(), rows);
  const auto texts = places(drawn);
  EXPECT_EQ(std::set<std::string>(texts.begin(), texts.end()).size(), rows + 7) << "no cell comes twice";
}

TEST(DrawnCells, FollowFromTheSeedAndBeginAsThoseOfASmallerDraw) {
  const auto all = all_on_ground();
  auto more = places(draw_cells(all, 100, 5));
  const auto fewer = places(draw_cells(all, 60, 5));
  EXPECT_NE(places(draw_cells(all, 100, 6)), more);
  EXPECT_EQ(places(draw_cells(all, 10000, 5)).size(), all.size());
  more.resize(fewer.size());
  EXPECT_EQ(fewer, more);
}

TEST(DrawnCells, HaveBothPhasesAndAllVendors) {
  std::map<std::string, int> times;
  for (const CellPlan& plan : draw_cells(all_on_ground(), 100, 1)) {
    ++times[plan.vendor];
    ++times[plan.cell().phase];
  }
  for (const char* part : {"cyclone", "fast", "stance", "swing"}) {
    EXPECT_GT(times[part], 25) << part;
  }
}

constexpr Walk kWalk{.speed_m_s = 0.4, .stride_ticks = 500, .period_s = 0.001};

/// An upright trunk that moves forward at a speed.
class Body {
 public:
  explicit Body(double speed_m_s) {
    for (Tick tick = 0; tick < 2000; ++tick) {
      signals::BodyTruth row;
      row.tick = tick;
      row.position_m = {speed_m_s * 0.001 * static_cast<double>(tick), 0.0, 0.6};
      row.attitude = {1.0, 0.0, 0.0, 0.0};
      rows_.push_back(row);
    }
  }
  Body& lies_between(Tick begin, Tick end) {
    for (Tick tick = begin; tick < end; ++tick) {
      rows_[static_cast<std::size_t>(tick)].position_m[2] = 0.2;
    }
    return *this;
  }
  BodyAfterFault judged() const { return body_after_fault(rows_, 1000, kWalk); }

 private:
  std::vector<signals::BodyTruth> rows_;
};

TEST(BodyAfterFault, WalksOnAtHalfOfTheCommandOrMore) {
  EXPECT_TRUE(walks_on_check(Body(0.4).judged()).holds());
  EXPECT_TRUE(walks_on_check(Body(0.21).judged()).holds());
  EXPECT_NEAR(Body(0.19).judged().not_walking_s, 1.0, 1e-9);
  EXPECT_FALSE(Body(0.19).judged().fell);
}

TEST(BodyAfterFault, DoesNotWalkWhileItLies) {
  const BodyAfterFault body = Body(0.4).lies_between(1500, 1700).judged();
  EXPECT_TRUE(body.fell);
  EXPECT_NEAR(body.not_walking_s, 0.2, 1e-9);
  EXPECT_FALSE(Body(0.4).lies_between(500, 600).judged().fell) << "before the fault";
}

TEST(FaultRows, LetARobotWalkOnWhereAllJointsTrack) {
  EXPECT_TRUE(walks_on(*find_row("sensors_offset")));
  EXPECT_TRUE(walks_on(*find_row("supervisor_killed")));
  EXPECT_FALSE(walks_on(*find_row("loss_20"))) << "joints may stutter";
  EXPECT_FALSE(walks_on(*find_row("command_cut_short")));
  EXPECT_FALSE(walks_on(*find_row("sim_bridge_killed"))) << "nothing moves a robot that is not simulated";
}

Cell cell_with_body(bool fell) {
  Cell cell = CellPlan{find_row("sensors_cut"), gait::Phase::kSwing, "fast", 2}.cell();
  cell.checks.push_back({"reaction", "null after", 0.007, 0.004});
  cell.body = BodyAfterFault{fell, fell ? 0.5 : 0.0, 0.25, 900.0};
  return cell;
}

TEST(GroundPage, CountsFallsApartFromCellsThatHeld) {
  const std::string page = ground_page_markdown({cell_with_body(true), cell_with_body(false)}, {3, 2, 7}, "hyq");
  EXPECT_NE(page.find("with the seed 7. 2 of 3 cells held, 1 were not run."), std::string::npos) << page;
  EXPECT_NE(page.find("\nFalls of the robot: 1.\n"), std::string::npos) << page;
  EXPECT_NE(page.find("| `sensors_cut` | may fall | 2 | 2 | 1 | 0.25 | 900 | null after 4 ms of 7 ms |"),
            std::string::npos)
      << page;
  EXPECT_EQ(page.find("did not hold\n"), std::string::npos) << page;
}

TEST(CellsFile, GivesBackTheBodyOfACell) {
  const test::ScratchDirectory scratch;
  const std::string path = scratch.file("cells.jsonl");
  const CellsOrigin origin{"abc", "0123", 3, "body"};
  ASSERT_TRUE(append_cell(path, origin, cell_with_body(true)).ok());
  EXPECT_TRUE(read_cells(path, {"abc", "0123", 3, "bench"}).empty());
  const auto cells = read_cells(path, origin);
  ASSERT_EQ(cells.size(), 1u);
  ASSERT_TRUE(cells[0].body);
  EXPECT_TRUE(cells[0].fell());
  EXPECT_EQ(cells[0].body->not_walking_s, 0.5);
  EXPECT_EQ(cells[0].body->ground_force_N, 900.0);
}

}  // namespace ground_test
}  // namespace farrier::faults
