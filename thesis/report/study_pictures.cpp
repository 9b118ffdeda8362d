#include "thesis/report/study_pictures.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "config/problem.hpp"
#include "core/ensure.hpp"
#include "report/page/gnuplot.hpp"

namespace farrier::thesis {
namespace {

using thesis::Panel;
using thesis::Picture;
using thesis::Series;
using thesis::Style;

// Okabe and Ito (2008), as in gnuplot.hpp.
constexpr std::array kColours{"#000000", "#0072b2", "#d55e00", "#009e73", "#cc79a7", "#667078"};

constexpr double kWidth_px = 1080;
constexpr double kPanelHeight_px = 300;
constexpr double kSquareHeight_px = 400;

std::string in_quotes(const std::string& text) {
  std::string safe = "\"";
  for (const char c : text) {
    safe += c == '"' || c == '\\' ? "\\" : "";
    safe += c;
  }
  return safe + "\"";
}

/// A block of lines "x y shade"; points that are not finite leave a gap: one blank line, as two would begin a new block.
std::string block_of(const Series& series) {
  FARRIER_ENSURE(series.x.size() == series.y.size() && (series.shade.empty() || series.shade.size() == series.x.size()),
                 "a series needs as many x as y and shades");
  std::string lines;
  for (std::size_t i = 0; i < series.x.size(); ++i) {
    if (!std::isfinite(series.x[i]) || !std::isfinite(series.y[i])) {
      lines += lines.empty() || lines.ends_with("\n\n") ? "" : "\n";
      continue;
    }
    lines += config::number_text(series.x[i]) + " " + config::number_text(series.y[i]) + " " +
             config::number_text(series.shade.empty() ? 0.0 : series.shade[i]) + "\n";
  }
  return lines.empty() ? "nan nan 0\n" : lines;
}

std::string style_of(const Series& series) {
  const std::string colour =
      series.shade.empty()
          ? std::string(" lc rgb '") + kColours[static_cast<std::size_t>(series.colour) % kColours.size()] + "'"
          : " lc palette";
  switch (series.style) {
    case Style::kLine: return "with lines lw 1.2" + colour;
    case Style::kDashed: return "with lines lw 1.2 dashtype 2" + colour;
    case Style::kPoints: return "with points pt 7 ps 0.4" + colour;
    case Style::kCrosses: return "with points pt 2 ps 1.2 lw 1.5" + colour;
  }
  return {};
}

bool keyed(const Panel& panel) {
  return std::ranges::any_of(panel.series, [](const Series& series) { return !series.label.empty(); });
}

std::string panel_script(const Panel& panel, const std::string& data) {
  std::string script = "reset\nset style line 9 lc rgb '#d8dde1' lw 0.5\n"
                       "set grid xtics ytics ls 9\nset border 3 lc rgb '#667078'\nset tics nomirror out scale 0.5\n"
                       "unset colorbox\nset cbrange [0:1]\nset palette defined (0 '#000000', 1 '#e69f00')\n";
  script += "set title " + in_quotes(panel.title) + "\nset xlabel " + in_quotes(panel.x_label) + "\nset ylabel " +
            in_quotes(panel.y_label) + "\n";
  script += panel.log_x ? "set logscale x\n" : "";
  script += panel.log_y ? "set logscale y\nset format y '%.0e'\n" : "";
  script += keyed(panel) ? "set key right top samplen 1.5 noautotitle\n" : "set key off\n";
  if (panel.unit_circle) {
    script += "set size ratio -1\nset xrange [-1.15:1.15]\nset yrange [-1.15:1.15]\n"
              "set object circle at 0,0 size 1 behind fillstyle empty border lc rgb '#667078'\n";
  }
  std::string plots;
  for (std::size_t i = 0; i < panel.series.size(); ++i) {
    const Series& series = panel.series[i];
    plots += plots.empty() ? "plot " : ", ";
    plots += "'" + data + "' index " + std::to_string(i) + (series.shade.empty() ? " using 1:2 " : " using 1:2:3 ") +
             style_of(series) + (series.label.empty() ? " notitle" : " title " + in_quotes(series.label));
  }
  return script + (plots.empty() ? "plot NaN notitle" : plots) + "\n";
}

Result<std::string> picture_script(const std::string& out_dir, const thesis::Study& study, const Picture& picture,
                                   std::size_t index) {
  const std::size_t columns = std::max<std::size_t>(picture.columns, 1);
  const std::size_t rows = (picture.panels.size() + columns - 1) / columns;
  const bool square = std::ranges::any_of(picture.panels, &Panel::unit_circle);
  const double height = static_cast<double>(rows) * (square ? kSquareHeight_px : kPanelHeight_px);
  std::string script = std::string(report::kPictureStart) + "set terminal svg size " + config::number_text(kWidth_px) + "," +
                       config::number_text(height) + " font 'sans-serif,11' noenhanced background '#ffffff'\nset output '" +
                       picture_path(study, index) + "'\nset multiplot layout " + std::to_string(rows) + "," +
                       std::to_string(columns) + "\n";
  for (std::size_t i = 0; i < picture.panels.size(); ++i) {
    const std::string data = "data/" + std::string(study.number) + "_" + std::to_string(index + 1) + "_" +
                             std::to_string(i + 1) + ".dat";
    std::string blocks;
    for (const Series& series : picture.panels[i].series) {
      blocks += block_of(series) + "\n\n";
    }
    FARRIER_TRY(report::write_plot_data(out_dir + "/" + data, blocks));
    script += panel_script(picture.panels[i], data);
  }
  return script + "unset multiplot\nunset output\n";
}

}  // namespace

std::string picture_path(const thesis::Study& study, std::size_t index) {
  return "pictures/" + std::string(study.number) + "_" + std::to_string(index + 1) + ".svg";
}

Result<Done> draw_studies(const std::string& out_dir, std::span<const StudyRun> runs) {
  FARRIER_TRY(report::make_picture_folders(out_dir));
  std::string script;
  for (const StudyRun& run : runs) {
    for (std::size_t i = 0; run.result.ok() && i < run.result.value().pictures.size(); ++i) {
      auto one = FARRIER_TRY(picture_script(out_dir, run.study, run.result.value().pictures[i], i));
      script += one;
    }
  }
  return script.empty() ? Result<Done>(Done{}) : report::draw(out_dir, script);
}

}  // namespace farrier::thesis
