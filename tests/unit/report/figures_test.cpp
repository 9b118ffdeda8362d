#include <cmath>
#include <limits>
#include <set>

#include <gtest/gtest.h>

#include "report/figures/figures.hpp"

namespace farrier::report {
namespace figures_test {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

bool holds(const char* name, double value, double bound) {
  Figures figures;
  figures.add(name, value, bound);
  return figures.all().front().holds() && figures.all_hold();
}

TEST(Figures, AtMostHoldsExactlyAtItsBoundAndNotAbove) {
  EXPECT_TRUE(holds("trot.lf_kfe.stance_nrmse", 0.1, 0.1));
  EXPECT_FALSE(holds("trot.lf_kfe.stance_nrmse", std::nextafter(0.1, 1.0), 0.1));
}

TEST(Figures, BelowDoesNotHoldAtItsBound) {
  EXPECT_FALSE(holds("trot.lf_kfe.stance_spectral_radius", 1.0, 1.0));
  EXPECT_TRUE(holds("trot.lf_kfe.stance_spectral_radius", std::nextafter(1.0, 0.0), 1.0));
}

TEST(Figures, AtLeastHoldsExactlyAtItsBoundAndNotBelow) {
  EXPECT_TRUE(holds("bench.plant.speedup", 20.0, 20.0));
  EXPECT_FALSE(holds("bench.plant.speedup", std::nextafter(20.0, 0.0), 20.0));
}

TEST(Figures, WhatIsNotFiniteNeverHoldsABound) {
  for (const double value : {kNan, kInfinity, -kInfinity}) {
    EXPECT_FALSE(holds("trot.lf_kfe.stance_nrmse", value, 0.1)) << value;
    EXPECT_FALSE(holds("trot.lf_kfe.stance_spectral_radius", value, 1.0)) << value;
    EXPECT_FALSE(holds("bench.plant.speedup", value, 20.0)) << value;
  }
}

TEST(Figures, WithoutABoundThereIsNothingToFail) {
  Figures figures;
  figures.add("trot.lf_kfe.stance_nrmse", kNan);
  EXPECT_TRUE(figures.all_hold());
}

TEST(Figures, OneThatFailsFailsThemAll) {
  Figures figures;
  figures.add("bench.plant.speedup", 30.0, 20.0);
  figures.add("bench.control.allocations", 1.0, 0.0);
  EXPECT_FALSE(figures.all_hold());
}

TEST(FiguresDeathTest, AnUndeclaredNameIsABug) {
  Figures figures;
  EXPECT_DEATH(figures.add("trot.lf_kfe.beauty", 1.0), "not declared");
  EXPECT_DEATH(figures.add("trot.stance_nrmse", 1.0), "not declared");
  EXPECT_DEATH(figures.add("trot..stance_nrmse", 1.0), "not declared");
  EXPECT_DEATH(figures.add("trot.lf_kfe.stance_nrmse.again", 1.0), "not declared");
}

TEST(FiguresDeathTest, ANameAddedTwiceIsABug) {
  Figures figures;
  figures.add("trot.ticks", 1.0);
  EXPECT_DEATH(figures.add("trot.ticks", 1.0), "added twice");
}

TEST(FiguresDeathTest, ABoundWithoutARelationOrNotFiniteIsABug) {
  Figures figures;
  EXPECT_DEATH(figures.add("trot.ticks", 1.0, 2.0), "cannot have this bound");
  EXPECT_DEATH(figures.add("trot.lf_kfe.stance_nrmse", 1.0, kNan), "cannot have this bound");
}

TEST(FigureRegistry, NoNameFallsUnderTwoPatterns) {
  for (const FigureSpec& one : figure_specs()) {
    for (const FigureSpec& other : figure_specs()) {
      // The pattern itself is a name: its placeholders match placeholders.
      EXPECT_EQ(&one == &other, match(other.pattern, one.pattern).has_value()) << one.pattern << " " << other.pattern;
    }
  }
}

TEST(FigureRegistry, PlaceholdersYieldTheNamesTheyStandFor) {
  const auto names = match("trot.packets.<process>.<topic>.sent", "trot.packets.joint_node_lf.joint_sensors.sent");
  ASSERT_TRUE(names.has_value());
  EXPECT_EQ(*names, (std::vector<std::string_view>{"joint_node_lf", "joint_sensors"}));
}

TEST(FigureRegistry, PlaceholdersMayBePartOfAPart) {
  using Names = std::vector<std::string_view>;
  EXPECT_EQ(match("trot.<quarter>_nrmse", "trot.quarter2_nrmse"), Names{"quarter2"});
  EXPECT_EQ(match("trot.ratio_<quarter>", "trot.ratio_quarter2"), Names{"quarter2"});
  EXPECT_FALSE(match("trot.<quarter>_nrmse", "trot.quarter2_ratio"));
  EXPECT_FALSE(match("trot.<quarter>_nrmse", "trot._nrmse")) << "a placeholder stands for something";
}

TEST(FigureRegistry, TheTableListsEveryPatternOnceWithItsSentence) {
  const std::string table = figures_table_markdown();
  for (const FigureSpec& spec : figure_specs()) {
    const std::string quoted = "`" + std::string(spec.pattern) + "`";
    const std::size_t first = table.find(quoted);
    ASSERT_NE(first, std::string::npos) << spec.pattern;
    EXPECT_EQ(table.find(quoted, first + 1), std::string::npos) << spec.pattern;
    EXPECT_NE(table.find(spec.sentence), std::string::npos) << spec.pattern;
    EXPECT_EQ(std::string(spec.sentence).back(), '.') << spec.pattern;
  }
}

}  // namespace figures_test
}  // namespace farrier::report
