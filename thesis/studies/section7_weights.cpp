// Hubacher (2014), 7.2.3 and 8.2.2: the influence of the weights, and of the normalisation on (8.1).

#include <algorithm>
#include <cmath>
#include <numbers>

#include "control/design/lqr.hpp"
#include "control/numerics/riccati.hpp"
#include "robot/joint_model.hpp"
#include "thesis/rig/rig_run.hpp"
#include "thesis/studies/registry.hpp"

namespace farrier::thesis {
namespace section7_weights_studies {
namespace {

constexpr double kRun_s = 2.0, kSettled_s = 0.5, kStep_s = 0.1;
constexpr double kMore = 100.0;  // times the weight

constexpr ClaimSpec kWeightClaims[] = {
    {"S7.2.velocity", "7.2.3",
     "... the velocity of the cylinder is allowed to be increased to give better force tracking.",
     "Tracking error of the multisine with a hundred times the velocity's weight over that with (7.9): 1.25 or more.",
     "1", Relation::kAtLeast, 1.25},
    fails("a tenth and a hundredth of the weight track the multisine better, 0.07 of the reference in place of 0.14: "
          "the integral's weight and "
          "xi then rule the loop. With a thousandth there is no stable loop; a step is tracked alike with all",
          {"S7.2.force", "7.2.3",
           "The weight on the force channel ... is several magnitudes higher ... since we are particularly interested "
           "in good force tracking.",
           "The same with a hundredth of the force's weight: 1.25 or more.", "1", Relation::kAtLeast, 1.25}),
    {"S7.2.input", "7.2.3",
     "... the weight for the input energy was increased with the goal of minimizing the occurrence of controller "
     "outputs reaching the "
     "actuator limits.",
     "Share of 0.2 s after a step of 400 N in which the valve is full open, with a thousand times R over that with "
     "(7.10): 0.75.",
     "1", Relation::kAtMost, 0.75},
    {"S7.2.integrator", "7.2.3",
     "The weighting for the integrator state and its additional gain were tuned to give zero steady-state tracking "
     "error.",
     "Mean error at the end of a step of 400 N, over the step: 0.02.", "1", Relation::kAtMost, 0.02}};

double end_error(const RigTrace& run, double to_N) {
  double sum = 0.0;
  constexpr std::size_t kLast = 200;
  for (std::size_t i = run.force_N.size() - kLast; i < run.force_N.size(); ++i) {
    sum += (to_N - run.force_N[i]) / static_cast<double>(kLast);
  }
  return std::abs(sum / to_N);
}

/// Share of the 0.2 s after the step in which the valve is full open.
double full_open(const RigTrace& run, double nominal_A) {
  double full = 0.0, all = 0.0;
  for (std::size_t i = 0; i < run.time_s.size(); ++i) {
    if (run.time_s[i] >= kStep_s && run.time_s[i] < kStep_s + 0.2) {
      full += std::abs(run.current_A[i]) >= 0.999 * nominal_A ? 1.0 : 0.0;
      all += 1.0;
    }
  }
  return full / all;
}

Result<StudyResult> run_weights(const StudyContext& context) {
  const auto rig = FARRIER_TRY(load(context, "fc1d.yaml"));
  const Signal multisine = [](double t) {
    double sum = 0.0;
    for (const double frequency : {2.0, 5.0, 10.0}) {
      sum += 160.0 / 3.0 * std::sin(2.0 * std::numbers::pi * frequency * t);
    }
    return sum;
  };
  const Signal step = [](double t) { return t < kStep_s ? 0.0 : 400.0; };
  const auto run_with = [&](const Signal& reference, const control::LqrWeights& weights) {
    return track(rig,
                 {.reference = reference,
                  .duration_s = kRun_s,
                  .form = control::Form::kFullState,
                  .feed_forward_factor = 1.0,
                  .weights = weights},
                 context.seed);
  };
  control::LqrWeights still, unforced, dear;
  still.velocity *= kMore;
  unforced.force /= kMore;
  dear.input *= 1000.0;
  const RigTrace usual = FARRIER_TRY(run_with(multisine, {}));
  const RigTrace slow = FARRIER_TRY(run_with(multisine, still));
  const RigTrace weak = FARRIER_TRY(run_with(multisine, unforced));
  const RigTrace cheap_step = FARRIER_TRY(run_with(step, {}));
  const RigTrace dear_step = FARRIER_TRY(run_with(step, dear));
  const double nominal_A = rig.joints[0].normalisation.current_A;
  const double error = tracking_error(usual, kSettled_s, kRun_s);
  StudyResult result;
  result.measured = {
      {"S7.2.velocity", tracking_error(slow, kSettled_s, kRun_s) / error, number_as("with (7.9) %.3f", error)},
      {"S7.2.force", tracking_error(weak, kSettled_s, kRun_s) / error, ""},
      {"S7.2.input", full_open(dear_step, nominal_A) / full_open(cheap_step, nominal_A), ""},
      {"S7.2.integrator", end_error(cheap_step, 400.0), ""}};
  result.pictures = {{"Multisine with (7.9), with a heavy velocity and with a light force",
                      1,
                      {force_panel("(7.9)", usual), force_panel("a hundred times the velocity's weight", slow),
                       force_panel("a hundredth of the force's weight", weak)}}};
  return result;
}

// 8.2.2

constexpr ClaimSpec kNormalisedClaims[] = {
    {"S8.2.normalised", "8.2.2",
     "... using normalization for both the estimator and controller greatly improve the numerical stability of this "
     "iterative approach.",
     "Error of the gain that (8.1) leaves after 1000 steps in SI units, over that with normalised states, the same "
     "weights in both: ten or "
     "more.",
     "1", Relation::kAtLeast, 10.0,
     Refutation{"a change of units is a similarity under which (8.1) goes through the same matrices, and the only "
                "inverse in it is that of "
                "a number, B'SB + R: nothing in it becomes ill-conditioned",
                0.0, 5.0}}};

/// Relative error of the normalised gain after 1000 steps of (8.1) on the model whose states and input are divided by
/// `units`, the weights converted so that the problem is the same.
double iteration_error(const control::DiscreteModel& normalised, const Eigen::Vector4d& units, double input_unit) {
  using Matrix = Eigen::Matrix4d;
  using Row = Eigen::Matrix<double, 1, 4>;
  Matrix a = Matrix::Identity();
  Eigen::Vector4d b = Eigen::Vector4d::Zero();
  a(0, 3) = -1.0;
  a.bottomRightCorner<3, 3>() = normalised.a;
  b.tail<3>() = normalised.b;
  const control::LqrWeights w;
  const Matrix q = Eigen::Vector4d(w.integral, w.position, w.velocity, w.force).asDiagonal();
  const auto exact = control::solve_dare<4>(a, b, q, w.input, Eigen::Vector4d::Zero());
  if (!exact) {
    return std::nan("");
  }
  const Matrix to = units.asDiagonal(), from = units.cwiseInverse().asDiagonal();
  const Matrix scaled_a = to * a * from;
  const Eigen::Vector4d scaled_b = to * b / input_unit;
  const Matrix scaled_q = from * q * from;
  const double r = w.input / (input_unit * input_unit);
  Matrix s = scaled_q;
  constexpr int kSteps = 1000;
  for (int i = 0; i < kSteps; ++i) {
    s += control::riccati_residual<4>(scaled_a, scaled_b, scaled_q, r, Eigen::Vector4d::Zero(), s);
  }
  const Row gain = (scaled_b.transpose() * s * scaled_a) / (scaled_b.dot(s * scaled_b) + r) * to / input_unit;
  return (gain - exact.value().k).norm() / exact.value().k.norm();
}

Result<StudyResult> run_normalised(const StudyContext& context) {
  const auto rig = FARRIER_TRY(load(context, "fc1d.yaml"));
  const robot::Joint& joint = rig.joints[0];
  const control::Normalisation& n = joint.normalisation;
  const control::DiscreteModel model = control::normalise(robot::model_of(joint, joint.swing_load, rig.period_s), n);
  const double normalised = iteration_error(model, Eigen::Vector4d::Ones(), 1.0);
  const double si = iteration_error(model, {n.force, n.position, n.velocity, n.force}, n.current_A);
  StudyResult result;
  result.measured = {{"S8.2.normalised", si / normalised, number_as("%.1e, ", si) + number_as("%.1e", normalised)}};
  return result;
}

constexpr Study kStudies[] = {
    {"S7.2", "Influence of the weights", kWeightClaims, run_weights,
     "fc1d.yaml with its noise, full-state LQR, xi = 6, multisine of 160 N and step of 400 N."},
    {"S8.2", "Normalisation and the Riccati iteration", kNormalisedClaims, run_normalised,
     "fc1d.yaml, 2.5 kg, full state, weights (7.9) and (7.10), double precision."}};

}  // namespace
}  // namespace section7_weights_studies

std::span<const Study> section7_weights() { return section7_weights_studies::kStudies; }

}  // namespace farrier::thesis
