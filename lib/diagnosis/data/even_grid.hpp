#pragma once

#include <cstddef>
#include <vector>

namespace farrier::diagnosis {

/// Ways to carry the values of a column to other times.
enum class Carry {
  kInterpolated,  ///< a measured quantity
  kHeld,          ///< acts from its row to the next: the mean over the new period
  kFlag,          ///< that of the row before
};

/// Even times over a span of uneven ones, and how values are carried to them.
class EvenGrid {
 public:
  /// `time_s` rises and has at least two entries; `periods` >= 1.
  EvenGrid(std::vector<double> time_s, std::size_t periods);

  double period_s() const noexcept { return period_s_; }
  const std::vector<double>& time_s() const noexcept { return at_s_; }
  /// The row before each even time.
  const std::vector<std::size_t>& rows() const noexcept { return from_; }

  /// Values at the even times; empty for none. Measured quantities are interpolated by cubic Hermite polynomials with
  /// slopes from three points. `error` is the RMS by which these differ from straight lines, else 0.
  std::vector<double> carry(const std::vector<double>& values, Carry how, double& error) const;

 private:
  double mean_of_held(const std::vector<double>& values, std::size_t place) const;
  double slope(const std::vector<double>& values, std::size_t row) const;
  double cubic(const std::vector<double>& values, std::size_t row, double share) const;

  std::vector<double> time_s_;
  double period_s_;
  std::vector<double> at_s_;
  std::vector<std::size_t> from_;
};

}  // namespace farrier::diagnosis
