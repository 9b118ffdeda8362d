#include "supervisor/pole_set.hpp"

#include "estimation/poles.hpp"

namespace farrier::supervisor {

PoleSet poles_of(const control::DiscreteModel& model, control::Form form) noexcept {
  if (form == control::Form::kFullState) {
    return estimation::poles<3>(model.a);
  }
  const Eigen::Matrix2d loop = model.a.bottomRightCorner<2, 2>();
  const estimation::Poles<2> z = estimation::poles<2>(loop);
  return {z[0], z[1], 0.0};
}

double distance(const PoleSet& a, const PoleSet& b, control::Form form) noexcept {
  if (form == control::Form::kFullState) {
    return estimation::pole_distance<3>(a, b);
  }
  return estimation::pole_distance<2>({a[0], a[1]}, {b[0], b[1]});
}

}  // namespace farrier::supervisor
