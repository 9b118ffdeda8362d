#include "control/numerics/francis.hpp"
#include "control/numerics/sizes.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace farrier::control {
namespace {

constexpr int kMaxShifts = 30;
constexpr int kExceptionalEvery = 10;
constexpr double kRounding = std::numeric_limits<double>::epsilon();
constexpr double kLargest = 1e50;  // products of a few entries stay finite

template <int N>
using Table = double[N][N];

/// I - beta v v' that takes (x, y, z) to (alpha, 0, 0), v(0) = 1.
struct Reflection {
  double alpha;
  double beta;
  double y;
  double z;
};

Reflection reflection(double x, double y, double z) noexcept {
  const double rest = y * y + z * z;
  if (!(rest > 0.0)) {
    return {x, 0.0, 0.0, 0.0};
  }
  const double alpha = -std::copysign(std::sqrt(x * x + rest), x);
  const double head = x - alpha;
  return {alpha, -head / alpha, y / head, z / head};
}

/// Both sides of an active block's rows and columns k, k + 1 and, for Size 3, k + 2.
template <int N, int Size>
void reflect(Table<N>& h, const Reflection& r, int k, int first_column, int last_column, int first_row,
             int last_row) noexcept {
  for (int j = first_column; j <= last_column; ++j) {
    const double sum = r.beta * (h[k][j] + r.y * h[k + 1][j] + (Size == 3 ? r.z * h[k + 2][j] : 0.0));
    h[k][j] -= sum;
    h[k + 1][j] -= sum * r.y;
    if constexpr (Size == 3) {
      h[k + 2][j] -= sum * r.z;
    }
  }
  for (int i = first_row; i <= last_row; ++i) {
    const double sum = r.beta * (h[i][k] + r.y * h[i][k + 1] + (Size == 3 ? r.z * h[i][k + 2] : 0.0));
    h[i][k] -= sum;
    h[i][k + 1] -= sum * r.y;
    if constexpr (Size == 3) {
      h[i][k + 2] -= sum * r.z;
    }
  }
}

template <int N>
void to_hessenberg(Table<N>& h) noexcept {
  for (int k = 0; k + 2 < N; ++k) {
    double v[N];
    double rest = 0.0;
    for (int i = k + 2; i < N; ++i) {
      rest += h[i][k] * h[i][k];
    }
    if (!(rest > 0.0)) {
      continue;
    }
    const double x = h[k + 1][k];
    const double alpha = -std::copysign(std::sqrt(x * x + rest), x);
    const double beta = (alpha - x) / alpha;
    v[k + 1] = 1.0;
    for (int i = k + 2; i < N; ++i) {
      v[i] = h[i][k] / (x - alpha);
      h[i][k] = 0.0;
    }
    h[k + 1][k] = alpha;
    for (int j = k + 1; j < N; ++j) {
      double sum = 0.0;
      for (int i = k + 1; i < N; ++i) {
        sum += v[i] * h[i][j];
      }
      for (int i = k + 1; i < N; ++i) {
        h[i][j] -= beta * sum * v[i];
      }
    }
    for (int i = 0; i < N; ++i) {
      double sum = 0.0;
      for (int j = k + 1; j < N; ++j) {
        sum += h[i][j] * v[j];
      }
      for (int j = k + 1; j < N; ++j) {
        h[i][j] -= beta * sum * v[j];
      }
    }
  }
}

/// One double shift on rows and columns low..high: the roots of (a - z)(b - z) = c.
template <int N>
void shift(Table<N>& h, int low, int high, double a, double b, double c) noexcept {
  const double first = h[low][low];
  // First column of (H^2 - (a + b) H + (a b - c) I), over h10.
  double x = ((a - first) * (b - first) - c) / h[low + 1][low] + h[low][low + 1];
  double y = first + h[low + 1][low + 1] - a - b;
  double z = h[low + 2][low + 1];
  for (int k = low; k + 1 < high; ++k) {
    const Reflection r = reflection(x, y, z);
    reflect<N, 3>(h, r, k, std::max(low, k - 1), high, low, std::min(k + 3, high));
    if (k > low) {
      h[k + 1][k - 1] = 0.0;
      h[k + 2][k - 1] = 0.0;
    }
    x = h[k + 1][k];
    y = h[k + 2][k];
    z = k + 3 <= high ? h[k + 3][k] : 0.0;
  }
  reflect<N, 2>(h, reflection(x, y, 0.0), high - 1, high - 2, high, low, high);
  h[high][high - 2] = 0.0;
}

/// Eigenvalues of rows and columns i, i + 1.
template <int N>
void eigenvalues_of_block(const Table<N>& h, int i, Eigen::Matrix<std::complex<double>, N, 1>& z) noexcept {
  // t^2 - ((a - d)/2)^2 - b c about the mean of a and d
  const double half = 0.5 * (h[i][i] - h[i + 1][i + 1]);
  const double centre = h[i + 1][i + 1] + half;
  const double product = h[i][i + 1] * h[i + 1][i];
  const double square = half * half + product;
  if (square < 0.0) {
    const double imaginary = std::sqrt(-square);
    z(i) = {centre, imaginary};
    z(i + 1) = {centre, -imaginary};
    return;
  }
  const double away = half + std::copysign(std::sqrt(square), half);
  z(i) = h[i + 1][i + 1] + away;
  z(i + 1) = away != 0.0 ? h[i + 1][i + 1] - product / away : h[i + 1][i + 1];
}

}  // namespace

template <int N>
bool francis_eigenvalues(const Eigen::Matrix<double, N, N>& m, Eigen::Matrix<std::complex<double>, N, 1>& z) noexcept {
  Table<N> h;
  double size = 0.0;
  for (int i = 0; i < N; ++i) {
    for (int j = 0; j < N; ++j) {
      h[i][j] = m(i, j);
      size += std::abs(m(i, j));
    }
  }
  if (size == 0.0) {
    z.setZero();
    return true;
  }
  if (!std::isfinite(size)) {
    return false;
  }
  // Scaled by a power of two, which rounds nothing, so that products of a few entries stay finite.
  const int exponent = size <= kLargest && size >= 1.0 / kLargest ? 0 : std::ilogb(size);
  if (exponent != 0) {
    size = 0.0;
    for (auto& row : h) {
      for (double& entry : row) {
        entry = std::scalbn(entry, -exponent);
        size += std::abs(entry);
      }
    }
  }
  to_hessenberg<N>(h);
  int high = N - 1;
  int shifts = 0;
  while (high >= 0) {
    int low = high;
    while (low > 0) {
      const double neighbours = std::abs(h[low - 1][low - 1]) + std::abs(h[low][low]);
      if (std::abs(h[low][low - 1]) <= kRounding * (neighbours > 0.0 ? neighbours : size)) {
        break;
      }
      --low;
    }
    if (low >= high - 1) {
      if (low == high) {
        z(high) = h[high][high];
      } else {
        eigenvalues_of_block<N>(h, low, z);
      }
      high = low - 1;
      shifts = 0;
      continue;
    }
    if (++shifts > kMaxShifts) {
      return false;
    }
    if constexpr (N > 2) {
      if (shifts % kExceptionalEvery == 0) {
        const double step = std::abs(h[high][high - 1]) + std::abs(h[high - 1][high - 2]);
        const double about = h[high][high] + 0.75 * step;
        shift<N>(h, low, high, about, about, -0.4375 * step * step);
      } else {
        shift<N>(h, low, high, h[high - 1][high - 1], h[high][high], h[high][high - 1] * h[high - 1][high]);
      }
    }
  }
  if (exponent != 0) {
    for (int i = 0; i < N; ++i) {
      z(i) = {std::scalbn(z(i).real(), exponent), std::scalbn(z(i).imag(), exponent)};
    }
  }
  return z.allFinite();
}

#define FARRIER_INSTANTIATE(N)                                             \
  template bool francis_eigenvalues<N>(const Eigen::Matrix<double, N, N>&, \
                                       Eigen::Matrix<std::complex<double>, N, 1>&) noexcept;
FARRIER_FOR_EACH_SIZE(FARRIER_INSTANTIATE)
#undef FARRIER_INSTANTIATE

}  // namespace farrier::control
