#include "lab/table_6_1.hpp"

#include <Eigen/Core>
#include <Eigen/Eigenvalues>
#include <Eigen/LU>

#include <algorithm>
#include <cmath>
#include <complex>
#include <limits>
#include <memory>
#include <numbers>

#include "control/discretise.hpp"
#include "core/noise.hpp"
#include "estimation/grey_box_estimator.hpp"
#include "estimation/joint_estimator.hpp"
#include "plant/hydraulic_joint.hpp"
#include "plant/linear_model.hpp"

namespace farrier::lab {
namespace {

using estimation::EstimationMethod;
using estimation::Estimator;
using Complex = std::complex<double>;

constexpr double kPeriod_s = 1e-3;
constexpr Tick kSectionTicks = 250;
constexpr Tick kJudgedAfter = 60;
constexpr double kHome_m = 0.04;
constexpr double kNominal_A = 0.01;
constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// Table A.1; end stops as in fc1d.yaml.
plant::ActuatorParams cylinder() {
  plant::ActuatorParams act;
  act.area_a = 2.0106e-4;
  act.area_b = 1.2252e-4;
  act.stroke = 0.08;
  act.line_volume_m3 = 3.4023e-6;
  act.bulk_modulus_Pa = 1.3e9;
  act.valve_gain = 6.6815e-6;
  act.valve_current_max_A = kNominal_A;
  act.supply_pressure_Pa = 250e5;
  act.piston_mass = 0.3141;
  act.piston_damping = 700;
  act.stop_stiffness = 2e7;
  act.stop_damping = 1e4;
  return act;
}

plant::LoadParams load(double mass_kg, double damping_Ns_m = 700.0) {
  return {.mass = mass_kg, .damping = damping_Ns_m, .stiffness = 2 * 10740.0, .equilibrium_position = kHome_m};
}

const std::array<plant::LoadParams, 4>& sections() {
  static const std::array<plant::LoadParams, 4> of_fig_6_1 = {load(10.5), load(105.0), load(1.05), load(2.1, 3500.0)};
  return of_fig_6_1;
}

control::DiscreteModel sampled(const plant::ActuatorParams& actuator, const plant::LoadParams& at) {
  const auto model = plant::linearise_load_cell_force(actuator, at, {.position = kHome_m});
  return control::discretise(model.a, model.b, kPeriod_s);
}

/// F_s / i_v = [0 0 1] (z I - A)^-1 B
Complex force_response(const control::DiscreteModel& model, double frequency_Hz) {
  const Complex z = std::polar(1.0, 2.0 * std::numbers::pi * frequency_Hz * kPeriod_s);
  const Eigen::Matrix3cd m = Eigen::Matrix3cd::Identity() * z - model.a.cast<Complex>();
  return (m.inverse() * model.b.cast<Complex>())(2);
}

/// 6.3.1: m_l = 1 / A(2, 3) of the continuous model (3.47), so of log(A) / T.
double mass_of(const Eigen::Matrix3d& a) {
  if (!a.allFinite()) {
    return kInfinity;
  }
  const Eigen::EigenSolver<Eigen::Matrix3d> solver(a);
  const Eigen::Vector3cd logs = solver.eigenvalues().array().log();
  const Eigen::Matrix3cd v = solver.eigenvectors();
  const double rate = (v * logs.asDiagonal() * v.inverse())(1, 2).real() / kPeriod_s;
  return std::isfinite(rate) && rate != 0.0 ? 1.0 / rate : kInfinity;
}

Result<std::unique_ptr<Estimator>> make(EstimationMethod method, const estimation::JointScales& scales) {
  estimation::EstimatorParams params;
  params.method = method;
  if (method == EstimationMethod::kGreyBox) {
    auto made = estimation::GreyBoxEstimator::create(params, scales, cylinder(), {load(1.05), load(105.0)});
    if (!made) {
      return made.error();
    }
    return std::unique_ptr<Estimator>(std::make_unique<estimation::GreyBoxEstimator>(std::move(made).value()));
  }
  params.forgetting_factor = 0.85;
  params.bias = false;
  params.operating_point_order = 0;
  params.full_weight_norm = 1e6;
  const control::DiscreteModel prior = sampled(cylinder(), sections()[0]);
  auto made = estimation::JointEstimator::create(params, scales, prior.a, prior.b);
  if (!made) {
    return made.error();
  }
  return std::unique_ptr<Estimator>(std::make_unique<estimation::JointEstimator>(std::move(made).value()));
}

void judge(const estimation::ModelEstimate& estimate, const plant::LoadParams& truth, std::size_t change,
           Table61Cell& cell) {
  control::DiscreteModel model{estimate.a, estimate.b};
  double mass = 0.0;
  if (estimate.has_physics) {
    // At the point and signs where the truth is linearised.
    plant::ActuatorParams actuator = cylinder();
    actuator.valve_gain = estimate.physics.valve_gain;
    actuator.bulk_modulus_Pa = estimate.physics.bulk_modulus;
    plant::LoadParams known = load(estimate.physics.load_mass, estimate.physics.damping);
    known.stiffness = estimate.physics.stiffness;
    model = sampled(actuator, known);
    mass = known.mass;
  } else {
    mass = mass_of(estimate.a);
  }
  const control::DiscreteModel true_model = sampled(cylinder(), truth);
  double gain = 0.0, phase = 0.0;
  for (double f = 0.5; f <= 100.0; f *= 1.05) {
    const Complex ratio = force_response(model, f) / force_response(true_model, f);
    const double dB = std::abs(20.0 * std::log10(std::abs(ratio)));
    gain = std::isfinite(dB) ? std::max(gain, dB) : kInfinity;
    phase = std::max(phase, std::abs(std::arg(ratio)) * 180.0 / std::numbers::pi);
  }
  cell.gain_error_dB[change] = gain;
  cell.phase_error_deg[change] = phase;
  cell.mass_error[change] = std::abs(mass / truth.mass - 1.0);
}

double valve_current(const Table61Cell& cell, std::uint64_t seed, Tick tick) {
  const double amplitude = (cell.high ? 1.0 : 0.05) * kNominal_A;
  if (cell.rich) {
    return amplitude * (2.0 * NoiseStream(seed, "table 6.1", "valve").uniform(tick) - 1.0);
  }
  const double turn = 2.0 * std::numbers::pi * kPeriod_s * static_cast<double>(tick);
  return 0.5 * amplitude * (std::sin(5.0 * turn) + std::sin(10.0 * turn));
}

Result<Done> run(EstimationMethod method, std::uint64_t seed, Table61Cell& cell) {
  const Eigen::Vector3d noise = cell.noisy ? Eigen::Vector3d(2e-6, 1.5e-3, 1.0) : Eigen::Vector3d::Zero();
  auto estimator = make(method, {.state = {0.04, 1.2, 5000.0},
                                 .current_A = kNominal_A,
                                 .sensor_noise = noise,
                                 .home_position = kHome_m,
                                 .period_s = kPeriod_s,
                                 .input_delay_ticks = 0});
  auto joint = plant::HydraulicJoint::create(cylinder(), sections()[0],
                                             plant::equilibrium(cylinder(), sections()[0], kHome_m, 0.0));
  if (!estimator) {
    return estimator.error();
  }
  if (!joint) {
    return joint.error();
  }
  const NoiseStream sensors[] = {{seed, "table 6.1", "x"}, {seed, "table 6.1", "v"}, {seed, "table 6.1", "F"}};
  for (Tick k = 0; k < 4 * kSectionTicks; ++k) {
    const auto section = static_cast<std::size_t>(k / kSectionTicks);
    if (k % kSectionTicks == 0 && !joint.value().set_load(sections()[section])) {
      return Error{"table 6.1: a load was refused"};
    }
    estimation::JointSample sample{.tick = k, .state = {}, .current_A = valve_current(cell, seed, k), .phase = 0};
    const plant::State& state = joint.value().state();
    sample.state << state.position, state.velocity, joint.value().load_cell_force();
    for (int i = 0; i < 3; ++i) {
      sample.state(i) += noise(i) * sensors[i].normal(k);
    }
    estimator.value()->take(sample);
    if (section > 0 && k % kSectionTicks == kJudgedAfter) {
      judge(estimator.value()->estimate(), sections()[section], section - 1, cell);
    }
    (void)joint.value().step(sample.current_A, 0.0, kPeriod_s);
  }
  return Done{};
}

}  // namespace

Result<std::vector<Table61Cell>> table_6_1(std::uint64_t seed) {
  const std::pair<const char*, EstimationMethod> methods[] = {
      {"rls", EstimationMethod::kRls}, {"aff", EstimationMethod::kAff}, {"greybox", EstimationMethod::kGreyBox}};
  std::vector<Table61Cell> cells;
  for (const auto& [name, method] : methods) {
    for (const bool noisy : {false, true}) {
      for (const bool rich : {false, true}) {
        for (const bool high : {false, true}) {
          Table61Cell cell{.method = name, .rich = rich, .high = high, .noisy = noisy, .gain_error_dB = {},
                           .phase_error_deg = {}, .mass_error = {}};
          if (auto done = run(method, seed, cell); !done) {
            return done.error();
          }
          cells.push_back(cell);
        }
      }
    }
  }
  return cells;
}

}  // namespace farrier::lab
