#include "control/model/model_analysis.hpp"

#include <algorithm>

#include "control/model/discretise.hpp"
#include "core/ensure.hpp"
#include "core/noise.hpp"

namespace farrier::control {
namespace {

using plant::ActuatorParams;
using plant::LoadParams;
using plant::OperatingPoint;
using plant::Output;
using plant::Volumes;

// Section 4.3.1: between 10 % and 190 % of the nominal value.
constexpr double kSmallestShare = 0.1;
constexpr double kLargestShare = 1.9;

template <int N>
SingleInOut<N> system_of(const plant::StateSpace<N>& model, const Eigen::Matrix<double, 1, N>& row) {
  return {model.a, model.b, row};
}

}  // namespace

SingleInOut<3> load_cell_system(const ActuatorParams& actuator, const LoadParams& load, const OperatingPoint& point,
                                Output output, Volumes volumes) {
  constexpr auto kPiston = plant::PistonMass::kNeglected;
  return system_of<3>(linearise_load_cell_force(actuator, load, point, volumes, kPiston),
                      load_cell_output(output, actuator, load, kPiston));
}

SingleInOut<3> load_pressure_system(const ActuatorParams& actuator, const LoadParams& load, const OperatingPoint& point,
                                    Output output, Volumes volumes) {
  return system_of<3>(linearise_load_pressure(actuator, load, point, volumes),
                      load_pressure_output(output, actuator, load));
}

SingleInOut<4> full_system(const ActuatorParams& actuator, const LoadParams& load, const plant::ChamberPoint& point,
                           Output output, Volumes volumes) {
  return system_of<4>(linearise_full(actuator, load, point, volumes), full_output(output, actuator, load));
}

template <int N>
SingleInOut<N> sampled(const SingleInOut<N>& system, double period_s) {
  FARRIER_ENSURE(system.period_s == 0.0, "only a continuous system can be sampled");
  const SampledModel<N> model = discretise<N>(plant::StateSpace<N>{system.a, system.b}, period_s);
  return {model.a, model.b, system.c, system.d, period_s};
}

template SingleInOut<3> sampled<3>(const SingleInOut<3>&, double);
template SingleInOut<4> sampled<4>(const SingleInOut<4>&, double);

std::vector<OperatingPoint> operating_points(const ActuatorParams& actuator, double velocity_range, int count,
                                             std::uint64_t seed) {
  const NoiseStream position(seed, "operating points", "position");
  const NoiseStream velocity(seed, "operating points", "velocity");
  const NoiseStream load_pressure(seed, "operating points", "load pressure");
  const NoiseStream current(seed, "operating points", "valve current");
  // Within (-0.9, 0.9): how far from the middle of its range, in halves of the range.
  const auto deviation = [](const NoiseStream& noise, int i) {
    return kSmallestShare + (kLargestShare - kSmallestShare) * noise.uniform(i) - 1.0;
  };
  const double alpha = actuator.area_b / actuator.area_a;
  const double largest_load_Pa = alpha * actuator.supply_pressure_Pa - actuator.return_pressure_Pa;

  std::vector<OperatingPoint> points;
  points.reserve(static_cast<std::size_t>(count));
  for (int i = 0; i < count; ++i) {
    OperatingPoint point;
    point.position = 0.5 * actuator.stroke * (1.0 + deviation(position, i));
    point.velocity = velocity_range * deviation(velocity, i);
    point.load_pressure_Pa = largest_load_Pa * deviation(load_pressure, i);
    point.valve_current_A = actuator.valve_current_max_A * deviation(current, i);
    point.valve_sign = point.valve_current_A < 0.0 ? -1.0 : 1.0;
    points.push_back(point);
  }
  return points;
}

std::vector<std::vector<std::complex<double>>> responses_at_points(const ActuatorParams& actuator,
                                                                   const LoadParams& load,
                                                                   std::span<const OperatingPoint> points,
                                                                   std::span<const double> frequencies_Hz) {
  std::vector<std::vector<std::complex<double>>> rows;
  rows.reserve(points.size());
  for (const OperatingPoint& point : points) {
    rows.push_back(responses(load_cell_system(actuator, load, point, Output::kLoadCellForce), frequencies_Hz));
  }
  return rows;
}

LoadParams with(LoadParams load, LoadParameter parameter, double value) noexcept {
  switch (parameter) {
    case LoadParameter::kMass:
      load.mass = value;
      break;
    case LoadParameter::kDamping:
      load.damping = value;
      break;
    case LoadParameter::kStiffness:
      load.stiffness = value;
      break;
  }
  return load;
}

std::vector<std::vector<std::complex<double>>> responses_to_load(const ActuatorParams& actuator, const LoadParams& load,
                                                                 const OperatingPoint& point, LoadParameter parameter,
                                                                 std::span<const double> values,
                                                                 std::span<const double> frequencies_Hz) {
  std::vector<std::vector<std::complex<double>>> rows;
  rows.reserve(values.size());
  for (const double value : values) {
    const LoadParams varied = with(load, parameter, value);
    rows.push_back(responses(load_cell_system(actuator, varied, point, Output::kLoadCellForce), frequencies_Hz));
  }
  return rows;
}

std::vector<PolesOfLoad> pole_loci(const ActuatorParams& actuator, const LoadParams& load, const OperatingPoint& point,
                                   std::span<const double> masses, std::span<const double> dampings, double period_s) {
  std::vector<PolesOfLoad> loci;
  loci.reserve(masses.size() * dampings.size());
  for (const double mass : masses) {
    for (const double damping : dampings) {
      const LoadParams varied = with(with(load, LoadParameter::kMass, mass), LoadParameter::kDamping, damping);
      const SmallSpectrum z =
          poles(sampled(load_cell_system(actuator, varied, point, Output::kLoadCellForce), period_s));
      loci.push_back({mass, damping, {z(0), z(1), z(2)}});
    }
  }
  return loci;
}

}  // namespace farrier::control
