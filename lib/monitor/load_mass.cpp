#include "monitor/load_mass.hpp"

#include <Eigen/Dense>
#include <cmath>
#include <unsupported/Eigen/MatrixFunctions>

#include "control/model/model_rows.hpp"
#include "estimation/poles.hpp"

namespace farrier::monitor {
namespace {

/// Hubacher (2014) (3.47): m_l dv/dt = F_s - d_l v - C x. So the entry (velocity, force) of the continuous matrix
/// log(A) / T is 1 / m_l, however far force and velocity move within a period.
double of_model(const Eigen::Matrix3d& a, double period_s) {
  for (const std::complex<double>& pole : estimation::poles<3>(a)) {
    if (!std::isfinite(std::abs(pole)) || (pole.imag() == 0.0 && pole.real() <= 0.0)) {
      return NAN;  // not sampled from anything continuous
    }
  }
  // Newtons beside metres: the force is scaled so that what couples it with the velocity is of one size both ways.
  const double scale = std::sqrt(std::abs(a(2, 1) / a(1, 2)));
  if (!std::isfinite(scale) || scale == 0.0) {
    return NAN;
  }
  const Eigen::Vector3d scales(1.0, 1.0, scale);
  const Eigen::Matrix3d scaled = scales.cwiseInverse().asDiagonal() * a * scales.asDiagonal();
  return period_s * scale / Eigen::Matrix3d(scaled.log())(1, 2);
}

}  // namespace

std::optional<double> load_mass(const signals::JointModelEstimate& estimate, double period_s) {
  const double mass = estimate.has_physics != 0
                          ? estimate.physics[0]
                          : of_model(control::model_of_rows(estimate.a, estimate.b).a, period_s);
  return std::isfinite(mass) && mass > 0.0 ? std::optional(mass) : std::nullopt;
}

}  // namespace farrier::monitor
