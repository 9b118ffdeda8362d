#include "locomotion/ground_plane.hpp"

#include <Eigen/LU>

namespace farrier::locomotion {
namespace {

// Mean square spread of the feet below which a slope is unknown: feet within 5 cm of a line.
constexpr double kSmallestSpread_m2 = 0.0025;

}  // namespace

void GroundPlane::reset(double height_m) noexcept {
  height_ = height_m;
  slope_.setZero();
}

void GroundPlane::update(const PerLeg<Eigen::Vector3d>& footholds_m, int count, const Eigen::Vector3d& center_m,
                         const Eigen::Matrix3d& heading) noexcept {
  // the old plane, seen from the new place
  const double carried = height_at(center_m);
  center_ = center_m;
  heading_ = heading;
  Eigen::Vector3d mean = Eigen::Vector3d::Zero();
  for (int i = 0; i < count; ++i) {
    mean += footholds_m[i] / count;
  }
  Eigen::Matrix2d spread = Eigen::Matrix2d::Zero();
  Eigen::Vector2d rise = Eigen::Vector2d::Zero();
  for (int i = 0; i < count; ++i) {
    const Eigen::Vector3d from_mean = heading.transpose() * (footholds_m[i] - mean);
    spread += from_mean.head<2>() * from_mean.head<2>().transpose() / count;
    rise += from_mean.head<2>() * from_mean.z() / count;
  }
  const double share = period_s_ / (params_.time_constant_s + period_s_);
  const double determinant = spread.determinant();
  if (determinant > kSmallestSpread_m2 * spread.trace()) {
    const Eigen::Vector2d limit = Eigen::Vector2d::Constant(params_.largest_slope);
    const Eigen::Vector2d measured = (spread.inverse() * rise).cwiseMax(-limit).cwiseMin(limit);
    slope_ += share * (measured - slope_);
  }
  const Eigen::Vector2d to_center = (heading.transpose() * (center_m - mean)).head<2>();
  height_ = carried + share * (mean.z() + slope_.dot(to_center) - carried);
}

double GroundPlane::height_at(const Eigen::Vector3d& place_m) const noexcept {
  return height_ + slope_.dot((heading_.transpose() * (place_m - center_)).head<2>());
}

Eigen::Vector3d GroundPlane::normal() const noexcept {
  return (heading_ * Eigen::Vector3d{-slope_.x(), -slope_.y(), 1.0}).normalized();
}

}  // namespace farrier::locomotion
