#pragma once

#include <optional>

#include "robot/robot.hpp"

namespace farrier::robot {

/// Changes of a hydraulic joint against its file: what wears, warms up or breaks. Default: none.
struct Wear {
  double valve_gain = 1.0;                       ///< factor on the valve's gain; > 0
  double bulk_modulus = 1.0;                     ///< factor; > 0
  double viscosity = 1.0;                        ///< factor on the piston's viscous friction; >= 0
  double seal_friction = 1.0;                    ///< factor on the effect piston_friction; >= 0
  double leakage = 0.0;                          ///< between the chambers, beside the file's, m^3/s/Pa; >= 0
  double overlap_A = 0.0;                        ///< of the valve, in place of the file's; >= 0
  std::optional<double> stuck_A = std::nullopt;  ///< current for which the spool stays open, whatever is sent

  bool operator==(const Wear&) const = default;
};

/// The wear of a joint as its file has it: the overlap is the file's.
Wear no_wear(const Joint& joint) noexcept;

/// The joint with that wear. A spool that is stuck is the simulation's matter.
Joint worn(const Joint& joint, const Wear& wear);

/// From one wear to another, by a share in [0, 1]. A spool is stuck from the beginning.
Wear between(const Wear& from, const Wear& to, double share) noexcept;

}  // namespace farrier::robot
