#include <algorithm>
#include <array>
#include <cmath>

#include "report/diagnosis/diagnosis_text.hpp"

namespace farrier::report {
namespace {

constexpr double kLeastExplained = 0.1;
constexpr double kConstantShare = 0.8;  ///< of the bins' power, from which they are one constant
constexpr double kLeastFit = 0.6;       ///< of the bins' variance, below which no curve is named
constexpr double kNoBetter = 0.03;      ///< by which a curve further down must fit better

struct Curve {
  double (*of)(double x);
  const char* up;    ///< words in front of the driver's name, where the residual grows along the curve
  const char* down;
};
constexpr std::array kCurves{
    Curve{[](double x) { return x; }, "grows straight with ", "falls straight with "},
    Curve{[](double x) { return x > 0.0 ? 1.0 : x < 0.0 ? -1.0 : 0.0; }, "jumps up where the sign changes of ",
          "jumps down where the sign changes of "},
    Curve{[](double x) { return std::abs(x); }, "grows either way with ", "falls either way with "},
    Curve{[](double x) { return x * x; }, "grows with the square of ", "falls with the square of "},
    Curve{[](double x) { return x * std::abs(x); }, "grows with the signed square of ",
          "falls with the signed square of "},
    Curve{[](double x) { return x * x * x; }, "grows with the cube of ", "falls with the cube of "},
};

std::vector<double> centres_of(const diagnosis::Dependence& dependence) {
  const std::vector<double>& from = dependence.from;
  std::vector<double> centres(from.size());
  for (std::size_t i = 0; i < from.size(); ++i) {
    centres[i] = bin_centre(from, i);
  }
  // A position has no sign: its middle does.
  if (std::string_view(dependence.driver) == "position" && !centres.empty()) {
    const double middle = 0.5 * (centres.front() + centres.back());
    for (double& centre : centres) {
      centre -= middle;
    }
  }
  return centres;
}

struct Fit {
  double share;  ///< of y's variance
  double slope;
};

Fit fit(const std::vector<double>& x, const std::vector<double>& y, double (*curve)(double)) {
  double sx = 0.0, sy = 0.0, sxx = 0.0, sxy = 0.0, syy = 0.0;
  for (std::size_t i = 0; i < x.size(); ++i) {
    const double c = curve(x[i]);
    sx += c;
    sy += y[i];
    sxx += c * c;
    sxy += c * y[i];
    syy += y[i] * y[i];
  }
  const auto n = static_cast<double>(x.size());
  const double vx = sxx - sx * sx / n;
  const double vy = syy - sy * sy / n;
  const double cov = sxy - sx * sy / n;
  return vx > 0.0 && vy > 0.0 ? Fit{cov * cov / (vx * vy), cov / vx} : Fit{0.0, 0.0};
}

}  // namespace

double bin_centre(const std::vector<double>& from, std::size_t bin) {
  const double width = bin + 1 < from.size() ? from[bin + 1] - from[bin] : bin > 0 ? from[bin] - from[bin - 1] : 0.0;
  return from[bin] + 0.5 * width;
}

const diagnosis::Dependence* strongest(const diagnosis::ChannelReport& channel) {
  const auto found = std::ranges::max_element(channel.dependences, {}, &diagnosis::Dependence::explained);
  return found == channel.dependences.end() ? nullptr : &*found;
}

std::string shape_of(const diagnosis::Dependence& dependence) {
  const std::vector<double>& y = dependence.mean;
  if (!(dependence.explained >= kLeastExplained) || y.size() < 3 || y.size() != dependence.from.size()) {
    return "";
  }
  double sum = 0.0;
  double power = 0.0;
  for (const double value : y) {
    sum += value;
    power += value * value;
  }
  if (sum * sum / static_cast<double>(y.size()) > kConstantShare * power) {
    return "is about the same over all of " + std::string(dependence.driver);
  }
  const std::vector<double> x = centres_of(dependence);
  const Curve* best = nullptr;
  Fit best_fit{kLeastFit - kNoBetter, 0.0};
  for (const Curve& curve : kCurves) {
    const Fit one = fit(x, y, curve.of);
    if (one.share > best_fit.share + kNoBetter) {
      best = &curve;
      best_fit = one;
    }
  }
  if (best == nullptr) {
    return "changes with " + std::string(dependence.driver) + " along no simple curve";
  }
  return (best_fit.slope > 0.0 ? best->up : best->down) + std::string(dependence.driver);
}

}  // namespace farrier::report
