#include "bench/bench_riccati.hpp"

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <limits>
#include <vector>

#include "control/design/lqr.hpp"
#include "control/numerics/riccati.hpp"
#include "bench/slicot.hpp"
#include "plant/linear_model.hpp"

namespace farrier::bench {
namespace {

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
constexpr double kRiccatiPeriod_s = 1e-3;
constexpr double kTolerance = 1e-12;
constexpr int kMaxIterations = 1000000;
constexpr int kRiccatiRounds = 20;
constexpr std::array<double, 5> kMassesKg{0.5, 2.5, 10.0, 25.0, 50.0};
constexpr control::Normalisation kRiccatiNormalisation{0.04, 1.2, 5000.0, 0.01};

template <int N>
struct Equation {
  Eigen::Matrix<double, N, N> a;
  Eigen::Matrix<double, N, 1> b;
  Eigen::Matrix<double, N, N> q;
  double r;
};

struct Set {
  std::vector<Equation<4>> full_state;
  std::vector<Equation<3>> compliant;
};

/// Cylinder of Hubacher (2014), Table A.1.
plant::ActuatorParams riccati_cylinder() {
  plant::ActuatorParams actuator;
  actuator.area_a = 2.0106e-4;
  actuator.area_b = 0.6094 * actuator.area_a;
  actuator.stroke = 0.08;
  actuator.valve_current_max_A = 0.01;
  actuator.piston_mass = 0.3141;
  actuator.piston_damping = 700.0;
  return actuator;
}

/// Table A.2, with the volume its line has.
plant::ActuatorParams fc1d() {
  plant::ActuatorParams actuator = riccati_cylinder();
  actuator.bulk_modulus_Pa = 5.5e8;
  actuator.line_volume_m3 = 6.8047e-6;
  actuator.valve_gain = 1.6704e-6;
  actuator.supply_pressure_Pa = 125e5;
  return actuator;
}

plant::ActuatorParams hyq() {
  plant::ActuatorParams actuator = riccati_cylinder();
  actuator.bulk_modulus_Pa = 1.8181e9;
  actuator.line_volume_m3 = 8.17e-6;
  actuator.valve_gain = 6.12e-6;
  actuator.supply_pressure_Pa = 160e5;
  return actuator;
}

/// (7.7) for a plant with P states, the last of them the force.
template <int P>
Equation<P + 1> augment(const control::DiscreteModel& plant, const control::LqrWeights& weights) {
  Equation<P + 1> equation;
  equation.a.setZero();
  equation.a(0, 0) = 1.0;
  equation.a(0, P) = -1.0;
  equation.a.template bottomRightCorner<P, P>() = plant.a.bottomRightCorner<P, P>();
  equation.b << 0.0, plant.b.tail<P>();
  const Eigen::Vector3d states(weights.position, weights.velocity, weights.force);
  equation.q.setZero();
  equation.q.diagonal() << weights.integral, states.tail<P>();
  equation.r = weights.input;
  return equation;
}

Set make_set() {
  Set set;
  for (const double mass_kg : kMassesKg) {
    for (const bool on_rig : {true, false}) {
      const plant::LoadParams load{mass_kg, 500.0, on_rig ? 21480.0 : 0.0, 0.04};
      const plant::LinearModel model =
          plant::linearise_load_cell_force(on_rig ? fc1d() : hyq(), load, {0.04, 0.0, 0.0, 0.0, 1.0});
      const control::DiscreteModel sampled =
          control::normalise(control::discretise(model.a, model.b, kRiccatiPeriod_s), kRiccatiNormalisation);
      if (on_rig) {
        set.full_state.push_back(augment<3>(sampled, {}));
      }
      set.compliant.push_back(augment<2>(sampled, {}));
    }
  }
  return set;
}

/// Runs `solve(equation, S) -> bool` over the set; keeps the worst residual, NaN after a refusal.
template <class Solve>
double worst_residual(const Set& set, const Solve& solve) {
  double worst = 0.0;
  const auto take = [&](const auto& equation) {
    auto s = equation.a;
    if (!solve(equation, s)) {
      worst = kNaN;
      return;
    }
    const auto residual =
        control::riccati_residual(equation.a, equation.b, equation.q, equation.r, (0.0 * equation.b).eval(), s);
    worst = std::isnan(worst) ? worst : std::max(worst, residual.norm() / s.norm());
  };
  std::for_each(set.full_state.begin(), set.full_state.end(), take);
  std::for_each(set.compliant.begin(), set.compliant.end(), take);
  return worst;
}

/// Seconds per equation: the smallest mean of kRiccatiRounds rounds.
template <class Solve>
double seconds_per_equation(const Set& set, int repetitions, const Solve& solve) {
  using Clock = std::chrono::steady_clock;
  double best = std::numeric_limits<double>::infinity();
  volatile double sink = 0.0;
  for (int round = 0; round < kRiccatiRounds; ++round) {
    const auto start = Clock::now();
    for (int i = 0; i < repetitions; ++i) {
      for (const auto& equation : set.full_state) {
        Eigen::Matrix4d s;
        sink = solve(equation, s) ? s(0, 0) : 0.0;
      }
      for (const auto& equation : set.compliant) {
        Eigen::Matrix3d s;
        sink = solve(equation, s) ? s(0, 0) : 0.0;
      }
    }
    const std::chrono::duration<double> spent = Clock::now() - start;
    best = std::min(best, spent.count());
  }
  static_cast<void>(sink);
  return best / (static_cast<double>(set.full_state.size() + set.compliant.size()) * repetitions);
}

struct ByDoubling {
  template <int N>
  bool operator()(const Equation<N>& e, Eigen::Matrix<double, N, N>& s) const {
    const auto solution = control::solve_dare<N>(e.a, e.b, e.q, e.r, Eigen::Matrix<double, N, 1>::Zero());
    if (solution) {
      s = solution.value().s;
    }
    return solution.ok();
  }
};

struct ByIteration {
  template <int N>
  bool operator()(const Equation<N>& e, Eigen::Matrix<double, N, N>& s) const {
    const auto solution = control::solve_dare_by_iteration<N>(
        e.a, e.b, e.q, e.r, Eigen::Matrix<double, N, 1>::Zero(), kMaxIterations, kTolerance);
    if (solution) {
      s = solution.value().s;
    }
    return solution.ok();
  }
};

struct BySlicot {
  template <int N>
  bool operator()(const Equation<N>& e, Eigen::Matrix<double, N, N>& s) const {
    return solve_dare_by_slicot<N>(e.a, e.b, e.q, e.r, s);
  }
};

}  // namespace

RiccatiBench bench_riccati(int repetitions) {
  const Set set = make_set();
  const int count = std::max(repetitions, 1);
  RiccatiBench bench{};
  bench.doubling_residual = worst_residual(set, ByDoubling{});
  bench.doubling_s = seconds_per_equation(set, count, ByDoubling{});
  bench.iteration_residual = worst_residual(set, ByIteration{});
  bench.iteration_s = seconds_per_equation(set, count, ByIteration{});
  bench.slicot_residual = worst_residual(set, BySlicot{});
  bench.slicot_s = seconds_per_equation(set, count, BySlicot{});
  return bench;
}

}  // namespace farrier::bench
