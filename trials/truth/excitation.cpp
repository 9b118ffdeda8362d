#include "trials/truth/excitation.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace farrier::truth {

double Draws::log_within(double low, double high) { return low * std::pow(high / low, within(0.0, 1.0)); }

std::vector<double> envelope(const robot::Joint& joint, const Plan& plan, double period_s, int ticks) {
  std::array<double, 8> levels{0.15, 0.45, 0.75, 1.0, 0.2, 0.5, 0.7, 1.0};
  Draws draws(joint, plan, "truth envelope");
  for (const std::size_t half : {std::size_t{0}, std::size_t{4}}) {
    for (std::size_t i = 3; i > 0; --i) {
      const auto other = static_cast<std::size_t>(draws.within(0.0, 1.0 + static_cast<double>(i)));
      std::swap(levels[half + i], levels[half + other]);
    }
  }
  std::vector<double> out;
  double level = 0.0;
  const double most = period_s / 0.060;
  for (int k = 0; k < ticks; ++k) {
    level += std::clamp(levels[static_cast<std::size_t>(8 * k / ticks)] - level, -most, most);
    out.push_back(level);
  }
  return out;
}

void add_sine(std::vector<double>& signal, double period_s, double omega, double amplitude, double phase) {
  for (std::size_t k = 0; k < signal.size(); ++k) {
    signal[k] += amplitude * std::sin(omega * period_s * static_cast<double>(k) + phase);
  }
}

}  // namespace farrier::truth
