// Hubacher (2014), 6.3.1 and 6.3.3: the sampling rate, and the forgetting factor once there is noise.

#include <Eigen/QR>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "core/noise.hpp"
#include "plant/hydraulic_joint.hpp"
#include "plant/nominal.hpp"
#include "thesis/rig/cycle_estimates.hpp"
#include "thesis/studies/registry.hpp"

namespace farrier::thesis {
namespace section6_sampling_studies {
namespace {

constexpr double kLightLoad_kg = 1.05;  // the third section of Fig. 6.1
constexpr double kLength_s = 0.25;
constexpr std::uint64_t kRuns = 9;

constexpr ClaimSpec kClaims[] = {
    fails("samples of a held input and the whole state do not alias (docs/errata.md, 6.3.1), and the error left is the "
          "plant's nonlinearity, "
          "which a run of 0.25 s shows as well at either rate",
          {"S6.3.sampling", "6.3.1",
           "Hence, doubling the current sampling frequency of 1000 Hz might improve the estimation performance in "
           "general.",
           "Median error of the magnitude, 1 to 450 Hz, of least squares on 0.25 s of white noise at 1.05 kg, sampled "
           "at 2 kHz over that at "
           "1 kHz: below 1.",
           "1", Relation::kBelow, 1.0}),
    {"S6.3.noise_needs_memory", "6.3.3",
     "... the forgetting factor needs to be increased in order to reduce the influence of the noise ...",
     "Mean error after a change to 105 kg, noise of fc1d.yaml, with 0.9 over that with 0.8: below 1.", "1",
     Relation::kBelow, 1.0},
    {"S6.3.compromise", "6.3.3", "... a good compromise was found by using a forgetting factor of 0.9.",
     "The same with 0.9 over the least with 0.8, 0.85 and 0.98: 1.1.", "1", Relation::kAtMost, 1.1}};

/// Median error in dB of a model by least squares on one run whose current is white noise, held for a sample.
double sampled_error_dB(double period_s, std::uint64_t seed) {
  const plant::ActuatorParams cylinder = plant::nominal_cylinder();
  const plant::LoadParams load = cycle_load(kLightLoad_kg);
  auto joint = plant::HydraulicJoint::create(cylinder, load, plant::equilibrium(cylinder, load, kCycleHome_m, 0.0));
  if (!joint) {
    return std::nan("");
  }
  plant::HydraulicJoint plant = std::move(joint).value();
  const NoiseStream stream(seed, "S6.3", "current");
  const auto ticks = static_cast<Eigen::Index>(std::llround(kLength_s / period_s));
  const Eigen::Vector3d scale(0.5 * cylinder.stroke, plant::kNominalVelocity_m_s, plant::kNominalForce_N);
  Eigen::MatrixXd regressors(ticks, 4), answers(ticks, 3);
  const auto state = [&]() -> Eigen::Vector3d {
    return Eigen::Vector3d(plant.state().position - kCycleHome_m, plant.state().velocity, plant.load_cell_force())
        .cwiseQuotient(scale);
  };
  for (Eigen::Index i = 0; i < ticks; ++i) {
    const double share = kSmallOpening * (2.0 * stream.uniform(static_cast<Tick>(i)) - 1.0);
    regressors.row(i) << state().transpose(), share;
    plant.step(share * cylinder.valve_current_max_A, 0.0, period_s);
    answers.row(i) = state().transpose();
  }
  const Eigen::MatrixXd theta = regressors.colPivHouseholderQr().solve(answers);
  control::SingleInOut<3> model{theta.topRows(3).transpose(), theta.row(3).transpose(), Eigen::RowVector3d::UnitZ(),
                                0.0, period_s};
  const auto truth = control::sampled(
      control::load_cell_system(cylinder, load, plant::nominal_point(0.0), plant::Output::kLoadCellForce), period_s);
  const double factor = cylinder.valve_current_max_A / plant::kNominalForce_N;
  std::vector<double> errors;
  for (const double f : log_space(1.0, 450.0, 60)) {
    errors.push_back(std::abs(control::decibel(control::response<3>(model, f)) -
                              control::decibel(factor * control::response<3>(truth, f))));
  }
  return median(std::move(errors));
}

/// Mean error in dB from 60 ms after a change to 105 kg on, behind the noise of fc1d.yaml; median of nine runs.
double noisy_error_dB(const StudyContext& context, double forgetting) {
  constexpr std::array kNoise{2e-6, 1.5e-3, 1.0};
  const std::array loads{cycle_load(kHeavyLoad_kg)};
  std::vector<double> errors;
  for (std::uint64_t run = 0; run < kRuns; ++run) {
    const std::uint64_t seed = context.seed + run;
    std::vector<CycleSample> samples = drive(loads, true, kSmallOpening, seed);
    const NoiseStream stream(seed, "S6.3", "sensors");
    for (std::size_t i = 0; i < samples.size(); ++i) {
      for (int row = 0; row < 3; ++row) {
        samples[i].state(row) += kNoise[static_cast<std::size_t>(row)] * stream.normal(static_cast<Tick>(3 * i) + row);
      }
    }
    errors.push_back(CycleEstimates(samples, loads, forgetting).settled_error_dB());
  }
  return median(std::move(errors));
}

Result<StudyResult> run(const StudyContext& context) {
  std::vector<double> once, twice;
  for (std::uint64_t run = 0; run < kRuns; ++run) {
    once.push_back(sampled_error_dB(1e-3, context.seed + run));
    twice.push_back(sampled_error_dB(0.5e-3, context.seed + run));
  }
  const double at_1_kHz = median(std::move(once)), at_2_kHz = median(std::move(twice));
  constexpr std::array kForgetting{0.8, 0.85, 0.9, 0.98};
  Series series{"", {}, {}, Style::kPoints, 1};
  std::string text = "by lambda:";
  for (const double forgetting : kForgetting) {
    series.x.push_back(forgetting);
    series.y.push_back(noisy_error_dB(context, forgetting));
    text += number_as(" %.2f dB", series.y.back());
  }
  const std::vector<double> errors = series.y;
  StudyResult result;
  result.measured = {
      {"S6.3.sampling", at_2_kHz / at_1_kHz, number_as("%.2f dB, ", at_2_kHz) + number_as("%.2f dB", at_1_kHz)},
      {"S6.3.noise_needs_memory", errors[2] / errors[0], text},
      {"S6.3.compromise", errors[2] / std::min({errors[0], errors[1], errors[3]}), ""}};
  result.pictures = {
      {"Error of least squares with the noise of fc1d.yaml after a change to 105 kg",
       1,
       {{.title = "", .x_label = "forgetting factor", .y_label = "mean error (dB)", .series = {std::move(series)}}}}};
  return result;
}

constexpr Study kStudies[] = {{"S6.3", "Sampling rate and forgetting with noise", kClaims, run,
                               "Joint of Table A.1, white noise of 5 % at the valve, no sensor noise at 1.05 kg, noise "
                               "of fc1d.yaml at 105 kg; medians of nine runs."}};

}  // namespace
}  // namespace section6_sampling_studies

std::span<const Study> section6_sampling() { return section6_sampling_studies::kStudies; }

}  // namespace farrier::thesis
