#include "thesis/rig/walking_cycle.hpp"

#include <Eigen/Eigenvalues>
#include <Eigen/LU>

#include <cmath>
#include <complex>
#include <limits>
#include <numbers>

#include "core/ensure.hpp"
#include "core/noise.hpp"
#include "estimation/rls.hpp"
#include "plant/hydraulic_joint.hpp"
#include "plant/nominal.hpp"

namespace farrier::thesis {
namespace {

constexpr double kFirstCovariance = 0.14;

const Eigen::Vector3d& divisors() {
  static const Eigen::Vector3d of_states(0.5 * plant::nominal_cylinder().stroke, plant::kNominalVelocity_m_s,
                                         plant::kNominalForce_N);
  return of_states;
}

}  // namespace

plant::LoadParams cycle_load(double mass_kg, double damping_Ns_m) {
  plant::LoadParams load = plant::nominal_load();
  load.mass = mass_kg;
  load.damping = damping_Ns_m;
  return load;
}

const std::array<plant::LoadParams, 4>& walking_cycle() {
  static const std::array<plant::LoadParams, 4> of_fig_6_1 = {cycle_load(kStartLoad_kg), cycle_load(kHeavyLoad_kg),
                                                              cycle_load(1.05), cycle_load(2.1, 3500.0)};
  return of_fig_6_1;
}

control::DiscreteModel cycle_model_of(const plant::ActuatorParams& actuator, const plant::LoadParams& load) {
  const plant::LinearModel model = plant::linearise_load_cell_force(actuator, load, {.position = kCycleHome_m});
  return control::discretise(model.a, model.b, kCyclePeriod_s);
}

double valve_signal(bool rich, double opening, std::uint64_t seed, Tick tick) {
  const double amplitude = opening * plant::kNominalCurrent_A;
  if (rich) {
    return amplitude * (2.0 * NoiseStream(seed, "table 6.1", "valve").uniform(tick) - 1.0);
  }
  const double turn = 2.0 * std::numbers::pi * kCyclePeriod_s * static_cast<double>(tick);
  return 0.5 * amplitude * (std::sin(5.0 * turn) + std::sin(10.0 * turn));
}

double load_mass_kg(const Eigen::Matrix3d& a) {
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  if (!a.allFinite()) {
    return kInfinity;
  }
  const Eigen::EigenSolver<Eigen::Matrix3d> solver(a);
  const Eigen::Vector3cd logs = solver.eigenvalues().array().log();
  const Eigen::Matrix3cd v = solver.eigenvectors();
  const double rate = (v * logs.asDiagonal() * v.inverse())(1, 2).real() / kCyclePeriod_s;
  return std::isfinite(rate) && rate != 0.0 ? 1.0 / rate : kInfinity;
}

std::vector<CycleSample> drive(std::span<const plant::LoadParams> loads, bool rich, double opening, std::uint64_t seed) {
  const plant::ActuatorParams cylinder = plant::nominal_cylinder();
  FARRIER_ENSURE(!loads.empty(), "a cycle needs a load");
  auto joint = plant::HydraulicJoint::create(cylinder, loads.front(),
                                             plant::equilibrium(cylinder, loads.front(), kCycleHome_m, 0.0));
  FARRIER_ENSURE(joint.ok(), "the nominal joint can be built");
  std::vector<CycleSample> samples;
  for (Tick k = 0; k < static_cast<Tick>(loads.size()) * kSectionTicks; ++k) {
    if (k % kSectionTicks == 0) {
      FARRIER_ENSURE(joint.value().set_load(loads[static_cast<std::size_t>(k / kSectionTicks)]), "a load a joint can bear");
    }
    const plant::State& state = joint.value().state();
    samples.push_back({{state.position - kCycleHome_m, state.velocity, joint.value().load_cell_force()},
                       valve_signal(rich, opening, seed, k)});
    joint.value().step(samples.back().current_A, 0.0, kCyclePeriod_s);
  }
  return samples;
}

std::vector<control::DiscreteModel> identify(std::span<const CycleSample> samples, double forgetting_factor) {
  const Eigen::DiagonalMatrix<double, 3> unit(divisors());
  const control::DiscreteModel start = cycle_model_of(plant::nominal_cylinder(), cycle_load(kStartLoad_kg));
  Eigen::Matrix<double, 3, 4> theta;  // (3.52), (3.53)
  theta << unit.inverse() * start.a * unit, unit.inverse() * start.b * plant::kNominalCurrent_A;
  auto made = estimation::Rls<4>::create({.forgetting_factor = forgetting_factor,
                                          .initial_covariance = kFirstCovariance,
                                          .covariance_limit = 1e40,
                                          .regressor_min = 0.0}, theta);
  FARRIER_ENSURE(made.ok(), "a forgetting factor in (0, 1]");
  std::vector<control::DiscreteModel> models;
  for (std::size_t k = 0; k < samples.size(); ++k) {
    if (k > 0) {
      Eigen::Vector4d h;
      h << samples[k - 1].state.cwiseQuotient(divisors()), samples[k - 1].current_A / plant::kNominalCurrent_A;
      made.value().update(h, samples[k].state.cwiseQuotient(divisors()));
    }
    theta = made.value().parameters();
    models.push_back({unit * theta.leftCols<3>() * unit.inverse(), unit * theta.col(3) / plant::kNominalCurrent_A});
  }
  return models;
}

}  // namespace farrier::thesis
