#pragma once

#include "control/model/transfer_function.hpp"
#include "plant/load_pressure.hpp"

namespace farrier::control {

/// From valve current (A) to the three forces (N | Nm), in s: Hubacher (2014) (4.1)-(4.3) with signs and roots set
/// right. Derivation: docs/derivations/force-transfer.md.
struct ForceTransfers {
  Rational<3> load_cell;  ///< (4.1), without the piston's inertia (3.3)
  Rational<3> hydraulic;  ///< (4.2)
  Rational<3> total;      ///< (4.3)
};

/// The transfer functions of plant::linearise_load_pressure in coefficients, for one sign of the valve. Denominators
/// are not monic: their leading coefficient is M. Needs M = m_l + m_p > 0.
ForceTransfers force_transfers(const plant::ActuatorParams& actuator, const plant::LoadParams& load,
                               const plant::LoadPressureCoefficients& of) noexcept;

}  // namespace farrier::control
