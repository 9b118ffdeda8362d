#include "locomotion/rotation.hpp"

#include <Eigen/Geometry>
#include <cmath>

#include "core/portable_math.hpp"

namespace farrier::locomotion {
namespace {

// Below this angle the series of Rodrigues' factors is exact to a double's precision.
constexpr double kSmallAngle_rad = 1e-4;
constexpr double kVertical = 1e-9;

}  // namespace

Eigen::Matrix3d skew(const Eigen::Vector3d& a) noexcept {
  Eigen::Matrix3d m;
  m << 0.0, -a.z(), a.y(), a.z(), 0.0, -a.x(), -a.y(), a.x(), 0.0;
  return m;
}

Eigen::Matrix3d rotation_by(const Eigen::Vector3d& angle_rad) noexcept {
  const double square = angle_rad.squaredNorm();
  const double angle = std::sqrt(square);
  double a = 1.0 - square / 6.0;   // sin(x) / x
  double b = 0.5 - square / 24.0;  // (1 - cos(x)) / x^2
  if (angle > kSmallAngle_rad) {
    const portable::SineCosine at = portable::sincos(angle);
    a = at.sine / angle;
    b = (1.0 - at.cosine) / square;
  }
  // R = I + a K + b K^2
  const Eigen::Matrix3d k = skew(angle_rad);
  return Eigen::Matrix3d::Identity() + a * k + b * (k * k);
}

Eigen::Vector3d sine_vector(const Eigen::Matrix3d& r) noexcept {
  return 0.5 * Eigen::Vector3d{r(2, 1) - r(1, 2), r(0, 2) - r(2, 0), r(1, 0) - r(0, 1)};
}

Eigen::Matrix3d orthonormalised(const Eigen::Matrix3d& r) noexcept {
  return 0.5 * r * (3.0 * Eigen::Matrix3d::Identity() - r.transpose() * r);
}

Eigen::Matrix3d heading_of(const Eigen::Matrix3d& rotation) noexcept {
  const double x = rotation(0, 0);
  const double y = rotation(1, 0);
  const double length = std::sqrt(x * x + y * y);
  Eigen::Matrix3d heading = Eigen::Matrix3d::Identity();
  if (length > kVertical) {
    heading.topLeftCorner<2, 2>() << x / length, -y / length, y / length, x / length;
  }
  return heading;
}

Eigen::Matrix3d tilt_to(const Eigen::Vector3d& up) noexcept {
  // R = I + K + K^2 / (1 + cos), K = skew(z x up)
  const Eigen::Matrix3d k = skew(Eigen::Vector3d::UnitZ().cross(up));
  return Eigen::Matrix3d::Identity() + k + (k * k) / (1.0 + up.z());
}

}  // namespace farrier::locomotion
