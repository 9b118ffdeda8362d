#pragma once

#include "plant/linear_model.hpp"

namespace farrier::plant {

// The joint Hubacher (2014) analyses in Chapters 3 and 4: Table A.1.

/// HyQ's leg cylinder with 0.3 m of line, p_s = 250 bar, K_v = 6.6815e-6. The table says nothing of end stops and
/// laminar flow: these are the simulated robots' (the default laminar pressure changes a root at 50 bar by 1e-4).
ActuatorParams nominal_cylinder();

/// 10 kg, 700 Ns/m, both springs (21480 N/m), slack in the middle of the stroke (2.23).
LoadParams nominal_load();

/// Divisors of the full model's states (3.9), of the valve current (3.11) and of the load-cell force (3.10); the
/// velocity's is an empirical one.
Eigen::Vector4d nominal_state_divisors(const ActuatorParams& actuator);
inline constexpr double kNominalVelocity_m_s = 1.2;
inline constexpr double kNominalCurrent_A = 0.01;
inline constexpr double kNominalForce_N = 5000.0;

/// Middle of the stroke at rest, no load pressure, valve shut (3.36), with the given sign of the valve (0: mean).
OperatingPoint nominal_point(double valve_sign);

/// The same with the chamber pressures of Chapter 3, p_a = alpha p_s / (1 + alpha) and p_b = p_s / (1 + alpha). They
/// are not those of steady flow, see steady_chambers.
ChamberPoint nominal_chamber_point(double valve_sign);

}  // namespace farrier::plant
