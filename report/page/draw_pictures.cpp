#include "report/page/draw_pictures.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <utility>

#include "config/visitor.hpp"
#include "core/ensure.hpp"
#include "core/replace_file.hpp"
#include "tools/tool_process/tool_process.hpp"

namespace farrier::report {
namespace {

// Okabe and Ito (2008): most colour-blind people can tell them apart.
constexpr std::array kColours{"#000000", "#0072b2", "#d55e00", "#009e73", "#cc79a7", "#667078"};

constexpr const char* kPanelStart = R"(reset
set border 3 lc rgb '#667078'
set tics nomirror out scale 0.5 textcolor rgb '#333333'
set style line 9 lc rgb '#d8dde1' lw 0.5
set grid xtics ytics ls 9
unset colorbox; set cbrange [0:1]; set palette defined (0 '#000000', 1 '#e69f00')
)";

constexpr double kRowHeight_px = 300.0;
constexpr double kSquareHeight_px = 400.0;

std::string number(double value) { return config::number_text(value); }

std::string in_quotes(const std::string& text) {
  std::string safe = "\"";
  for (const char c : text) {
    safe += c == '"' || c == '\\' ? "\\" : "";
    safe += c;
  }
  return safe + "\"";
}

/// Gnuplot takes the name of a tic as a format of its number.
std::string as_format(const std::string& text) {
  std::string safe;
  for (const char c : text) {
    safe += c == '%' ? "%%" : std::string(1, c);
  }
  return safe;
}

std::string range(const char* axis, const Range& range) {
  return std::string("set ") + axis + "range [" + number(range.from) + ":" + number(range.to) + "]\n";
}

/// A line per point: x, y, then shade or low and high where the series has them. Points that are not finite leave a gap
/// of one blank line, as two would begin a new block. Empty if no point is finite.
std::string block_of(const Series& series) {
  std::string lines;
  for (std::size_t i = 0; i < series.x.size(); ++i) {
    if (!std::isfinite(series.x[i]) || !std::isfinite(series.y[i])) {
      lines += lines.empty() || lines.ends_with("\n\n") ? "" : "\n";
      continue;
    }
    lines += number(series.x[i]) + " " + number(series.y[i]);
    for (const std::vector<double>* more : {&series.shade, &series.low, &series.high}) {
      lines += more->empty() ? "" : std::isfinite((*more)[i]) ? " " + number((*more)[i]) : " nan";
    }
    lines += "\n";
  }
  return lines;
}

void check(const Series& series) {
  bool complete = series.x.size() == series.y.size();
  for (const std::vector<double>* more : {&series.shade, &series.low, &series.high}) {
    complete = complete && (more->empty() || more->size() == series.x.size());
  }
  FARRIER_ENSURE(complete, "a series needs as many x as y, shades, lows and highs");
}

// In the order of Style.
constexpr std::array kLooks{"lines lw 1.2",
                            "lines lw 1.2 dashtype 2",
                            "steps lw 1.5",
                            "points pt 7 ps 0.4",
                            "points pt 7 ps 0.8",
                            "points pt 2 ps 1.2 lw 1.5",
                            "points pt 8 ps 1.3 lw 1.4",
                            "points pt 4 ps 1.5 lw 1.5",
                            "points pt 1 ps 0.8",
                            "filledcurves fillstyle solid noborder",
                            "yerrorbars pt 7 ps 0.3 lw 0.8",
                            "boxxyerror fillstyle solid 0.6 noborder",
                            "boxes fillstyle solid 0.15 noborder"};
static_assert(kLooks.size() == static_cast<std::size_t>(Style::kSpans) + 1);

/// The columns of a block that a style reads.
const char* columns_of(const Series& series) {
  switch (series.style) {
    case Style::kBand:
      return "1:2:3";
    case Style::kErrorBars:
      return "1:2:3:4";
    case Style::kBars:
      return "($1/2):2:(abs($1)/2):(0.35)";
    default:
      return series.shade.empty() ? "1:2" : "1:2:3";
  }
}

std::string rgb_of(const Series& series) {
  return std::string("rgb '") + kColours[static_cast<std::size_t>(series.colour) % kColours.size()] + "'";
}

/// Elements of a plot command, each with a comma behind it. `block` names the series's part of the data file.
std::string elements(const Series& series, bool empty, const std::string& block) {
  const std::string title = series.label.empty() ? " notitle, " : " title " + in_quotes(series.label) + ", ";
  const std::string with = std::string(" with ") + kLooks[static_cast<std::size_t>(series.style)];
  if (empty || series.style == Style::kSpans) {
    return series.label.empty() ? "" : "keyentry" + with + " lc " + rgb_of(series) + title;
  }
  const std::string colour = " lc " + (series.shade.empty() ? rgb_of(series) : "palette");
  std::string plots = block + " using " + columns_of(series) + with + colour + title;
  if (series.style == Style::kBars) {
    plots += block + " using 1:2:3:4 with xerrorbars pt 0 lc rgb '#1c2226' notitle, ";
  }
  if (series.style == Style::kBand) {  // a band without width is a line
    plots += block + " using 1:2 with lines lw 0.8" + colour + " notitle, ";
    plots += block + " using 1:3 with lines lw 0.8" + colour + " notitle, ";
  }
  return plots;
}

std::string spans(const Series& series) {
  std::string script;
  for (std::size_t i = 0; i < series.x.size() && series.style == Style::kSpans; ++i) {
    script += "set object rectangle from " + number(series.x[i]) + ", graph 0 to " + number(series.y[i]) +
              ", graph 1 behind fillstyle solid 0.1 noborder fillcolor " + rgb_of(series) + "\n";
  }
  return script;
}

std::string key(const Panel& panel, Key where) {
  if (std::ranges::all_of(panel.series, [](const Series& series) { return series.label.empty(); })) {
    return "set key off\n";
  }
  switch (where) {
    case Key::kInside:
      return "set key right top samplen 1.5 noautotitle\n";
    case Key::kAbove:
      return "set key tmargin right horizontal samplen 2 noautotitle\n";
    case Key::kBelow:
      return "set key bmargin left horizontal Left reverse samplen 1 height 1 noautotitle\n";
  }
  return "";
}

std::string axes(const Panel& panel) {
  std::string script = "set title " + in_quotes(panel.title) + "\nset xlabel " + in_quotes(panel.x_label) +
                       "\nset ylabel " + in_quotes(panel.y_label) + "\n";
  script += panel.log_x ? "set logscale x\n" : "";
  script += panel.log_y ? "set logscale y\nset format y '%.0e'\n" : "";
  if (panel.unit_circle) {
    const Range sides = panel.x_range.value_or(Range{-1.15, 1.15});
    script += "set size ratio -1\n" + range("x", sides) + range("y", sides) +
              "set object circle at 0,0 size 1 behind fillstyle solid 0.06 border rgb '#56616a' fillcolor rgb "
              "'#0072b2' linewidth 1.5\n";
  } else if (panel.x_range) {
    script += range("x", *panel.x_range);
  }
  script += panel.y_range ? range("y", *panel.y_range) : "";
  if (!panel.rows.empty()) {
    std::string names;
    for (std::size_t i = 0; i < panel.rows.size(); ++i) {
      names += (i == 0 ? "" : ", ") + in_quotes(as_format(panel.rows[i])) + " " + std::to_string(i);
    }
    script += range("y", {-0.7, static_cast<double>(panel.rows.size()) - 0.3}) + "set ytics (" + names +
              ")\nunset grid; set grid xtics ls 9\nset yzeroaxis lt 1 lc rgb '#667078'\n";
  }
  return script;
}

/// Margins of one of the panels that lie one above the other.
std::string place_in_stack(const Picture& picture, double height_px, std::size_t index) {
  constexpr double kLeft_px = 90.0, kRight_px = 16.0, kTop_px = 32.0, kBottom_px = 58.0, kGap_px = 18.0;
  const double count = static_cast<double>(picture.panels.size());
  const double each_px = (height_px - kTop_px - kBottom_px - kGap_px * (count - 1.0)) / count;
  const double top_px = height_px - kTop_px - static_cast<double>(index) * (each_px + kGap_px);
  const auto margin = [](const char* side, double share) {
    return std::string("set ") + side + "margin at screen " + number(share) + "\n";
  };
  return margin("l", kLeft_px / picture.width_px) + margin("r", 1.0 - kRight_px / picture.width_px) +
         margin("t", top_px / height_px) + margin("b", (top_px - each_px) / height_px) +
         (index + 1 < picture.panels.size() ? "set format x ''\n" : "");
}

double height_of(const Picture& picture, std::size_t rows) {
  const bool square = std::ranges::any_of(picture.panels, &Panel::unit_circle);
  return picture.height_px > 0.0 ? picture.height_px
                                 : static_cast<double>(rows) * (square ? kSquareHeight_px : kRowHeight_px);
}

}  // namespace

Drawing::Drawing(std::string out_dir) : out_dir_(std::move(out_dir)) {
  for (const char* name : {"/data", "/pictures"}) {
    std::error_code failure;
    std::filesystem::create_directories(out_dir_ + name, failure);
    if (failure && kept_) {
      kept_ = Error{"cannot make the folder " + out_dir_ + name + ": " + failure.message()};
    }
  }
}

void Drawing::keep(const std::string& path, const std::string& text) {
  if (kept_) {
    kept_ = replace_file(out_dir_ + "/" + path, text);
  }
}

std::string Drawing::add(const std::string& name, const Picture& picture) {
  const std::string path = "pictures/" + name + ".svg";
  const std::size_t columns = std::max<std::size_t>(picture.columns, 1);
  const std::size_t rows = (picture.panels.size() + columns - 1) / columns;
  const double height_px = height_of(picture, rows);
  script_ += "reset\nset encoding utf8\nset terminal svg size " + number(picture.width_px) + "," + number(height_px) +
             " font 'sans-serif,11' noenhanced background '#ffffff'\nset output '" + path + "'\nset multiplot layout " +
             std::to_string(rows) + "," + std::to_string(columns) + "\n";
  for (std::size_t i = 0; i < picture.panels.size(); ++i) {
    const Panel& panel = picture.panels[i];
    const std::string data = "data/" + name + "_" + std::to_string(i + 1) + ".dat";
    std::string blocks, plots;
    bool empty = true;
    script_ += kPanelStart + axes(panel) + key(panel, picture.key);
    script_ += picture.stacked ? place_in_stack(picture, height_px, i) : "";
    script_ += columns > 3 && !panel.unit_circle && !panel.log_x ? "set xtics rotate by -40\n" : "";
    for (std::size_t k = 0; k < panel.series.size(); ++k) {
      check(panel.series[k]);
      const std::string block = block_of(panel.series[k]);
      plots += elements(panel.series[k], block.empty(), "'" + data + "' index " + std::to_string(k));
      empty = empty && block.empty();
      blocks += (block.empty() ? "nan\n" : block) + "\n\n";
      script_ += spans(panel.series[k]);
    }
    keep(data, blocks);
    if (empty) {  // gnuplot refuses axes that nothing scales
      plots += "NaN notitle, ";
      script_ += panel.unit_circle || panel.x_range ? "" : range("x", {1.0, 10.0});
      script_ += panel.unit_circle || !panel.rows.empty() ? "" : range("y", {1.0, 10.0});
    }
    script_ += "plot " + plots.substr(0, plots.size() - 2) + "\n";
  }
  script_ += "unset multiplot\nunset output\n";
  return path;
}

Result<Done> Drawing::draw() const {
  if (!kept_ || script_.empty()) {
    return kept_;
  }
  const std::string script = "data/pictures.gp";
  FARRIER_TRY(replace_file(out_dir_ + "/" + script, script_));
  auto drawn = run_tool({"gnuplot", "gnuplot-nox"}, {script}, out_dir_,
                        (std::filesystem::absolute(out_dir_) / (script + ".log")).string());
  if (!drawn) {
    return Error{"cannot draw the report's pictures: " + drawn.error().message};
  }
  return drawn;
}

}  // namespace farrier::report
