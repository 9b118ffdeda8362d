#pragma once

#include <array>
#include <cstddef>

namespace farrier::diagnosis {

/// Least squares of y = constant + sum of c_i r_i with every c_i within bounds, from moments that are added point by
/// point. A regressor with equal bounds has that coefficient.
class BoxRegression {
 public:
  static constexpr std::size_t kMost = 6;
  struct Bounds {
    double low = 0.0, high = 0.0;
  };
  using Values = std::array<double, kMost>;

  /// The first `count` regressors are used, at most kMost.
  explicit BoxRegression(std::size_t count) noexcept : count_(count) {}

  void add(double y, const Values& r) noexcept;

  struct Result {
    double unexplained = 1.0;  ///< residual over y, mean squares about the mean; 1 for a constant y
    Values coefficients{};     ///< nearest to 0 for a constant y
  };
  /// By coordinate descent (Hildreth 1957) from the middle of the bounds; unexplained may exceed 1.
  Result solve(const std::array<Bounds, kMost>& bounds) const noexcept;

 private:
  std::size_t count_;
  std::size_t points_ = 0;
  double y_ = 0.0, yy_ = 0.0;
  Values r_{}, ry_{};
  std::array<Values, kMost> rr_{};
};

}  // namespace farrier::diagnosis
