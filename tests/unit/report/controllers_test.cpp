// Results of the comparison of controllers, from rows of known size.

#include <gtest/gtest.h>

#include <limits>
#include <vector>

#include "report/compare/controllers.hpp"

namespace farrier::report {
namespace controllers_test {

/// Three seeds of a joint; every contender has 0.04 in stance and 0.1 in swing, the grey box half of it.
std::vector<VaryRow> rows() {
  std::vector<VaryRow> rows;
  for (std::uint64_t seed = 1; seed <= 3; ++seed) {
    for (const Contender contender : kControllers) {
      const double share = contender == Contender::kGreyBox ? 0.5 : 1.0;
      rows.push_back({.seed = seed,
                      .contender = contender,
                      .joint = "knee",
                      .stance_nrmse = share * 0.04,
                      .swing_nrmse = share * 0.1});
    }
  }
  return rows;
}

VaryRow& grey_box_of(std::vector<VaryRow>& rows, std::uint64_t seed) {
  for (VaryRow& row : rows) {
    if (row.seed == seed && row.contender == Contender::kGreyBox) {
      return row;
    }
  }
  ADD_FAILURE();
  return rows.front();
}

Figures figures_of(const std::vector<VaryRow>& rows) {
  Figures figures;
  add_controllers(figures, kVariedTrot, rows);
  return figures;
}

double value(const Figures& figures, const std::string& name) {
  const Figure* figure = figures.find("trot.controllers." + name);
  EXPECT_NE(figure, nullptr) << name;
  return figure == nullptr ? std::numeric_limits<double>::quiet_NaN() : figure->value;
}

TEST(ControllerFigures, AreMediansWorstAndTheRatioToTheBest) {
  std::vector<VaryRow> some = rows();
  grey_box_of(some, 2).stance_nrmse = 0.2;
  const Figures figures = figures_of(some);
  EXPECT_EQ(value(figures, "greybox.varied_trot.stance_nrmse_median"), 0.02);
  EXPECT_EQ(value(figures, "greybox.varied_trot.stance_nrmse_worst"), 0.2);
  EXPECT_EQ(value(figures, "greybox.varied_trot.swing_nrmse_median"), 0.05);
  EXPECT_EQ(value(figures, "greybox.varied_trot.ratio_to_best"), 1.0);
  EXPECT_EQ(value(figures, "pid.varied_trot.ratio_to_best"), 2.0);
  EXPECT_EQ(value(figures, "greybox.varied_trot.seeds_failed"), 0.0);
  EXPECT_TRUE(figures.all_hold());
}

TEST(ControllerFigures, DoNotHoldWhereTheGreyBoxFailsOnceOrIsNotTheBest) {
  std::vector<VaryRow> failed = rows();
  grey_box_of(failed, 2).stance_nrmse = 0.31;
  EXPECT_EQ(value(figures_of(failed), "greybox.varied_trot.seeds_failed"), 1.0);
  EXPECT_FALSE(figures_of(failed).all_hold());
  std::vector<VaryRow> lost = rows();
  grey_box_of(lost, 3).left_tracking = true;
  EXPECT_EQ(value(figures_of(lost), "greybox.varied_trot.diverged"), 1.0);
  EXPECT_FALSE(figures_of(lost).all_hold());
  std::vector<VaryRow> worse = rows();
  for (std::uint64_t seed = 1; seed <= 3; ++seed) {
    grey_box_of(worse, seed).stance_nrmse = 0.043;
  }
  EXPECT_FALSE(figures_of(worse).all_hold());
}

TEST(ControllerFigures, CountNoNumberAsTheWorst) {
  std::vector<VaryRow> some = rows();
  grey_box_of(some, 1).stance_nrmse = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(value(figures_of(some), "greybox.varied_trot.stance_nrmse_worst"), std::numeric_limits<double>::infinity());
}

TEST(ControllerFigures, HaveALinePerController) {
  const std::string text = controllers_text(kLoadSteps, rows());
  for (const Contender contender : kControllers) {
    EXPECT_NE(text.find(to_string(contender)), std::string::npos);
  }
}

}  // namespace controllers_test
}  // namespace farrier::report
