#pragma once

// Frequency responses as studies compare and draw them.

#include <complex>
#include <span>
#include <string>
#include <vector>

#include "thesis/study/study.hpp"

namespace farrier::thesis {

/// Responses on a grid of frequencies (Hz), one after the other.
using Response = std::vector<std::complex<double>>;

std::vector<double> decibels(const Response& response);

/// Largest |a - b| in dB over the frequencies of `grid` within [from_Hz, to_Hz]; 0 when there are none.
double largest_difference_dB(std::span<const double> grid, const Response& a, const Response& b, double from_Hz,
                             double to_Hz);

/// Magnitude in dB at the grid's frequency nearest to `frequency_Hz`.
double magnitude_dB_near(std::span<const double> grid, const Response& response, double frequency_Hz);

/// A response to draw.
struct Curve {
  std::string label;
  Response response;
  int colour = 0;
  double shade = -1.0;  ///< [0, 1]: black to yellow instead of the colour
  Style style = Style::kLine;
};

/// Magnitude (dB) and phase (degrees) panels over frequency, in this order.
std::vector<Panel> bode_panels(const std::string& title, std::span<const double> grid, std::span<const Curve> curves);

/// Side by side, a column of magnitude over phase for each title.
Picture bode_picture(const std::string& caption, std::vector<std::vector<Panel>> columns);

}  // namespace farrier::thesis
