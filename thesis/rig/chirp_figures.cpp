#include "thesis/rig/chirp_figures.hpp"

#include <algorithm>
#include <cmath>

#include "control/model/transfer_function.hpp"
#include "thesis/rig/bode.hpp"

namespace farrier::thesis {
namespace {

control::SingleInOut<3> force_system(const control::DiscreteModel& model, double period_s) {
  return {model.a, model.b, Eigen::RowVector3d::UnitZ(), 0.0, period_s};
}

/// The models' indices between two times.
Span models_between(const ChirpEstimates& run, double from_s, double to_s) {
  const auto at = [&](double t) {
    return static_cast<std::size_t>(std::lower_bound(run.time_s.begin(), run.time_s.end(), t) - run.time_s.begin());
  };
  return {at(from_s), at(to_s)};
}

/// RMS of the difference in dB over the grid within [from_Hz, to_Hz].
double rms_difference_dB(const std::vector<double>& a, const std::vector<double>& b, double from_Hz, double to_Hz) {
  double sum = 0.0;
  double count = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    if (chirp_grid()[i] >= from_Hz && chirp_grid()[i] <= to_Hz) {
      sum += (a[i] - b[i]) * (a[i] - b[i]);
      count += 1.0;
    }
  }
  return std::sqrt(sum / count);
}

}  // namespace

const std::vector<double>& chirp_grid() {
  static const std::vector<double> grid = control::logarithmic_grid(0.3, 200.0, 90);
  return grid;
}

std::vector<std::complex<double>> force_response(const control::DiscreteModel& model, double period_s) {
  return control::responses(force_system(model, period_s), chirp_grid());
}

bool has_fictive_peak(const control::DiscreteModel& model, double period_s) {
  constexpr double kHighest_Hz = 10.0;
  constexpr double kProminence_dB = 3.0;
  const std::vector<double> dB = decibels(force_response(model, period_s));
  std::size_t end = 0;
  while (chirp_grid()[end] <= kHighest_Hz) {
    ++end;
  }
  for (std::size_t i = 1; i < end; ++i) {
    const auto at = dB.begin() + static_cast<std::ptrdiff_t>(i);
    if (dB[i] > dB[i - 1] && dB[i] >= dB[i + 1]) {
      const double left = *std::min_element(dB.begin(), at);
      const double right = *std::min_element(at, dB.end());
      if (dB[i] - std::max(left, right) >= kProminence_dB) {
        return true;
      }
    }
  }
  return false;
}

double fictive_share(const ChirpEstimates& run, double from_s, double to_s) {
  const Span span = models_between(run, from_s, to_s);
  double peaks = 0.0;
  for (std::size_t i = span.begin; i < span.end; ++i) {
    peaks += has_fictive_peak(run.models[i], run.period_s) ? 1.0 : 0.0;
  }
  return peaks / static_cast<double>(span.end - span.begin);
}

double distance_dB(const ChirpEstimates& run, double from_s, double to_s, double from_Hz, double to_Hz) {
  const std::vector<double> nominal = decibels(force_response(run.nominal, run.period_s));
  const Span span = models_between(run, from_s, to_s);
  double sum = 0.0;
  for (std::size_t i = span.begin; i < span.end; ++i) {
    sum += rms_difference_dB(decibels(force_response(run.models[i], run.period_s)), nominal, from_Hz, to_Hz);
  }
  return sum / static_cast<double>(span.end - span.begin);
}

double first_distance_dB(const ChirpEstimates& run, double from_Hz, double to_Hz) {
  return rms_difference_dB(decibels(force_response(run.first, run.period_s)),
                           decibels(force_response(run.nominal, run.period_s)), from_Hz, to_Hz);
}

double roughness_dB(const ChirpEstimates& run, double from_s, double to_s) {
  const Span span = models_between(run, from_s, to_s);
  double sum = 0.0;
  for (std::size_t i = span.begin + 1; i < span.end; ++i) {
    sum += rms_difference_dB(decibels(force_response(run.models[i], run.period_s)),
                             decibels(force_response(run.models[i - 1], run.period_s)), 1.0, 100.0);
  }
  return sum / static_cast<double>(span.end - span.begin - 1);
}

std::vector<Span> open_spans(const ChirpEstimates& run, std::size_t shortest) {
  std::vector<Span> spans;
  for (std::size_t i = 0; i < run.open.size(); ++i) {
    if (run.open[i] && (i == 0 || !run.open[i - 1])) {
      spans.push_back({i, i});
    }
    if (run.open[i]) {
      spans.back().end = i + 1;
    }
  }
  std::erase_if(spans, [=](const Span& span) { return span.end - span.begin < shortest; });
  return spans;
}

std::string spans_text(const std::vector<Span>& spans) {
  std::string text = "open from sample";
  for (const Span& span : spans) {
    text += number_as(" %.0f", static_cast<double>(span.begin)) + number_as(" to %.0f,", static_cast<double>(span.end));
  }
  return text;
}

double open_share(const ChirpEstimates& run) {
  double peaks = 0.0;
  double count = 0.0;
  for (std::size_t i = 0; i < run.models.size(); ++i) {
    if (run.learning[i]) {
      peaks += has_fictive_peak(run.models[i], run.period_s) ? 1.0 : 0.0;
      count += 1.0;
    }
  }
  return count > 0.0 ? peaks / count : 0.0;
}

std::vector<Panel> estimates_panels(const std::string& title, const ChirpEstimates& run) {
  constexpr std::size_t kDrawn = 40;
  std::vector<Curve> curves;
  const std::size_t each = std::max<std::size_t>(1, run.models.size() / kDrawn);
  for (std::size_t i = 0; i < run.models.size(); i += each) {
    if (run.learning[i]) {
      curves.push_back({"", force_response(run.models[i], run.period_s), 0,
                        static_cast<double>(i) / static_cast<double>(run.models.size()), Style::kLine});
    }
  }
  curves.push_back({"first", force_response(run.first, run.period_s), 4, -1.0, Style::kLine});
  curves.push_back({"nominal", force_response(run.nominal, run.period_s), 1, -1.0, Style::kLine});
  curves.push_back({"last", force_response(run.models.back(), run.period_s), 3, -1.0, Style::kLine});
  return bode_panels(title, chirp_grid(), curves);
}

Picture forgetting_picture(const std::string& caption, const ChirpEstimates& run) {
  Picture picture{caption, 1, {}};
  constexpr const char* kNames[] = {"position", "velocity", "force"};
  double least = 1.0;
  for (const Eigen::Vector3d& lambda : run.forgetting) {
    least = std::min(least, lambda.minCoeff());
  }
  for (int row = 0; row < 3; ++row) {
    Series series{"", run.tick_s, {}, Style::kLine, row + 1};
    for (const Eigen::Vector3d& lambda : run.forgetting) {
      series.y.push_back(lambda(row));
    }
    picture.panels.push_back({.title = kNames[row],
                              .x_label = "time (s)",
                              .y_label = "forgetting factor (1)",
                              .series = {std::move(series)},
                              .y_range = report::Range{least - 0.02, 1.02}});
  }
  return picture;
}

}  // namespace farrier::thesis
