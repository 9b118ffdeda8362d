#include "report/diagnosis/diagnosis_pictures.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "config/visitor.hpp"
#include "report/diagnosis/diagnosis_text.hpp"
#include "report/diagnosis/round_pictures.hpp"
#include "report/diagnosis/wiring_picture.hpp"

namespace farrier::report {
namespace {

using diagnosis::ChannelReport;

/// True if a line can be drawn through values: two of them are finite.
bool has_points(const std::vector<double>& values) {
  return std::ranges::count_if(values, [](double value) { return std::isfinite(value); }) >= 2;
}

std::string add_time_picture(Drawing& drawing, const ChannelReport& c, const std::string& unit, double period_s) {
  const std::size_t count = std::min({c.measured.size(), c.simulated_before.size(), c.simulated_after.size()});
  if (!has_points(c.measured) || count < 2 || !(period_s > 0.0)) {
    return "";
  }
  const WorstWindow window = worst_second(c.measured, c.simulated_before, period_s);
  constexpr std::size_t kMostPoints = 4000;
  const std::size_t stride = 1 + window.size / kMostPoints;
  Series measured{.label = "measured"}, before{.label = "model as given", .colour = 2};
  Series after{.label = "extended model", .colour = 1}, error_before{.colour = 2}, error_after{.colour = 1};
  for (std::size_t i = window.begin; i < std::min(window.begin + window.size, count); i += stride) {
    const double time_s = static_cast<double>(i) * period_s;
    measured.add(time_s, c.measured[i]);
    before.add(time_s, c.simulated_before[i]);
    after.add(time_s, c.simulated_after[i]);
    error_before.add(time_s, c.measured[i] - c.simulated_before[i]);
    error_after.add(time_s, c.measured[i] - c.simulated_after[i]);
  }
  const double from_s = static_cast<double>(window.begin) * period_s;
  const Range range{from_s, from_s + static_cast<double>(window.size) * period_s};
  return drawing.add(std::string(c.name) + "_time",
                     {.panels = {{.y_label = words_of(c.name) + " / " + unit,
                                  .series = {std::move(measured), std::move(before), std::move(after)},
                                  .x_range = range},
                                 {.x_label = "time / s",
                                  .y_label = "error / " + unit,
                                  .series = {std::move(error_before), std::move(error_after)},
                                  .x_range = range}},
                      .key = Key::kAbove,
                      .stacked = true,
                      .height_px = 460.0});
}

std::string add_dependence_picture(Drawing& drawing, const ChannelReport& c, const std::string& unit) {
  std::vector<Panel> panels;
  for (const diagnosis::Dependence& one : c.dependences) {
    Series bars{.style = Style::kErrorBars, .colour = 5}, line{.colour = 2},
        means{.style = Style::kPoints, .colour = 2};
    for (std::size_t i = 0; i < std::min({one.from.size(), one.mean.size(), one.deviation.size()}); ++i) {
      for (Series* series : {&bars, &line, &means}) {
        series->add(bin_centre(one.from, i), one.mean[i]);
      }
      bars.low.push_back(one.mean[i] - one.deviation[i]);
      bars.high.push_back(one.mean[i] + one.deviation[i]);
    }
    if (has_points(one.mean)) {
      panels.push_back({.title = "explains " + config::number_text(std::round(100.0 * one.explained)) + " %",
                        .x_label = std::string(one.driver),
                        .y_label = "residual / " + unit,
                        .series = {std::move(bars), std::move(line), std::move(means)}});
    }
  }
  if (panels.empty()) {
    return "";
  }
  return drawing.add(std::string(c.name) + "_dependence",
                     {.columns = panels.size(), .panels = panels, .height_px = 260.0});
}

std::string add_spectrum_picture(Drawing& drawing, const ChannelReport& c, const std::string& unit) {
  Series before{.label = "model as given", .colour = 2}, after{.label = "extended model", .colour = 1};
  const std::size_t count = std::min({c.frequency_Hz.size(), c.spectrum_before.size(), c.spectrum_after.size()});
  for (std::size_t i = 0; i < count; ++i) {
    if (c.frequency_Hz[i] > 0.0 && c.spectrum_before[i] > 0.0 && c.spectrum_after[i] > 0.0) {
      before.add(c.frequency_Hz[i], c.spectrum_before[i]);
      after.add(c.frequency_Hz[i], c.spectrum_after[i]);
    }
  }
  if (before.x.size() < 2) {
    return "";
  }
  return drawing.add(std::string(c.name) + "_spectrum",
                     {.panels = {{.x_label = "frequency / Hz",
                                  .y_label = "power density of the error / (" + unit + ")^2/Hz",
                                  .log_x = true,
                                  .log_y = true,
                                  .series = {std::move(before), std::move(after)}}},
                      .width_px = 640.0,
                      .height_px = 320.0});
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
  Drawing drawing(out_dir);
  DiagnosisPictures pictures;
  for (const ChannelReport& channel : result.diagnosis.channels) {
    const char* const unit = unit_of(channel.channel, result.joint);
    pictures.channels.push_back({.time = add_time_picture(drawing, channel, unit, result.period_s),
                                 .dependence = add_dependence_picture(drawing, channel, unit),
                                 .spectrum = add_spectrum_picture(drawing, channel, unit)});
  }
  if (result.evidence) {
    pictures.wiring = add_wiring_picture(drawing, *result.evidence, result.joint);
  }
  pictures.rounds = add_round_pictures(drawing, result.diagnosis.judgement);
  FARRIER_TRY(drawing.draw());
  return pictures;
}

}  // namespace farrier::report
