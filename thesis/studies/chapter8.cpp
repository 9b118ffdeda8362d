// Hubacher (2014), Chapter 8: the iterative Riccati solution (Fig. 8.9) and the estimator's verification (Fig. 8.11).

#include <algorithm>
#include <cmath>

#include "control/design/lqr.hpp"
#include "control/numerics/riccati.hpp"
#include "control/numerics/spectrum.hpp"
#include "core/noise.hpp"
#include "estimation/rls.hpp"
#include "thesis/studies/registry.hpp"
#include "textbook/textbook_rls.hpp"
#include "plant/hydraulic_joint.hpp"
#include "robot/joint_model.hpp"

namespace farrier::thesis {
namespace chapter8_studies {
namespace {

constexpr double kStepTolerance = 0.4;  // RTOL of 8.2.2, on the square of the Frobenius norm
constexpr int kIterations = 100;

constexpr ClaimSpec kRiccatiClaims[] = {
    {"8.9.step_after_100", "8.2.2", "... is already low after just 100 iterations.",
     "The squared Frobenius norm of the step between successive solutions after 100 iterations is below the thesis's "
     "RTOL.",
     "1", Relation::kBelow, kStepTolerance},
    {"8.9.error_after_100", "8.2.2", "... is already low after just 100 iterations.",
     "What is missing to the true solution after 100 iterations, over the true solution, Frobenius norms: a hundredth, "
     "well below what estimates are known to.",
     "1", Relation::kAtMost, 0.01},
    {"8.9.order", "8.2.2", "... the relative error decreases almost quadratically ...",
     "The order of convergence log(e[k+1]/e[k]) / log(e[k]/e[k-1]) from the first to the last of iterations 90 to 100 "
     "is 1.5 or more.",
     "1", Relation::kAtLeast, 1.5,
     Refutation{"(8.1) is the Riccati difference equation, whose error shrinks by the closed loop's spectral radius "
                "squared in every step (Anderson and Moore 1979, 4.4): first order. Doubling is quadratic.",
                0.9, 1.1}}};

using Matrix4 = Eigen::Matrix4d;
using Column4 = Eigen::Vector4d;
using Row4 = Eigen::Matrix<double, 1, 4>;

struct Equation {
  Matrix4 a = Matrix4::Identity();
  Column4 b = Column4::Zero();
  Matrix4 q;
  double r;
};

/// (7.7) with the weights (7.9), (7.10), normalised.
Equation equation_of(const robot::Joint& joint, double period_s) {
  const control::DiscreteModel model =
      control::normalise(robot::model_of(joint, joint.swing_load, period_s), joint.normalisation);
  Equation equation;
  equation.a(0, 3) = -1.0;
  equation.a.bottomRightCorner<3, 3>() = model.a;
  equation.b.tail<3>() = model.b;
  const control::LqrWeights& w = joint.design.weights;
  equation.q = Column4(w.integral, w.position, w.velocity, w.force).asDiagonal();
  equation.r = w.input;
  return equation;
}

Result<StudyResult> run_riccati(const StudyContext& context) {
  const auto robot = FARRIER_TRY(load(context, "fc1d.yaml"));
  const Equation e = equation_of(robot.joints[0], robot.period_s);
  const auto truth = control::solve_dare<4>(e.a, e.b, e.q, e.r, Row4::Zero());
  if (!truth) {
    return Error{std::string("Fig. 8.9: the Riccati equation has no solution: ") + to_string(truth.error())};
  }
  Series steps{"step, squared", {}, {}, Style::kLine, 1};
  Series errors{"error to the solution by doubling", {}, {}, Style::kLine, 3};
  Matrix4 s = e.q;  // (8.2) with N = 0
  std::vector<double> error;
  double step_squared = 0.0;
  for (int k = 1; k <= kIterations; ++k) {
    const Matrix4 step = control::riccati_residual<4>(e.a, e.b, e.q, e.r, Row4::Zero(), s);  // (8.1) less S_k
    s += step;
    step_squared = step.squaredNorm();
    error.push_back((s - truth.value().s).norm());
    steps.x.push_back(k);
    steps.y.push_back(step_squared);
    errors.x.push_back(k);
    errors.y.push_back(error.back());
  }
  const auto last = static_cast<std::size_t>(kIterations) - 1;
  const double early = std::log(error[last - 9] / error[last - 10]);
  const double late = std::log(error[last] / error[last - 1]);
  const double radius = control::spectral_radius(Matrix4(e.a - e.b * truth.value().k));
  StudyResult result;
  result.measured = {{"8.9.step_after_100", step_squared, ""},
                     {"8.9.error_after_100", error.back() / truth.value().s.norm(), ""},
                     {"8.9.order", late / early,
                      "factor per iteration " + std::to_string(std::exp(late)) + ", spectral radius squared " +
                          std::to_string(std::pow(radius, 2))}};
  result.pictures = {
      {"Riccati recursion (8.1) for the rig's LQR",
       1,
       {{.title = "", .x_label = "iteration", .y_label = "Frobenius norm", .log_y = true, .series = {steps, errors}}}}};
  return result;
}

constexpr ClaimSpec kRlsClaims[] = {
    {"8.11.difference", "8.4",
     "... the absolute error of each element of the unknown parameter vector ... is below < 2e-14.",
     "The largest difference of an element of (6.35) between recursive least squares as the robot runs it (one shared "
     "covariance in UD factors) and (6.21) as printed (12 x 12 covariance) is below 2e-14.",
     "1", Relation::kBelow, 2e-14}};

Result<StudyResult> run_rls(const StudyContext& context) {
  const auto loaded = FARRIER_TRY(load(context, "fc1d.yaml"));
  const robot::Robot& rig = loaded;
  const robot::Joint& joint = rig.joints[0];
  auto made = FARRIER_TRY(plant::HydraulicJoint::create(
      joint.actuator, joint.swing_load,
      plant::equilibrium(joint.actuator, joint.swing_load, joint.swing_load.equilibrium_position, 0.0)));
  plant::HydraulicJoint& plant = made;
  // The signals of 6.3.1: white noise of 5 % of the nominal opening, no sensor noise.
  constexpr double kForgetting = 0.85;
  constexpr double kCovariance = 1e3;
  constexpr double kShare = 0.05;
  constexpr int kTicks = 250;
  const NoiseStream white(context.seed, "fig8.11", "valve");
  auto rls = FARRIER_TRY(estimation::Rls<4>::create({kForgetting, kCovariance, 1e30, 0.0}));
  textbook::TextbookRls<4> textbook(kForgetting, kCovariance);
  const control::Normalisation& n = joint.normalisation;
  const Eigen::Vector3d scale(n.position, n.velocity, n.force);
  const auto measure = [&]() -> Eigen::Vector3d {
    const Eigen::Vector3d x(plant.state().position - joint.swing_load.equilibrium_position, plant.state().velocity,
                            plant.load_cell_force());
    return x.cwiseQuotient(scale);
  };
  std::vector<Series> series(12);
  double largest = 0.0;
  Eigen::Vector3d x = measure();
  for (int k = 0; k < kTicks; ++k) {
    const double u = kShare * n.current_A * white.normal(k);
    plant.step(u, 0.0, rig.period_s);
    const Eigen::Vector3d y = measure();
    Eigen::Vector4d h;
    h << x, u / n.current_A;
    rls.update(h, y);
    textbook.update(h, y);
    const Eigen::Matrix<double, 3, 4> difference = rls.parameters() - textbook.parameters();
    largest = std::max(largest, difference.cwiseAbs().maxCoeff());
    for (int i = 0; i < difference.size(); ++i) {
      Series& one = series[static_cast<std::size_t>(i)];
      one.colour = i;
      one.x.push_back(k * rig.period_s);
      one.y.push_back(difference(i));
    }
    x = y;
  }
  StudyResult result;
  result.measured = {{"8.11.difference", largest, ""}};
  result.pictures = {{"Every element of the estimate, one form less the other",
                      1,
                      {{.title = "", .x_label = "time (s)", .y_label = "difference", .series = std::move(series)}}}};
  return result;
}

constexpr Study kStudies[] = {
    {"8.9", "Iterative solution of the Riccati equation", kRiccatiClaims, run_riccati,
     "The rig of fc1d.yaml with 2.5 kg, weights (7.9) and (7.10), normalised. It has no random part."},
    {"8.11", "Recursive least squares, two implementations", kRlsClaims, run_rls,
     "The rig of fc1d.yaml, perfect sensors, white noise of 5 % at the valve, lambda 0.85, first covariance 1000 I. "
     "The text compares "
     "C++ with MATLAB."}};

}  // namespace
}  // namespace chapter8_studies

std::span<const Study> chapter8() { return chapter8_studies::kStudies; }

}  // namespace farrier::thesis
