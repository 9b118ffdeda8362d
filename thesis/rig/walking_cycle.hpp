#pragma once

// Hubacher (2014), Section 6.3: what the estimator of a joint is tried on. The joint is that of Table A.1.

#include <Eigen/Core>

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "control/model/discretise.hpp"
#include "core/time.hpp"
#include "plant/actuator.hpp"

namespace farrier::thesis {

inline constexpr double kCyclePeriod_s = 1e-3;
inline constexpr Tick kSectionTicks = 250;  ///< a stance at 2 Hz
inline constexpr double kCycleHome_m = 0.04;
inline constexpr double kSmallOpening = 0.05;  ///< of the nominal current
inline constexpr double kFullOpening = 1.0;
inline constexpr double kHeavyLoad_kg = 105.0;
inline constexpr double kStartLoad_kg = 10.5;

/// The nominal load with another mass and friction.
plant::LoadParams cycle_load(double mass_kg, double damping_Ns_m = 700.0);

/// Fig. 6.1, one load per section. The figure has no numbers that survive, so the text fixes them. The first two are
/// 10.5 kg (6.3.3) and 105 kg (6.3.3: ten times). The third is 1.05 kg ("low again", still within the 1 to 127 kg of
/// 4.3.2). The last is 2.1 kg with five times the friction ("increased only little, but the friction greatly").
const std::array<plant::LoadParams, 4>& walking_cycle();

/// The load-cell model at home, mean of both signs of the valve, sampled with kCyclePeriod_s.
control::DiscreteModel cycle_model_of(const plant::ActuatorParams& actuator, const plant::LoadParams& load);

/// Valve current (A) of a tick: white noise, uniform, or else 5 and 10 Hz with half the amplitude each (Fig. C.1), within
/// +-`opening` of the nominal current.
double valve_signal(bool rich, double opening, std::uint64_t seed, Tick tick);

/// 6.3.1: m_l = 1 / A(2, 3) of the continuous model (3.47), so of the principal log(a) / T; kg. Infinite where there is
/// none.
double load_mass_kg(const Eigen::Matrix3d& a);

/// A tick of a joint: states relative to home (m, m/s, N) without noise, and the current from then on (A).
struct CycleSample {
  Eigen::Vector3d state;
  double current_A;
};

/// From rest at home through `loads`, kSectionTicks each, the valve under valve_signal.
std::vector<CycleSample> drive(std::span<const plant::LoadParams> loads, bool rich, double opening, std::uint64_t seed);

/// Least squares (6.21) as 6.3 runs it: the operating point subtracted, normalised, nothing filtered, from the model of
/// kStartLoad_kg. The model after each sample, SI. `forgetting_factor` in (0, 1].
///
/// The text does not give the first covariance, on which the memory of the start depends. It is 0.14 I here, so that
/// the mass of Fig. 6.7 takes the 90 ms of lambda 0.9. The other lambdas of that figure, and the sections after the
/// first, do not follow from it.
std::vector<control::DiscreteModel> identify(std::span<const CycleSample> samples, double forgetting_factor);

}  // namespace farrier::thesis
