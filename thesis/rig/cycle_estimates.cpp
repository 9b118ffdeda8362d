#include "thesis/rig/cycle_estimates.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "control/model/transfer_function.hpp"
#include "estimation/poles.hpp"
#include "plant/nominal.hpp"

namespace farrier::thesis {
namespace {

constexpr std::size_t kSettledAfter = 60;
constexpr std::size_t kDrawnEvery = 5;

const std::vector<double>& error_grid() {
  static const std::vector<double> grid = control::logarithmic_grid(1.0, 450.0, 60);
  return grid;
}

control::SingleInOut<3> force_of(const control::DiscreteModel& model) {
  return {model.a, model.b, Eigen::RowVector3d(0.0, 0.0, 1.0), 0.0, thesis::kCyclePeriod_s};
}

double median_difference(const std::vector<double>& a, const std::vector<double>& b) {
  std::vector<double> differences(a.size());
  std::ranges::transform(a, b, differences.begin(), [](double x, double y) { return std::abs(x - y); });
  return median(std::move(differences));
}

}  // namespace

double median(std::vector<double> values) {
  if (values.empty()) {
    return std::numeric_limits<double>::quiet_NaN();
  }
  for (double& value : values) {
    value = std::isnan(value) ? std::numeric_limits<double>::infinity() : value;
  }
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::ranges::nth_element(values, middle);
  return *middle;
}

std::complex<double> complex_pole(const Eigen::Matrix3d& a) {
  const auto z = estimation::poles<3>(a);
  return *std::ranges::max_element(z, {}, [](std::complex<double> one) { return one.imag(); });
}

CycleEstimates::CycleEstimates(const std::vector<thesis::CycleSample>& samples,
                               std::span<const plant::LoadParams> loads, double forgetting_factor)
    : loads_(loads.begin(), loads.end()), models_(thesis::identify(samples, forgetting_factor)) {
  for (std::size_t section = 0; section < sections(); ++section) {
    const std::vector<double> wanted = decibels(true_response(section, error_grid()));
    for (const control::DiscreteModel& model : models(section)) {
      magnitudes_dB_.push_back(decibels(control::responses<3>(force_of(model), error_grid())));
      errors_.push_back(median_difference(magnitudes_dB_.back(), wanted));
      masses_.push_back(thesis::load_mass_kg(model.a));
    }
  }
}

std::span<const control::DiscreteModel> CycleEstimates::models(std::size_t section) const {
  return std::span(models_).subspan(section * kTicks, kTicks);
}

control::DiscreteModel CycleEstimates::truth(std::size_t section) const {
  return thesis::cycle_model_of(plant::nominal_cylinder(), loads_[section]);
}

Response CycleEstimates::true_response(std::size_t section, std::span<const double> grid) const {
  return control::responses<3>(force_of(truth(section)), grid);
}

double CycleEstimates::mass_error(std::size_t section, std::size_t tick) const {
  return std::abs(mass(section, tick) / loads_[section].mass - 1.0);
}

double CycleEstimates::converged_ms(std::size_t section, Tick until) const {
  auto tick = static_cast<std::size_t>(until);
  while (tick > 0 && error_dB(section, tick - 1) <= kConverged_dB) {
    --tick;
  }
  return static_cast<double>(tick) * thesis::kCyclePeriod_s * 1e3;
}

double CycleEstimates::mass_converged_ms(std::size_t section, Tick until) const {
  auto tick = static_cast<std::size_t>(until);
  while (tick > 0 && mass_error(section, tick - 1) <= kConvergedMass) {
    --tick;
  }
  return static_cast<double>(tick) * thesis::kCyclePeriod_s * 1e3;
}

double CycleEstimates::largest_error_dB(std::size_t section) const {
  double largest = 0.0;
  for (std::size_t tick = 0; tick < kTicks; ++tick) {
    largest = std::max(largest, error_dB(section, tick));
  }
  return largest;
}

double CycleEstimates::largest_mass_error(std::size_t section, Tick from) const {
  double largest = 0.0;
  for (auto tick = static_cast<std::size_t>(from); tick < kTicks; ++tick) {
    largest = std::max(largest, mass_error(section, tick));
  }
  return largest;
}

double CycleEstimates::mass_detour(std::size_t section) const {
  double way = 0.0;
  for (std::size_t tick = 1; tick < kSettledAfter; ++tick) {
    way += std::abs(mass(section, tick) - mass(section, tick - 1));
  }
  return way / std::abs(loads_[section].mass - loads_[section - 1].mass);
}

double CycleEstimates::least_mass(std::size_t section, Tick within) const {
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t tick = 0; tick < static_cast<std::size_t>(within); ++tick) {
    least = std::min(least, mass(section, tick));
  }
  return least / loads_[section].mass;
}

double CycleEstimates::resonance_missed(std::size_t section) const {
  const double wanted = std::ranges::max(decibels(true_response(section, error_grid())));
  double missed = 0.0;
  for (std::size_t tick = kSettledAfter; tick < kTicks; ++tick) {
    missed += std::abs(std::ranges::max(magnitudes_dB_[section * kTicks + tick]) - wanted) > 3.0 ? 1.0 : 0.0;
  }
  return missed / static_cast<double>(kTicks - kSettledAfter);
}

double CycleEstimates::settled_error_dB() const {
  double sum = 0.0;
  for (std::size_t section = 0; section < sections(); ++section) {
    for (std::size_t tick = kSettledAfter; tick < kTicks; ++tick) {
      sum += error_dB(section, tick);
    }
  }
  return sum / static_cast<double>(sections() * (kTicks - kSettledAfter));
}

double CycleEstimates::settled_spread_dB(Tick from, Tick until) const {
  double sum = 0.0;
  double count = 0.0;
  for (std::size_t section = 0; section < sections(); ++section) {
    for (auto tick = static_cast<std::size_t>(from); tick + 1 < static_cast<std::size_t>(until); ++tick, ++count) {
      const std::size_t at = section * kTicks + tick;
      sum += median_difference(magnitudes_dB_[at], magnitudes_dB_[at + 1]);
    }
  }
  return sum / count;
}

std::vector<Panel> CycleEstimates::bode(const std::string& title, std::size_t section, Tick until) const {
  static const std::vector<double> grid = control::logarithmic_grid(1.0, 499.0, 150);
  std::vector<Curve> curves;
  for (std::size_t tick = 0; tick < static_cast<std::size_t>(until); tick += kDrawnEvery) {
    const double shade = static_cast<double>(tick) / static_cast<double>(until);
    curves.push_back({"", control::responses<3>(force_of(models(section)[tick]), grid), 0, shade});
  }
  curves.push_back({"", true_response(section, grid), 1});
  return bode_panels(title, grid, curves);
}

Panel CycleEstimates::plane(const std::string& title, std::size_t section, bool zeros) const {
  Panel panel{.title = title, .x_label = "Re z", .y_label = "Im z", .unit_circle = true};
  const auto add = [&](const control::DiscreteModel& model, double shade, Series& series) {
    const control::SmallSpectrum all = zeros ? control::zeros(force_of(model)) : control::poles(force_of(model));
    for (const std::complex<double> z : all) {
      if (std::abs(z) < 1.5) {  // what the panel shows
        series.x.push_back(z.real());
        series.y.push_back(z.imag());
        series.shade.push_back(shade);
      }
    }
  };
  Series estimated{"", {}, {}, Style::kPoints, 0};
  for (std::size_t tick = 0; tick < kTicks; tick += kDrawnEvery) {
    add(models(section)[tick], static_cast<double>(tick) / static_cast<double>(kTicks), estimated);
  }
  Series wanted{"", {}, {}, Style::kCrosses, 1};
  add(truth(section), 0.0, wanted);
  wanted.shade.clear();
  panel.series = {std::move(estimated), std::move(wanted)};
  return panel;
}

Panel CycleEstimates::mass_panel(const std::string& title, Tick until) const {
  constexpr double kDrawn_kg = 150.0;
  Series estimated{"estimate", {}, {}, Style::kLine, 1}, wanted{"truth", {}, {}, Style::kLine, 2};
  const std::size_t last = (sections() - 1) * kTicks + static_cast<std::size_t>(until);
  for (std::size_t at = 0; at < last; ++at) {
    const double time_s = static_cast<double>(at) * thesis::kCyclePeriod_s;
    estimated.x.push_back(time_s);
    estimated.y.push_back(std::clamp(masses_[at], -kDrawn_kg, kDrawn_kg));
    wanted.x.push_back(time_s);
    wanted.y.push_back(loads_[at / kTicks].mass);
  }
  return {.title = title,
          .x_label = "time (s)",
          .y_label = "load mass (kg)",
          .series = {std::move(estimated), std::move(wanted)}};
}

}  // namespace farrier::thesis
