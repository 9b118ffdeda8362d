#include "report/diagnosis/diagnosis_pictures.hpp"

#include <algorithm>
#include <cmath>

#include "config/visitor.hpp"
#include "report/diagnosis/diagnosis_text.hpp"
#include "report/diagnosis/drawing.hpp"
#include "report/page/gnuplot.hpp"

namespace farrier::report {
namespace {

using diagnosis::ChannelReport;

constexpr const char* kTimeLayout =
    R"(set terminal svg size 1080,460 font "sans-serif,12" noenhanced background "#ffffff"
set lmargin at screen 0.085; set rmargin at screen 0.985
set key at screen 0.985,0.985 right top horizontal samplen 2 noautotitle
)";
constexpr const char* kSpectrumLayout =
    R"(set terminal svg size 640,320 font "sans-serif,11" noenhanced background "#ffffff"
set key right top samplen 2 noautotitle
set logscale xy; set format y "%.0e"
set xlabel "frequency / Hz" offset 0,0.4
)";

std::string time_picture(Drawing& drawing, const ChannelReport& c, const char* unit, double period_s) {
  const std::size_t count = std::min({c.measured.size(), c.simulated_before.size(), c.simulated_after.size()});
  if (!has_points(c.measured) || count < 2 || !(period_s > 0.0)) {
    return "";
  }
  const WorstWindow window = worst_second(c.measured, c.simulated_before, period_s);
  constexpr std::size_t kMostPoints = 4000;
  const std::size_t stride = 1 + window.size / kMostPoints;
  std::string lines;
  for (std::size_t i = window.begin; i < std::min(window.begin + window.size, count); i += stride) {
    lines += line_of({static_cast<double>(i) * period_s, c.measured[i], c.simulated_before[i], c.simulated_after[i],
                      c.measured[i] - c.simulated_before[i], c.measured[i] - c.simulated_after[i]});
  }
  const std::string data = drawing.data(std::string(c.name) + "_time", lines);
  const std::string path = "pictures/" + std::string(c.name) + "_time.svg";
  drawing.script += std::string(kPictureStart) + kTimeLayout + "set output '" + path + "'\nset multiplot\n" +
                    "set tmargin at screen 0.92; set bmargin at screen 0.49; set format x ''\nset ylabel '" +
                    words_of(c.name) + " / " + unit + "'\nplot '" + data +
                    "' using 1:2 with lines ls 1 title 'measured', '' using 1:3 with lines ls 3 title 'model as "
                    "given', '' using 1:4 with lines ls 2 title 'extended model'\n" +
                    "set tmargin at screen 0.45; set bmargin at screen 0.13\nset xlabel 'time / s' offset 0,0.4\n"
                    "set format x '%g'\nset ylabel 'error / " +
                    unit + "'\nplot '" + data + "' using 1:5 with lines ls 3, '' using 1:6 with lines ls 2\n" +
                    "unset multiplot\n";
  return path;
}

std::string dependence_picture(Drawing& drawing, const ChannelReport& c, const char* unit) {
  std::vector<std::string> plots;
  for (const diagnosis::Dependence& one : c.dependences) {
    std::string lines;
    for (std::size_t i = 0; i < std::min({one.from.size(), one.mean.size(), one.deviation.size()}); ++i) {
      lines += line_of({bin_centre(one.from, i), one.mean[i], one.deviation[i]});
    }
    if (has_points(one.mean)) {
      const std::string data = drawing.data(std::string(c.name) + "_over_" + one.driver, lines);
      plots.push_back("set xlabel '" + std::string(one.driver) + "' offset 0,0.4\nset title 'explains " +
                      config::number_text(std::round(100.0 * one.explained)) + " %'\nplot '" + data +
                      "' using 1:2:3 with yerrorbars pt 7 ps 0.3 lc rgb '#9aa5ad', '' using 1:2 with linespoints pt 7 "
                      "ps 0.4 lc rgb '#d55e00'\n");
    }
  }
  if (plots.empty()) {
    return "";
  }
  const std::string path = "pictures/" + std::string(c.name) + "_dependence.svg";
  drawing.script += std::string(kPictureStart) +
                    "set terminal svg size 1080,260 font \"sans-serif,11\" noenhanced background \"#ffffff\"\n"
                    "set key off\nset output '" + path + "'\nset multiplot layout 1," + std::to_string(plots.size()) +
                    "\nset ylabel 'residual / " + unit + "'\nset xtics rotate by -40\n";
  for (const std::string& plot : plots) {
    drawing.script += plot;
  }
  drawing.script += "unset multiplot\n";
  return path;
}

std::string spectrum_picture(Drawing& drawing, const ChannelReport& c, const char* unit) {
  std::string lines;
  int points = 0;
  const std::size_t count = std::min({c.frequency_Hz.size(), c.spectrum_before.size(), c.spectrum_after.size()});
  for (std::size_t i = 0; i < count; ++i) {
    if (c.frequency_Hz[i] > 0.0 && c.spectrum_before[i] > 0.0 && c.spectrum_after[i] > 0.0) {
      lines += line_of({c.frequency_Hz[i], c.spectrum_before[i], c.spectrum_after[i]});
      ++points;
    }
  }
  if (points < 2) {
    return "";
  }
  const std::string data = drawing.data(std::string(c.name) + "_spectrum", lines);
  const std::string path = "pictures/" + std::string(c.name) + "_spectrum.svg";
  drawing.script += std::string(kPictureStart) + kSpectrumLayout + "set output '" + path +
                    "'\nset ylabel 'power density of the error / (" + unit + ")^2/Hz'\nplot '" + data +
                    "' using 1:2 with lines ls 3 title 'model as given', '' using 1:3 with lines ls 2 title "
                    "'extended model'\n";
  return path;
}

}  // namespace

WorstWindow worst_second(const std::vector<double>& measured, const std::vector<double>& simulated, double period_s) {
  const std::size_t count = std::min(measured.size(), simulated.size());
  const std::size_t size = std::clamp<std::size_t>(static_cast<std::size_t>(std::lround(1.0 / period_s)), 1, count);
  double sum = 0.0;
  double most = -1.0;
  WorstWindow worst{0, size};
  const auto square = [&](std::size_t i) {
    const double error = measured[i] - simulated[i];
    return std::isfinite(error) ? error * error : 0.0;
  };
  for (std::size_t end = 0; end < count; ++end) {
    sum += square(end);
    if (end + 1 >= size) {
      if (sum > most) {
        most = sum;
        worst.begin = end + 1 - size;
      }
      sum -= square(end + 1 - size);
    }
  }
  return worst;
}

Result<DiagnosisPictures> draw_diagnosis(const std::string& out_dir, const DiagnosisResult& result) {
  FARRIER_TRY(make_picture_folders(out_dir));
  Drawing drawing{.out_dir = out_dir};
  DiagnosisPictures pictures;
  for (const ChannelReport& channel : result.diagnosis.channels) {
    const char* const unit = unit_of(channel.channel, result.joint);
    pictures.channels.push_back({.time = time_picture(drawing, channel, unit, result.period_s),
                                 .dependence = dependence_picture(drawing, channel, unit),
                                 .spectrum = spectrum_picture(drawing, channel, unit)});
  }
  for (const auto& round : result.diagnosis.judgement.rounds) {
    if (!round.empty()) {
      pictures.rounds.push_back(round_picture(drawing, round, pictures.rounds.size()));
    }
  }
  if (!drawing.kept) {
    return drawing.kept.error();
  }
  if (!drawing.script.empty()) {
    FARRIER_TRY(draw(out_dir, drawing.script));
  }
  return pictures;
}

}  // namespace farrier::report
