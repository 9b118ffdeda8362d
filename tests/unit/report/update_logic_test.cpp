#include "report/compare/update_logic.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <vector>

namespace farrier::report {
namespace update_logic_test {

UpdateLogicResult result(const std::string& method, double stance_nrmse) {
  UpdateLogicResult of{.method = method};
  of.quarter_nrmse = {0.02, 0.07, 0.03, 0.04};
  of.rig = {.looks = 450, .designs = 12, .accepted = 10, .look_us = 0.5};
  of.trot = {.looks = 10800, .designs = 100, .accepted = 90, .look_us = 0.7};
  for (const double factor : {1.0, 2.0, 3.0}) {
    JointTracking joint;
    joint.stance.nrmse = factor * stance_nrmse;
    joint.swing.nrmse = 0.5 * factor * stance_nrmse;
    of.tracking.joints.push_back(joint);
  }
  return of;
}

double value(const Figures& figures, const std::string& name) {
  const Figure* figure = figures.find("trot.update_logic." + name);
  EXPECT_NE(figure, nullptr) << name;
  return figure != nullptr ? figure->value : 0.0;
}

TEST(UpdateLogicFigures, AreOfEachMethod) {
  Figures figures;
  add_update_logic(figures, std::vector{result("limits", 0.1), result("distinct_poles", 0.02)});
  EXPECT_EQ(value(figures, "limits.stance_nrmse_median"), 0.2);
  EXPECT_EQ(value(figures, "limits.stance_nrmse_worst"), 0.1 * 3.0);
  EXPECT_EQ(value(figures, "limits.swing_nrmse_median"), 0.1);
  EXPECT_EQ(value(figures, "distinct_poles.stance_nrmse_median"), 0.04);
  EXPECT_EQ(value(figures, "distinct_poles.quarter2_nrmse"), 0.07);
  EXPECT_EQ(value(figures, "distinct_poles.rig_designs"), 12.0);
  EXPECT_EQ(value(figures, "distinct_poles.designs"), 100.0);
  EXPECT_TRUE(figures.all_hold());
}

TEST(UpdateLogicFigures, CountWhatDivergedAndForbidItToTheDefaultOnly) {
  UpdateLogicResult lost = result("small_error", 0.4);  // 0.4, 0.8, 1.2
  lost.quarter_nrmse[1] = std::numeric_limits<double>::quiet_NaN();
  lost.tracking.joints[0].tripped = true;
  Figures figures;
  add_update_logic(figures, std::vector{lost});
  EXPECT_EQ(value(figures, "small_error.diverged"), 2.0);
  EXPECT_EQ(value(figures, "small_error.rig_diverged"), 1.0);
  EXPECT_TRUE(figures.all_hold()) << "it is compared, not judged";
  lost.method = "distinct_poles";
  Figures judged;
  add_update_logic(judged, std::vector{lost});
  EXPECT_FALSE(judged.all_hold());
}

TEST(UpdateLogicTable, HasALinePerMethod) {
  const std::string table = update_logic_table(std::vector{result("limits", 0.1), result("white_error", 0.2)});
  EXPECT_EQ(std::ranges::count(table, '\n'), 4);
  EXPECT_NE(table.find("\nlimits "), std::string::npos);
  EXPECT_NE(table.find("\nwhite_error "), std::string::npos);
}

}  // namespace update_logic_test
}  // namespace farrier::report
