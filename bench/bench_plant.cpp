#include "bench/bench_plant.hpp"

#include <cvode/cvode.h>
#include <nvector/nvector_serial.h>
#include <sundials/sundials_context.h>
#include <sunlinsol/sunlinsol_dense.h>
#include <sunmatrix/sunmatrix_dense.h>
#include <sunnonlinsol/sunnonlinsol_fixedpoint.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <limits>
#include <memory>
#include <vector>

#include "core/ensure.hpp"
#include "bench/bench_plant_joints.hpp"
#include "plant/effects/effects.hpp"
#include "plant/equations.hpp"
#include "plant/hydraulic_joint.hpp"

namespace farrier::bench {
namespace {

using plant::HeldInput;
using plant::HydraulicJoint;
using plant::IntegrationState;
using plant::JointEquations;
using plant::LoadParams;
using plant::State;

struct Outcome {
  double s_per_tick;
  double error;
};

using States = std::vector<std::array<State, kBenchJoints>>;

Outcome judge(const std::vector<BenchJoint>& joints, const States& states, double elapsed_s) {
  BenchErrorMeter meter;
  for (std::size_t tick = 0; tick < states.size(); ++tick) {
    for (std::size_t j = 0; j < joints.size(); ++j) {
      meter.add(joints[j], static_cast<int>(tick), states[tick][j]);
    }
  }
  return {elapsed_s / static_cast<double>(states.size()), meter.rms()};
}

double elapsed_s(std::chrono::steady_clock::time_point start) {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

plant::ActiveEffect effect_of(const char* name, std::initializer_list<double> values) {
  plant::ActiveEffect effect{plant::find_effect(name), {}};
  std::ranges::copy(values, effect.values.begin());
  return effect;
}

/// The effects that hyq.yaml gives its joints, with its numbers.
std::vector<plant::ActiveEffect> effects_of(const BenchJoint& joint) {
  const bool rotary = joint.actuator.area_a == joint.actuator.area_b;
  const double lever = rotary ? 0.045 : 1.0;
  const double stribeck = 0.01 * plant::velocity_scale(joint.actuator);
  return {effect_of("piston_friction", {10.0 * lever, 1.3, stribeck, 1.25e-4 * joint.actuator.stroke, 0.0}),
          effect_of("valve_deadband", {6e-5, 2e-14}), effect_of("supply_droop", {2.5e9, 0.042})};
}

Outcome run_ours(const std::vector<BenchJoint>& cases, int ticks, bool with_effects = false) {
  std::vector<HydraulicJoint> joints;
  for (const BenchJoint& c : cases) {
    joints.push_back(HydraulicJoint::create(c.actuator, c.load_at(0), c.start, HydraulicJoint::kDefaultTolerance,
                                            with_effects ? effects_of(c) : std::vector<plant::ActiveEffect>{})
                         .value());
  }
  States states(static_cast<std::size_t>(ticks));
  const auto start = std::chrono::steady_clock::now();
  for (int tick = 0; tick < ticks; ++tick) {
    for (std::size_t j = 0; j < kBenchJoints; ++j) {
      if (cases[j].load_changes_at(tick)) {
        joints[j].set_load(cases[j].load_at(tick));
      }
      joints[j].step(cases[j].current_A[static_cast<std::size_t>(tick)], 0.0, kBenchPeriod_s);
      states[static_cast<std::size_t>(tick)][j] = joints[j].state();
    }
  }
  return judge(cases, states, elapsed_s(start));
}

struct Configuration {
  const char* name;
  int method;
  bool newton;
  bool restart;  ///< CVodeReInit at each tick, or one integration through the jumps of the input
};

constexpr std::array kConfigurations{
    Configuration{"BDF, dense Newton, restart each tick", CV_BDF, true, true},
    Configuration{"BDF, dense Newton, one integration", CV_BDF, true, false},
    Configuration{"Adams, dense Newton, restart each tick", CV_ADAMS, true, true},
    Configuration{"Adams, dense Newton, one integration", CV_ADAMS, true, false},
    Configuration{"Adams, fixed point, restart each tick", CV_ADAMS, false, true},
    Configuration{"Adams, fixed point, one integration", CV_ADAMS, false, false},
};

/// One joint integrated by CVODE, from the same equations.
class CvodeJoint {
 public:
  CvodeJoint(const BenchJoint& joint, const Configuration& how, double tolerance, SUNContext context)
      : restart_(how.restart), equations_(joint.actuator, joint.load_at(0)), y_(N_VNew_Serial(4, context)) {
    const double scales[4] = {joint.actuator.stroke, plant::velocity_scale(joint.actuator),
                              joint.actuator.supply_pressure_Pa, joint.actuator.supply_pressure_Pa};
    const State& s = joint.start;
    const double start[4] = {s.position, s.velocity, s.pressure_a_Pa, s.pressure_b_Pa};
    std::copy(start, start + 4, N_VGetArrayPointer(y_));
    N_Vector absolute = N_VClone(y_);
    for (int i = 0; i < 4; ++i) {
      N_VGetArrayPointer(absolute)[i] = tolerance * scales[i];
    }
    memory_ = CVodeCreate(how.method, context);
    check(CVodeInit(memory_, &CvodeJoint::derivative, 0.0, y_));
    check(CVodeSVtolerances(memory_, 0.0, absolute));
    check(CVodeSetUserData(memory_, this));
    check(CVodeSetErrFile(memory_, nullptr));  // a failed crossing is retried, see step()
    check(CVodeSetMaxNumSteps(memory_, 100000));
    if (how.newton) {
      matrix_ = SUNDenseMatrix(4, 4, context);
      linear_ = SUNLinSol_Dense(y_, matrix_, context);
      check(CVodeSetLinearSolver(memory_, linear_, matrix_));
    } else {
      fixed_point_ = SUNNonlinSol_FixedPoint(y_, 0, context);
      check(CVodeSetNonlinearSolver(memory_, fixed_point_));
    }
    N_VDestroy(absolute);
  }
  CvodeJoint(const CvodeJoint&) = delete;
  CvodeJoint& operator=(const CvodeJoint&) = delete;
  ~CvodeJoint() {
    CVodeFree(&memory_);
    if (linear_ != nullptr) {
      SUNLinSolFree(linear_);
      SUNMatDestroy(matrix_);
    }
    if (fixed_point_ != nullptr) {
      SUNNonlinSolFree(fixed_point_);
    }
    N_VDestroy(y_);
  }

  void set_load(const LoadParams& load) { equations_.set_load(load); }
  bool failed() const { return failed_; }

  State step(double current_A) {
    input_ = equations_.hold(current_A, 0.0);
    if (restart_) {
      check(CVodeReInit(memory_, 0.0, y_));
      time_s_ = 0.0;
    }
    const double end_s = restart_ ? kBenchPeriod_s : static_cast<double>(++tick_) * kBenchPeriod_s;
    check(CVodeSetStopTime(memory_, end_s));
    if (CVode(memory_, end_s, y_, &time_s_, CV_NORMAL) < 0) {
      check(CVodeReInit(memory_, time_s_, y_));  // a jump its history could not cross
      check(CVodeSetStopTime(memory_, end_s));
      failed_ |= CVode(memory_, end_s, y_, &time_s_, CV_NORMAL) < 0;
    }
    const double* y = N_VGetArrayPointer(y_);
    return {y[0], y[1], std::max(0.0, y[2]), std::max(0.0, y[3])};
  }

 private:
  static int derivative(realtype, N_Vector y, N_Vector rate, void* self) {
    const double* in = N_VGetArrayPointer(y);
    double* out = N_VGetArrayPointer(rate);
    const auto* joint = static_cast<const CvodeJoint*>(self);
    const IntegrationState d = joint->equations_.derivative({in[0], in[1], in[2], in[3]}, joint->input_);
    out[0] = d.position;
    out[1] = d.velocity;
    out[2] = d.compression_a_Pa;
    out[3] = d.compression_b_Pa;
    return 0;
  }
  static void check(int flag) { FARRIER_ENSURE(flag >= 0, "CVODE refused"); }

  bool restart_;
  JointEquations equations_;
  HeldInput input_{};
  N_Vector y_;
  void* memory_ = nullptr;
  SUNMatrix matrix_ = nullptr;
  SUNLinearSolver linear_ = nullptr;
  SUNNonlinearSolver fixed_point_ = nullptr;
  double time_s_ = 0.0;
  long tick_ = 0;
  bool failed_ = false;
};

Outcome run_cvode(const std::vector<BenchJoint>& cases, int ticks, const Configuration& how, double tolerance) {
  SUNContext context = nullptr;
  FARRIER_ENSURE(SUNContext_Create(nullptr, &context) == 0, "SUNDIALS context");
  Outcome outcome{};
  {
    std::vector<std::unique_ptr<CvodeJoint>> joints;
    for (const BenchJoint& c : cases) {
      joints.push_back(std::make_unique<CvodeJoint>(c, how, tolerance, context));
    }
    States states(static_cast<std::size_t>(ticks));
    const auto start = std::chrono::steady_clock::now();
    for (int tick = 0; tick < ticks; ++tick) {
      for (std::size_t j = 0; j < kBenchJoints; ++j) {
        if (cases[j].load_changes_at(tick)) {
          joints[j]->set_load(cases[j].load_at(tick));
        }
        states[static_cast<std::size_t>(tick)][j] = joints[j]->step(cases[j].current_A[static_cast<std::size_t>(tick)]);
      }
    }
    outcome = judge(cases, states, elapsed_s(start));
    if (std::any_of(joints.begin(), joints.end(), [](const auto& joint) { return joint->failed(); })) {
      outcome.error = std::numeric_limits<double>::infinity();  // too loose a tolerance to get through
    }
  }
  SUNContext_Free(&context);
  return outcome;
}

/// The tolerance at which CVODE's error meets `error`, by bisection of its logarithm.
double matching_tolerance(const std::vector<BenchJoint>& cases, int ticks, const Configuration& how, double error) {
  constexpr int kBisections = 9;
  double loose = -1.0;
  double tight = -12.0;
  for (int i = 0; i < kBisections; ++i) {
    const double middle = 0.5 * (loose + tight);
    (run_cvode(cases, ticks, how, std::pow(10.0, middle)).error > error ? loose : tight) = middle;
  }
  return std::pow(10.0, 0.5 * (loose + tight));
}

template <class Run>
Outcome fastest_of(int repeats, Run run) {
  Outcome best = run();
  for (int i = 1; i < repeats; ++i) {
    const Outcome next = run();
    best.s_per_tick = std::min(best.s_per_tick, next.s_per_tick);
  }
  return best;
}

}  // namespace

PlantBench bench_plant(int ticks) {
  FARRIER_ENSURE(ticks >= 1, "bench_plant needs a tick");
  constexpr int kRepeats = 3;
  const std::vector<BenchJoint> joints = make_bench_joints(ticks);
  const Outcome ours = fastest_of(kRepeats, [&] { return run_ours(joints, ticks); });
  const Outcome effects = fastest_of(kRepeats, [&] { return run_ours(joints, ticks, true); });
  PlantBench bench{
      .ours_s_per_tick = ours.s_per_tick, .ours_error = ours.error, .effects_s_per_tick = effects.s_per_tick};
  for (const Configuration& how : kConfigurations) {
    const double tolerance = matching_tolerance(joints, ticks, how, ours.error);
    const Outcome theirs = fastest_of(kRepeats, [&] { return run_cvode(joints, ticks, how, tolerance); });
    if (bench.cvode_s_per_tick == 0.0 || theirs.s_per_tick < bench.cvode_s_per_tick) {
      bench.cvode_s_per_tick = theirs.s_per_tick;
      bench.cvode_error = theirs.error;
      bench.cvode_configuration = how.name;
    }
  }
  return bench;
}

}  // namespace farrier::bench
