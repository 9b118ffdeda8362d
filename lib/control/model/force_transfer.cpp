#include "control/model/force_transfer.hpp"

namespace farrier::control {

ForceTransfers force_transfers(const plant::ActuatorParams& actuator, const plant::LoadParams& load,
                               const plant::LoadPressureCoefficients& of) noexcept {
  const double A_p = actuator.area_a;
  const double M = load.mass + actuator.piston_mass;        // (2.25)
  const double B = load.damping + actuator.piston_damping;  // (2.26)
  const double C = load.stiffness;                          // (2.27)
  const double k_1 = of.by_pressure();                      // (3.23)
  const double k_2 = of.by_position();                      // (3.24)
  const double k_3 = of.by_velocity();                      // (3.25)
  const double drive = A_p * of.by_current();               // A_p k_4 (3.26)

  // M s^3 + (B - M k_1) s^2 + (C - B k_1 - A_p k_3) s - C k_1 - A_p k_2
  const std::array<double, 4> denominator{-C * k_1 - A_p * k_2, C - B * k_1 - A_p * k_3, B - M * k_1, M};
  return {{{drive * C, drive * load.damping, drive * M, 0.0}, denominator},
          {{drive * C, drive * B, drive * M, 0.0}, denominator},
          {{0.0, 0.0, drive * M, 0.0}, denominator}};
}

}  // namespace farrier::control
