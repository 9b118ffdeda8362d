#include "thesis/rig/bode.hpp"

#include <algorithm>
#include <cmath>

#include "control/model/transfer_function.hpp"

namespace farrier::thesis {

std::vector<double> decibels(const Response& response) {
  std::vector<double> values;
  values.reserve(response.size());
  for (const std::complex<double> one : response) {
    values.push_back(control::decibel(one));
  }
  return values;
}

double largest_difference_dB(std::span<const double> grid, const Response& a, const Response& b, double from_Hz,
                             double to_Hz) {
  double largest = 0.0;
  for (std::size_t i = 0; i < grid.size(); ++i) {
    if (grid[i] >= from_Hz && grid[i] <= to_Hz) {
      const double difference = std::abs(control::decibel(a[i]) - control::decibel(b[i]));
      largest = std::isnan(difference) ? difference : std::max(largest, difference);
    }
  }
  return largest;
}

double magnitude_dB_near(std::span<const double> grid, const Response& response, double frequency_Hz) {
  const auto nearest = std::ranges::min_element(
      grid, {}, [&](double f) { return std::abs(std::log(f / frequency_Hz)); });
  return control::decibel(response[static_cast<std::size_t>(nearest - grid.begin())]);
}

std::vector<Panel> bode_panels(const std::string& title, std::span<const double> grid, std::span<const Curve> curves) {
  Panel magnitude{.title = title, .x_label = "frequency (Hz)", .y_label = "magnitude (dB)", .log_x = true};
  Panel phase{.title = "", .x_label = "frequency (Hz)", .y_label = "phase (deg)", .log_x = true};
  const std::vector<double> frequencies(grid.begin(), grid.end());
  for (const Curve& curve : curves) {
    const std::vector<double> shade =
        curve.shade < 0.0 ? std::vector<double>{} : std::vector<double>(frequencies.size(), curve.shade);
    magnitude.series.push_back({curve.label, frequencies, decibels(curve.response), curve.style, curve.colour, shade});
    phase.series.push_back({"", frequencies, control::unwrapped_degrees(curve.response), curve.style, curve.colour, shade});
  }
  return {std::move(magnitude), std::move(phase)};
}

Picture bode_picture(const std::string& caption, std::vector<std::vector<Panel>> columns) {
  Picture picture{caption, columns.size(), {}};
  for (std::size_t row = 0; row < 2; ++row) {
    for (std::vector<Panel>& column : columns) {
      picture.panels.push_back(std::move(column[row]));
    }
  }
  return picture;
}

}  // namespace farrier::thesis
