#include "thesis/rig/rig_estimates.hpp"

#include <algorithm>
#include <cmath>

#include "estimation/excitation_gate.hpp"
#include "estimation/linear_regression.hpp"
#include "robot/joint_model.hpp"

namespace farrier::thesis {
namespace {

using estimation::EstimationMethod;
using estimation::GateKind;

constexpr int kColumns = 4;  // x, v, F, u
/// c_1 of (9.1), (9.3), which 9.1.1 calls a tuning factor: the smallest power of two with which the factors of Fig. 9.3
/// "remain largely at 1" (0.95 and more). With 1 the force's falls to 0.90, with 16 none leaves 1.
constexpr double kNoiseFactor = 4.0;

/// A current answered by a force of its own size, with the memory of a tick: phase zero, no resonance.
control::DiscreteModel wrong_model() { return {0.5 * Eigen::Matrix3d::Identity(), Eigen::Vector3d(0.0, 0.0, 0.5)}; }

template <class Engine>
control::DiscreteModel model_of(const Engine& engine) {
  const auto& theta = engine.parameters();
  return {theta.template leftCols<3>(), theta.col(3)};
}

void learn(estimation::LinearRegression& regression, const RigTrace& trace, const Eigen::Vector3d& scale,
           double current_max_A, estimation::ExcitationGate& gate, const estimation::EstimatorParams& params,
           ChirpEstimates& out) {
  // The gates' own figures: what they look at is not asked of the gate that decides.
  estimation::PersistenceGate persistence(params.pe.value_or(estimation::PersistenceParams{}), kColumns);
  estimation::SpectrumGate spectrum(params.fft.value_or(estimation::SpectrumParams{}), kColumns);
  const auto signal_at = [&](std::size_t i) {
    return Eigen::Vector4d(trace.measured_position_m[i] / scale(0), trace.measured_velocity_m_s[i] / scale(1),
                           trace.measured_force_N[i] / scale(2), trace.current_A[i] / current_max_A);
  };
  const auto each = static_cast<std::size_t>(std::llround(kModel_s / trace.period_s));
  for (std::size_t i = 1; i < trace.time_s.size(); ++i) {
    const Eigen::Vector4d h = signal_at(i - 1);
    const Eigen::Vector3d y = signal_at(i).head<3>();
    gate.observe(h);
    const bool open = gate.open();
    Eigen::Vector3d error, lambda;
    std::visit(
        [&](auto& engine) {
          if constexpr (std::decay_t<decltype(engine)>::kSize == kColumns) {
            error = y - engine.parameters() * h;
            if (open) {
              estimation::teach(engine, 1.0, h, y, h);
            }
            lambda = engine.forgetting();
            if (i % each == 0) {
              out.time_s.push_back(trace.time_s[i]);
              out.models.push_back(model_of(engine));
              out.learning.push_back(open);
            }
          }
        },
        regression);
    out.tick_s.push_back(trace.time_s[i]);
    out.forgetting.push_back(open ? lambda : Eigen::Vector3d::Ones());
    out.error.push_back(error);
    out.open.push_back(open);
    if (params.gate == GateKind::kPe) {
      persistence.observe(h);
      out.singular_values.push_back(persistence.singular_values());
    } else if (params.gate == GateKind::kFft) {
      spectrum.observe(h);
      out.frequencies.push_back(spectrum.frequencies());
    }
  }
}

}  // namespace

ChirpCase weighted_chirp(double added_kg, GateKind gate) {
  return {.amplitude = 0.2, .added_kg = added_kg, .gate = gate, .frequencies_min = 24};
}

estimation::EstimatorParams params_of(const ChirpCase& one) {
  const double size = one.amplitude / 0.1;
  estimation::EstimatorParams params;
  params.method = one.method;
  params.gate = one.gate;
  params.forgetting_factor = 0.92;  // Fig. 9.1
  params.bias = false;
  params.position = true;
  params.initial_covariance = one.initial_covariance;
  params.covariance_limit = 1e9;
  params.aff = estimation::AdaptiveForgettingParams{.noise_factor = kNoiseFactor};
  params.pe = estimation::PersistenceParams{
      .window_ticks = 400, .information_min = 1e-4 * size * size, .information_max = 7.0 * size * size};
  params.fft = estimation::SpectrumParams{
      .window_ticks = 512, .magnitude_min = 3e-3 * size, .frequencies_min = one.frequencies_min};
  return params;
}

Result<ChirpEstimates> estimate_chirp(const robot::Robot& rig, const ChirpCase& one, std::uint64_t seed) {
  const robot::Joint& joint = rig.joints[0];
  const control::Normalisation& n = joint.normalisation;
  const auto trace = FARRIER_TRY(drive(rig,
                                       {.current_A = chirp(one.amplitude * n.current_A, kChirp_Hz, kChirp_s),
                                        .duration_s = kChirp_s,
                                        .added_kg = one.added_kg,
                                        .position_m = kStart_m},
                                       seed));
  const estimation::EstimatorParams params = params_of(one);
  const Eigen::Vector3d scale(n.position, n.velocity, n.force);
  const Eigen::Vector3d noise(joint.noise.position, joint.noise.velocity, joint.noise.force);
  ChirpEstimates out;
  out.period_s = rig.period_s;
  out.first = wrong_model();
  plant::LoadParams load = joint.swing_load;
  load.mass += one.added_kg;
  out.nominal = control::normalise(robot::model_of(joint, load, rig.period_s), n);
  auto regression =
      estimation::make_regression(params, noise.cwiseQuotient(scale).cwiseAbs2(), out.first.a, out.first.b);
  if (!regression) {
    return regression.error();
  }
  auto gate = FARRIER_TRY(estimation::ExcitationGate::create(params));
  learn(regression.value(), trace, scale, n.current_A, gate, params, out);
  return out;
}

}  // namespace farrier::thesis
