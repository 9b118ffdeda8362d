// The renderer of pictures: data files, the script's order, and pictures that gnuplot draws from every style.

#include <cmath>
#include <filesystem>
#include <fstream>
#include <limits>
#include <sstream>
#include <string>

#include <gtest/gtest.h>
#include <unistd.h>

#include "report/page/draw_pictures.hpp"

namespace farrier::report {
namespace pictures_test {

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

class Pictures : public ::testing::Test {
 protected:
  void SetUp() override { std::filesystem::create_directories(path_); }
  void TearDown() override { std::filesystem::remove_all(path_); }

  std::string text_of(const std::string& name) const {
    std::ostringstream text;
    text << std::ifstream(path_ + "/" + name).rdbuf();
    return text.str();
  }

  /// The SVG of one picture; empty if it was refused.
  std::string drawn(const Picture& picture) {
    Drawing drawing(path_);
    const std::string name = drawing.add("one", picture);
    const auto done = drawing.draw();
    EXPECT_TRUE(done.ok()) << (done.ok() ? "" : done.error().message);
    return text_of(name);
  }

  const std::string path_ =
      (std::filesystem::temp_directory_path() / ("farrier_pictures_" + std::to_string(::getpid()))).string();
};

TEST_F(Pictures, DrawsEveryStyleWithItsLabel) {
  const std::vector<double> x{0.0, 1.0, 2.0}, y{0.0, 1.0, 0.5}, low{-0.5, 0.5, 0.0}, high{0.5, 1.5, 1.0};
  for (int style = 0; style <= static_cast<int>(Style::kSpans); ++style) {
    Series series{.label = "the label", .x = x, .y = y, .style = static_cast<Style>(style), .colour = 2};
    const bool between = series.style == Style::kErrorBars || series.style == Style::kBars;
    series.low = between ? low : std::vector<double>{};
    series.high = between || series.style == Style::kBand ? high : std::vector<double>{};
    const std::string svg = drawn({.panels = {{.series = {series, {.label = "line", .x = x, .y = y}}}}});
    EXPECT_NE(svg.find("</svg>"), std::string::npos) << style;
    EXPECT_NE(svg.find("the label"), std::string::npos) << style;
    EXPECT_NE(svg.find("213,  94,   0"), std::string::npos) << style << ": orange";
  }
}

TEST_F(Pictures, DataHasABlankLineWherePointsAreNotFinite) {
  drawn({.panels = {{.series = {{.x = {0.0, 1.0, 2.0, 3.0}, .y = {1.0, kNaN, kNaN, 4.0}},
                                {.label = "none", .x = {0.0}, .y = {kNaN}},
                                {.x = {1.0}, .y = {2.0}, .style = Style::kBand, .high = {3.0}}}}}});
  EXPECT_EQ(text_of("data/one_1.dat"), "0 1\n\n3 4\n\n\nnan\n\n\n1 2 3\n\n\n");
}

TEST_F(Pictures, SeriesWithoutPointsIsOnlyInTheKey) {
  for (const bool logarithmic : {false, true}) {
    const std::string svg = drawn(
        {.panels = {{.log_x = logarithmic, .log_y = logarithmic, .series = {{.label = "elsewhere"}}}, {.series = {}}},
         .key = Key::kAbove});
    EXPECT_NE(svg.find("elsewhere"), std::string::npos);
    EXPECT_NE(svg.find("</svg>"), std::string::npos);
  }
}

TEST_F(Pictures, NamesOfRowsStandInPlaceOfNumbers) {
  const std::string svg = drawn(
      {.panels = {
           {.series =
                {{.x = {0.5, 0.7}, .y = {0.0, 1.0}, .style = Style::kBars, .low = {0.4, 0.6}, .high = {0.6, 0.9}}},
            .rows = {"first \"row\"", "second row, 50 %"}}}});
  EXPECT_NE(svg.find("first \"row\""), std::string::npos) << svg;
  EXPECT_NE(svg.find("second row, 50 %"), std::string::npos);
}

TEST_F(Pictures, StackedPanelsHaveNumbersOfTheXAxisOnce) {
  const Series line{.x = {41.0, 42.0}, .y = {1e3, 2e3}};
  const Range range{41.0, 42.0};
  const std::string svg = drawn({.panels = {{.series = {line}, .x_range = range}, {.series = {line}, .x_range = range}},
                                 .stacked = true,
                                 .height_px = 460.0});
  const std::size_t first = svg.find("> 41<");
  ASSERT_NE(first, std::string::npos) << svg;
  EXPECT_EQ(svg.find("> 41<", first + 1), std::string::npos);
  EXPECT_NE(svg.find("width=\"1080\" height=\"460\""), std::string::npos);
}

TEST_F(Pictures, AFolderThatCannotBeMadeIsRefused) {
  std::ofstream(path_ + "/data") << "a file";
  Drawing drawing(path_);
  drawing.add("one", {.panels = {{.series = {{.x = {0.0}, .y = {0.0}}}}}});
  const auto done = drawing.draw();
  ASSERT_FALSE(done.ok());
  EXPECT_NE(done.error().message.find("cannot make the folder " + path_ + "/data"), std::string::npos)
      << done.error().message;
}

}  // namespace pictures_test
}  // namespace farrier::report
