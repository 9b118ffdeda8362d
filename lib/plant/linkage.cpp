#include "plant/linkage.hpp"

#include <cmath>
#include <numbers>
#include <sstream>

#include "core/ensure.hpp"
#include "core/portable_math.hpp"

namespace farrier::plant {
namespace {

/// Share of the shorter side below which the lever counts as a dead centre.
constexpr double kDeadLeverShare = 1e-6;

bool is_sign(double value) { return value == 1.0 || value == -1.0; }

}  // namespace

Result<Linkage> Linkage::triangle(const TriangleParams& params) {
  std::ostringstream text;
  const auto require = [&text](bool holds, const char* name, double value, const char* rule) {
    if (!holds || !std::isfinite(value)) {
      text << (text.tellp() > 0 ? "; " : "linkage: ") << name << " = " << value << " must be " << rule;
    }
  };
  require(params.side_a_m > 0.0, "side_a_m", params.side_a_m, "finite and > 0");
  require(params.side_b_m > 0.0, "side_b_m", params.side_b_m, "finite and > 0");
  require(params.angle_at_zero_rad > 0.0 && params.angle_at_zero_rad < std::numbers::pi, "angle_at_zero_rad",
          params.angle_at_zero_rad, "within (0, pi)");
  require(is_sign(params.angle_sign), "angle_sign", params.angle_sign, "+1 or -1");
  require(is_sign(params.mirror), "mirror", params.mirror, "+1 or -1");
  require(params.retracted_length_m > 0.0 && params.retracted_length_m < params.side_a_m + params.side_b_m,
          "retracted_length_m", params.retracted_length_m, "> 0 and below side_a_m + side_b_m");
  if (!text.str().empty()) {
    return Error{text.str()};
  }
  return Linkage(params);
}

Linkage Linkage::direct(double lever, double offset) {
  FARRIER_ENSURE(std::isfinite(lever) && lever != 0.0 && std::isfinite(offset), "direct linkage needs a lever");
  return Linkage(lever, offset);
}

Linkage::Linkage(const TriangleParams& params) noexcept
    : angle_at_zero_(params.angle_at_zero_rad),
      sign_(params.angle_sign * params.mirror),
      squares_(params.side_a_m * params.side_a_m + params.side_b_m * params.side_b_m),
      two_ab_(2.0 * params.side_a_m * params.side_b_m),
      retracted_(params.retracted_length_m),
      dead_lever_(kDeadLeverShare * std::fmin(params.side_a_m, params.side_b_m)) {}

Linkage::Side Linkage::third_side(double q) const noexcept {
  const portable::SineCosine phi = portable::sincos(angle_at_zero_ + sign_ * q);
  // c^2 = a^2 + b^2 - 2 a b cos(phi)
  return {std::sqrt(squares_ - two_ab_ * phi.cosine), phi.sine, phi.cosine};
}

double Linkage::position(double q) const noexcept {
  return is_direct_ ? direct_lever_ * (q - offset_) : third_side(q).length - retracted_;
}

double Linkage::lever(double q) const noexcept {
  if (is_direct_) {
    return direct_lever_;
  }
  // dc/dphi = a b sin(phi) / c, the height of the triangle on the cylinder
  const Side side = third_side(q);
  return sign_ * 0.5 * two_ab_ * side.sine / side.length;
}

double Linkage::lever_slope(double q) const noexcept {
  if (is_direct_) {
    return 0.0;
  }
  // d2c/dphi2 = (a b cos(phi) - (dc/dphi)^2) / c
  const Side side = third_side(q);
  const double height = 0.5 * two_ab_ * side.sine / side.length;
  return (0.5 * two_ab_ * side.cosine - height * height) / side.length;
}

double Linkage::angle(double position) const noexcept {
  if (is_direct_) {
    return position / direct_lever_ + offset_;
  }
  const double c = retracted_ + position;
  return sign_ * (portable::acos((squares_ - c * c) / two_ab_) - angle_at_zero_);
}

double Linkage::angular_velocity(double q, double velocity) const noexcept {
  const double arm = lever(q);
  return std::abs(arm) > dead_lever_ ? velocity / arm : 0.0;
}

double Linkage::force(double q, double torque) const noexcept {
  const double arm = lever(q);
  return std::abs(arm) > dead_lever_ ? torque / arm : 0.0;
}

}  // namespace farrier::plant
