#include "control/model/plant_polynomials.hpp"

#include <Eigen/LU>

namespace farrier::control {

PlantPolynomials plant_polynomials(const DiscreteModel& model, Form form) noexcept {
  PlantPolynomials p{};
  if (form == Form::kCompliant) {
    const Eigen::Matrix2d a = model.a.bottomRightCorner<2, 2>();
    const Eigen::Vector2d b = model.b.tail<2>();
    const double c_1 = -a.trace();
    const Eigen::Vector2d low = a * b + c_1 * b;
    p.denominator = {a(0, 0) * a(1, 1) - a(0, 1) * a(1, 0), c_1, 1.0, 0.0};
    p.velocity = {low(0), b(0), 0.0};
    p.force = {low(1), b(1), 0.0};
    return p;
  }
  const Eigen::Matrix3d& a = model.a;
  const Eigen::Vector3d ab = a * model.b;
  const double c_2 = -a.trace();
  const double c_1 = a(0, 0) * a(1, 1) - a(0, 1) * a(1, 0) + a(0, 0) * a(2, 2) - a(0, 2) * a(2, 0) +
                     a(1, 1) * a(2, 2) - a(1, 2) * a(2, 1);
  const Eigen::Vector3d middle = ab + c_2 * model.b;
  const Eigen::Vector3d low = a * ab + c_2 * ab + c_1 * model.b;
  p.denominator = {-a.determinant(), c_1, c_2, 1.0};
  p.position = {low(0), middle(0), model.b(0)};
  p.velocity = {low(1), middle(1), model.b(1)};
  p.force = {low(2), middle(2), model.b(2)};
  return p;
}

}  // namespace farrier::control
