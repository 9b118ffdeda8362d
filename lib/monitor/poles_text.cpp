#include "monitor/poles_text.hpp"

#include <cmath>
#include <cstdio>

namespace farrier::monitor {
namespace {

std::string three_decimals(double value) {
  char text[48];
  std::snprintf(text, sizeof text, "%.3f", value);
  return text;
}

}  // namespace

std::string poles_text(const std::array<std::complex<double>, 3>& poles) {
  std::string text;
  for (std::size_t i = 0; i < poles.size(); ++i) {
    if (!std::isfinite(poles[i].real())) {
      return "-";
    }
    text += (text.empty() ? "" : " ") + three_decimals(poles[i].real());
    if (poles[i].imag() != 0.0) {
      text += "+-" + three_decimals(std::abs(poles[i].imag())) + "i";
      ++i;  // its conjugate
    }
  }
  return text;
}

}  // namespace farrier::monitor
