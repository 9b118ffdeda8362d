#pragma once

// The oil that a cylinder's chambers need before they have the pressures of steady flow.

#include <algorithm>
#include <cmath>

#include "plant/actuator.hpp"
#include "plant/load_pressure.hpp"

namespace farrier::estimation {

/// The flow law of Hubacher (2014), (3.22) to (3.33), takes the chambers' pressures for those of steady flow through the
/// open ports, (3.19) and (3.20). After a port has opened, or opened to the other side, the chambers first take oil. A load
/// that pulls the piston faster than oil comes in empties a chamber: the pressure of steady flow would be below zero, and
/// the void must be filled before the law holds again.
class ChamberOil {
 public:
  explicit ChamberOil(const plant::ActuatorParams& actuator) noexcept
      : settling_m3_(kSettlingShare * actuator.supply_pressure_Pa / actuator.bulk_modulus_Pa *
                     (2.0 * actuator.line_volume_m3 + actuator.area_a * actuator.stroke)) {}

  /// A port has shut, or opened to the other side.
  void interrupt() noexcept { taken_m3_ = 0.0; }

  /// Takes the oil that moved during a tick, m^3, >= 0, at this point. Returns true where the chambers have the pressures
  /// of steady flow.
  bool take(const plant::ActuatorParams& actuator, const plant::OperatingPoint& point, double oil_m3) noexcept {
    const plant::State steady = plant::steady_chambers(actuator, point);
    if (std::min(steady.pressure_a_Pa, steady.pressure_b_Pa) < 0.0) {
      void_m3_ += oil_m3;  // at most so much
      taken_m3_ = 0.0;
    } else if (void_m3_ > 0.0) {
      void_m3_ -= oil_m3;
      taken_m3_ = 0.0;
    } else {
      taken_m3_ += oil_m3;
    }
    return taken_m3_ >= settling_m3_;
  }

  /// Some oil has been taken since the interruption or the void.
  bool fills() const noexcept { return taken_m3_ > 0.0; }

 private:
  // Share of the supply pressure that the chambers change by when the port opens to the other side.
  static constexpr double kSettlingShare = 0.25;

  double settling_m3_;  ///< oil for that change
  double taken_m3_ = 0.0;
  double void_m3_ = 0.0;
};

}  // namespace farrier::estimation
