#pragma once

#include <Eigen/Core>

#include "plant/actuator.hpp"
#include "plant/load_pressure.hpp"
#include "plant/state_space.hpp"

namespace farrier::plant {

// Three linear models of the joint, each with the rows that read a quantity from its states. For the quantities of
// Output, y = row x in deviations; none has a direct part.

enum class Output {
  kPosition,                  ///< m or rad
  kVelocity,                  ///< m/s or rad/s
  kLoadCellForce,             ///< F_s without the piston's inertia, Hubacher (2014) (3.3); N or Nm
  kLoadCellForceWithInertia,  ///< F_s as the cell reads it, (2.22); N or Nm
  kHydraulicForce,            ///< F_h (2.8); N or Nm
  kTotalForce,                ///< F_t = (m_l + m_p) a, (2.40); N or Nm
};

/// Treatment of the piston's mass m_p in the model of the load-cell force.
enum class PistonMass {
  kCounted,    ///< exact: F_s = F_h - d_p v - m_p a, (2.22)
  kNeglected,  ///< as Hubacher (2014), Section 3.3: F_s = F_h - d_p v in (3.46); a has 1/M in row 2, 1/m_l in row 3
};

/// Model in the load-cell force, states (x, v, F_s): linearise_load_pressure in other states, or the thesis's form of
/// it, (3.43)-(3.51) with row 2 of (3.51a) set right. Derivation of both: docs/derivations/load-cell-model.md. Assumes
/// steady chamber pressures (3.19), (3.20). Needs m_l > 0. The roots of the pressure drops are taken no smaller than
/// at the laminar pressure.
LinearModel linearise_load_cell_force(const ActuatorParams& actuator, const LoadParams& load,
                                      const OperatingPoint& point, Volumes volumes = Volumes::kMoving,
                                      PistonMass piston = PistonMass::kCounted);

/// Row that reads `output` from the states of linearise_load_cell_force. Where the piston's mass is neglected, both
/// load-cell forces are the third state.
Eigen::RowVector3d load_cell_output(Output output, const ActuatorParams& actuator, const LoadParams& load,
                                    PistonMass piston = PistonMass::kCounted);

/// Model in the load pressure, states (x, v, p_l): Hubacher (2014) (A.23)-(A.26); (3.36) at the nominal point. Assumes
/// steady chamber pressures (3.19), (3.20). Roots as above.
StateSpace<3> linearise_load_pressure(const ActuatorParams& actuator, const LoadParams& load,
                                      const OperatingPoint& point, Volumes volumes = Volumes::kMoving);

/// Row that reads `output` from the states of linearise_load_pressure; (A.27) for kLoadCellForce.
Eigen::RowVector3d load_pressure_output(Output output, const ActuatorParams& actuator, const LoadParams& load);

/// Operating point of the full model, whose chamber pressures are states.
struct ChamberPoint {
  State state;                   ///< position within the stroke, pressures > 0
  double valve_current_A = 0.0;  ///< only its size counts
  double valve_sign = 0.0;       ///< +1, -1, or 0 for the mean of both signs
};

/// Full model, states (x, v, p_a, p_b): Hubacher (2014) (A.4)-(A.19) with an erratum in (A.7). The exact
/// Jacobian of the simulated joint away from end stops and voids: its orifices are laminar below the laminar pressure,
/// where the thesis's roots have no slope.
StateSpace<4> linearise_full(const ActuatorParams& actuator, const LoadParams& load, const ChamberPoint& point,
                             Volumes volumes = Volumes::kMoving);

/// Row that reads `output` from the states of linearise_full; (A.20) for kLoadCellForce.
Eigen::RowVector4d full_output(Output output, const ActuatorParams& actuator, const LoadParams& load);

}  // namespace farrier::plant
