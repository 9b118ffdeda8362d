#include "thesis/rig/table_6_1.hpp"

#include <Eigen/Core>

#include <algorithm>
#include <cmath>
#include <complex>
#include <limits>
#include <memory>
#include <numbers>

#include "control/model/transfer_function.hpp"
#include "core/noise.hpp"
#include "estimation/grey_box_estimator.hpp"
#include "estimation/joint_estimator.hpp"
#include "thesis/rig/walking_cycle.hpp"
#include "plant/nominal.hpp"

namespace farrier::thesis {
namespace {

using estimation::EstimationMethod;
using estimation::Estimator;
using Complex = std::complex<double>;

constexpr Tick kJudgedAfter = 60;
constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// F_s / i_v = [0 0 1] (z I - A)^-1 B
Complex force_response(const control::DiscreteModel& model, double frequency_Hz) {
  return control::response<3>({model.a, model.b, Eigen::RowVector3d(0.0, 0.0, 1.0), 0.0, kCyclePeriod_s}, frequency_Hz);
}

struct Method {
  const char* name;
  EstimationMethod method;
  double valve_gain = 1.0, bulk_modulus = 1.0;  ///< the actuator it is given, as factors of the truth
  double uncertainty = 0.0;                     ///< of ln K_v and ln beta_e; 0: taken as known
};

constexpr Method kMethods[] = {{"rls", EstimationMethod::kRls},
                               {"aff", EstimationMethod::kAff},
                               {"greybox", EstimationMethod::kGreyBox},
                               {"greybox_wrong", EstimationMethod::kGreyBox, kWrongValveGain, kWrongBulkModulus},
                               {"greybox_finds", EstimationMethod::kGreyBox, kWrongValveGain, kWrongBulkModulus, 0.2}};

Result<std::unique_ptr<Estimator>> make(const Method& method, const estimation::JointScales& scales) {
  estimation::EstimatorParams params;
  params.method = method.method;
  if (method.method == EstimationMethod::kGreyBox) {
    plant::ActuatorParams actuator = plant::nominal_cylinder();
    actuator.valve_gain *= method.valve_gain;
    actuator.bulk_modulus_Pa *= method.bulk_modulus;
    params.grey_box.emplace();
    params.grey_box->valve_gain_uncertainty = method.uncertainty;
    params.grey_box->bulk_modulus_uncertainty = method.uncertainty;
    auto made = FARRIER_TRY(
        estimation::GreyBoxEstimator::create(params, scales, actuator, {walking_cycle()[2], walking_cycle()[1]}));
    return std::unique_ptr<Estimator>(std::make_unique<estimation::GreyBoxEstimator>(std::move(made)));
  }
  params.forgetting_factor = 0.85;
  params.bias = false;
  params.operating_point_order = 0;
  params.full_weight_norm = 1e6;
  const control::DiscreteModel prior = cycle_model_of(plant::nominal_cylinder(), walking_cycle()[0]);
  auto made = FARRIER_TRY(estimation::JointEstimator::create(params, scales, prior.a, prior.b));
  return std::unique_ptr<Estimator>(std::make_unique<estimation::JointEstimator>(std::move(made)));
}

void judge(const estimation::ModelEstimate& estimate, const plant::LoadParams& truth, std::size_t change,
           Table61Cell& cell) {
  control::DiscreteModel model{estimate.a, estimate.b};
  double mass = 0.0;
  if (estimate.has_physics) {
    // At the point and signs where the truth is linearised.
    plant::ActuatorParams actuator = plant::nominal_cylinder();
    actuator.valve_gain = estimate.physics.valve_gain;
    actuator.bulk_modulus_Pa = estimate.physics.bulk_modulus;
    plant::LoadParams known = cycle_load(estimate.physics.load_mass, estimate.physics.damping);
    known.stiffness = estimate.physics.stiffness;
    model = cycle_model_of(actuator, known);
    mass = known.mass;
  } else {
    mass = load_mass_kg(estimate.a);
  }
  const control::DiscreteModel true_model = cycle_model_of(plant::nominal_cylinder(), truth);
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

Result<Done> run(const Method& method, std::uint64_t seed, Table61Cell& cell) {
  const Eigen::Vector3d noise = cell.noisy ? Eigen::Vector3d(2e-6, 1.5e-3, 1.0) : Eigen::Vector3d::Zero();
  auto estimator = make(method, {.state = {0.04, 1.2, 5000.0},
                                 .current_A = plant::kNominalCurrent_A,
                                 .sensor_noise = noise,
                                 .home_position = kCycleHome_m,
                                 .period_s = kCyclePeriod_s,
                                 .input_delay_ticks = 0});
  if (!estimator) {
    return estimator.error();
  }
  const NoiseStream sensors[] = {{seed, "table 6.1", "x"}, {seed, "table 6.1", "v"}, {seed, "table 6.1", "F"}};
  const std::vector<CycleSample> samples =
      drive(walking_cycle(), cell.rich, cell.high ? kFullOpening : kSmallOpening, seed);
  for (Tick k = 0; k < static_cast<Tick>(samples.size()); ++k) {
    const auto& [state, current_A] = samples[static_cast<std::size_t>(k)];
    const auto section = static_cast<std::size_t>(k / kSectionTicks);
    estimation::JointSample sample{.tick = k, .state = state, .current_A = current_A, .phase = 0};
    sample.state(0) += kCycleHome_m;
    for (int i = 0; i < 3; ++i) {
      sample.state(i) += noise(i) * sensors[i].normal(k);
    }
    estimator.value()->take(sample);
    if (section > 0 && k % kSectionTicks == kJudgedAfter) {
      judge(estimator.value()->estimate(), walking_cycle()[section], section - 1, cell);
    }
  }
  return Done{};
}

}  // namespace

Result<std::vector<Table61Cell>> table_6_1(std::uint64_t seed) {
  std::vector<Table61Cell> cells;
  for (const Method& method : kMethods) {
    for (const bool noisy : {false, true}) {
      for (const bool rich : {false, true}) {
        for (const bool high : {false, true}) {
          Table61Cell cell{.method = method.name,
                           .rich = rich,
                           .high = high,
                           .noisy = noisy,
                           .gain_error_dB = {},
                           .phase_error_deg = {},
                           .mass_error = {}};
          FARRIER_TRY(run(method, seed, cell));
          cells.push_back(cell);
        }
      }
    }
  }
  return cells;
}

}  // namespace farrier::thesis
