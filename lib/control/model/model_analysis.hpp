#pragma once

#include <array>
#include <complex>
#include <cstdint>
#include <span>
#include <vector>

#include "control/model/transfer_function.hpp"
#include "plant/linear_model.hpp"

namespace farrier::control {

// The joint's linear models as functions of operating point and load: the data of Hubacher (2014), Section 4.3.

/// From valve current (A) to `output` (SI) of one of the three linear models. The load-cell model is the thesis's
/// (3.51), which neglects the piston's mass; designs use the exact one.
SingleInOut<3> load_cell_system(const plant::ActuatorParams& actuator, const plant::LoadParams& load,
                                const plant::OperatingPoint& point, plant::Output output,
                                plant::Volumes volumes = plant::Volumes::kMoving);
SingleInOut<3> load_pressure_system(const plant::ActuatorParams& actuator, const plant::LoadParams& load,
                                    const plant::OperatingPoint& point, plant::Output output,
                                    plant::Volumes volumes = plant::Volumes::kMoving);
SingleInOut<4> full_system(const plant::ActuatorParams& actuator, const plant::LoadParams& load,
                           const plant::ChamberPoint& point, plant::Output output,
                           plant::Volumes volumes = plant::Volumes::kMoving);

/// The system sampled with the input held over `period_s` > 0; system.period_s must be 0 (checked invariant).
template <int N>
SingleInOut<N> sampled(const SingleInOut<N>& system, double period_s);

/// Points of Section 4.3.1, drawn by (seed, number): position, velocity, load pressure and valve current each uniform
/// between 10 % and 190 % of its nominal value, counted from the lower end of its range. Ranges: the stroke;
/// +-`velocity_range`; +-(alpha p_s - p_t), the load pressures possible with both signs of the valve; +-the full
/// current. The nominal values, the middles, are those of Chapter 3. The sign of the valve is the current's.
std::vector<plant::OperatingPoint> operating_points(const plant::ActuatorParams& actuator, double velocity_range,
                                                    int count, std::uint64_t seed);

/// Response of the load-cell force at each point, one row per point.
std::vector<std::vector<std::complex<double>>> responses_at_points(const plant::ActuatorParams& actuator,
                                                                   const plant::LoadParams& load,
                                                                   std::span<const plant::OperatingPoint> points,
                                                                   std::span<const double> frequencies_Hz);

/// Parameters that Section 4.3.2 varies, with their ranges.
enum class LoadParameter { kMass, kDamping, kStiffness };
struct Range {
  double low;
  double high;
};
inline constexpr Range kMassRange_kg{1.0, 127.0};
inline constexpr Range kDampingRange_Ns_m{0.0, 2000.0};
inline constexpr Range kStiffnessRange_N_m{10.0, 35000.0};

/// The load with one parameter set to `value` (SI).
plant::LoadParams with(plant::LoadParams load, LoadParameter parameter, double value) noexcept;

/// Response of the load-cell force with the parameter at each value, one row per value: Figs 4.8, 4.9, A.2.
std::vector<std::vector<std::complex<double>>> responses_to_load(
    const plant::ActuatorParams& actuator, const plant::LoadParams& load, const plant::OperatingPoint& point,
    LoadParameter parameter, std::span<const double> values, std::span<const double> frequencies_Hz);

struct PolesOfLoad {
  double mass;
  double damping;
  std::array<std::complex<double>, 3> poles;  ///< of the sampled load-cell model, in the order of poles()
};

/// Every mass with every damping, masses outermost: Fig. 4.10 (period 1 ms).
std::vector<PolesOfLoad> pole_loci(const plant::ActuatorParams& actuator, const plant::LoadParams& load,
                                   const plant::OperatingPoint& point, std::span<const double> masses,
                                   std::span<const double> dampings, double period_s);

}  // namespace farrier::control
