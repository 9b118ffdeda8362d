// Results of a varied trot, from rows of known size.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <limits>
#include <sstream>

#include <unistd.h>

#include <filesystem>

#include "report/compare/vary_result.hpp"

namespace farrier::report {
namespace vary_test {

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

/// Two joints, three seeds; every contender at 0.02, swing at 0.5.
std::vector<VaryRow> rows() {
  std::vector<VaryRow> rows;
  for (std::uint64_t seed = 1; seed <= 3; ++seed) {
    for (const Contender contender : kContenders) {
      for (const char* joint : {"hip", "knee"}) {
        VaryRow row{.seed = seed, .contender = contender, .joint = joint};
        row.stance_nrmse = contender == Contender::kSwing ? 0.5 : 0.02;
        row.peak_demand = 0.8;
        rows.push_back(row);
      }
    }
  }
  return rows;
}

VaryRow& row_of(std::vector<VaryRow>& rows, std::uint64_t seed, Contender contender, const std::string& joint) {
  for (VaryRow& row : rows) {
    if (row.seed == seed && row.contender == contender && row.joint == joint) {
      return row;
    }
  }
  ADD_FAILURE();
  return rows.front();
}

Figures figures_of(const std::vector<VaryRow>& rows) {
  Figures figures;
  add_vary(figures, rows);
  return figures;
}

double value(const Figures& figures, const std::string& name) {
  const Figure* figure = figures.find("trot.vary." + name);
  EXPECT_NE(figure, nullptr) << name;
  return figure == nullptr ? kNaN : figure->value;
}

TEST(VaryFigures, HoldWhereAdaptationEqualsPerfectKnowledge) {
  const Figures figures = figures_of(rows());
  EXPECT_TRUE(figures.all_hold());
  EXPECT_EQ(value(figures, "seeds"), 3);
  EXPECT_EQ(value(figures, "median_ratio_perfect"), 1.0);
  EXPECT_EQ(value(figures, "swing.seeds_failed"), 3);
  EXPECT_EQ(value(figures, "stance.seeds_failed"), 0);
  EXPECT_EQ(value(figures, "swing.median_ratio"), 25.0);
  EXPECT_EQ(value(figures, "stance.wins"), 0);
}

TEST(VaryFigures, CountDivergenceOfEveryKind) {
  const auto with = [](auto change) {
    std::vector<VaryRow> changed = rows();
    change(row_of(changed, 2, Contender::kAdaptive, "knee"));
    return figures_of(changed);
  };
  for (const Figures& figures : {with([](VaryRow& row) { row.left_tracking = true; }),
                                 with([](VaryRow& row) { row.stance_nrmse = kNaN; }),
                                 with([](VaryRow& row) { row.stance_nrmse = 1.01; })}) {
    EXPECT_EQ(value(figures, "adaptive_diverged"), 1);
    EXPECT_EQ(value(figures, "adaptive.seeds_failed"), 1);
    EXPECT_FALSE(figures.all_hold());
  }
  const Figures poor = with([](VaryRow& row) { row.stance_nrmse = 0.31; });
  EXPECT_EQ(value(poor, "adaptive_diverged"), 0);
  EXPECT_EQ(value(poor, "adaptive.seeds_failed"), 1);
}

TEST(VaryFigures, KeepTheBoundOnJointsWhoseSupplyCannotCarryTheTaskAndShowTheRestBeside) {
  std::vector<VaryRow> changed = rows();
  row_of(changed, 1, Contender::kAdaptive, "knee").stance_nrmse = 0.2;
  row_of(changed, 1, Contender::kPerfect, "knee").peak_demand = 1.1;
  const Figures figures = figures_of(changed);
  EXPECT_EQ(value(figures, "adaptive_worst"), 0.2);
  EXPECT_FALSE(figures.find("trot.vary.adaptive_worst")->holds());
  EXPECT_EQ(value(figures, "adaptive_worst_within_supply"), 0.02);
  EXPECT_EQ(value(figures, "beyond_supply"), 1);
}

TEST(VaryText, SaysWhereAFixedBaselineBeatsAdaptation) {
  EXPECT_NE(vary_text(rows(), 10).find("no fixed baseline beats adaptation anywhere"), std::string::npos);
  std::vector<VaryRow> changed = rows();
  VaryRow& better = row_of(changed, 3, Contender::kStance, "hip");
  better.stance_nrmse = 0.0123;
  better.valve_factor = 0.9876;
  const std::string text = vary_text(changed, 10);
  const std::size_t line = text.find("where a fixed baseline beats adaptation (1)");
  ASSERT_NE(line, std::string::npos) << text;
  for (const char* part : {"stance", "hip", "0.0123", "0.9876"}) {
    EXPECT_NE(text.find(part, line), std::string::npos) << part;
  }
  EXPECT_EQ(value(figures_of(changed), "stance.wins"), 1);
}

TEST(VaryText, IsNoLongerThanAsked) {
  std::vector<VaryRow> changed = rows();
  for (VaryRow& row : changed) {
    row.stance_nrmse = row.contender == Contender::kAdaptive ? 0.03 : row.stance_nrmse;
  }
  const std::string text = vary_text(changed, 5);
  EXPECT_NE(text.find("beats adaptation (12)"), std::string::npos) << text;
  EXPECT_NE(text.find("... and 7 more"), std::string::npos) << text;
}

TEST(VaryCsv, HasEveryRowAndRefusesAPathItCannotWrite) {
  const std::string path = std::filesystem::temp_directory_path() / ("farrier_vary_" + std::to_string(::getpid()));
  ASSERT_TRUE(write_vary_csv(path, rows()).ok());
  std::ostringstream text;
  text << std::ifstream(path).rdbuf();
  std::filesystem::remove(path);
  const std::string written = text.str();
  EXPECT_EQ(std::count(written.begin(), written.end(), '\n'), 1 + static_cast<long>(rows().size()));
  EXPECT_NE(written.find("\n2,feedback_linearisation,knee,"), std::string::npos);
  EXPECT_FALSE(write_vary_csv("/nowhere/vary.csv", rows()).ok());
}

}  // namespace vary_test
}  // namespace farrier::report
