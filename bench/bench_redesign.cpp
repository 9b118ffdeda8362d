#include "bench/bench_redesign.hpp"

#include <algorithm>
#include <array>
#include <chrono>
#include <limits>
#include <vector>

#include "control/model/model_rows.hpp"
#include "control/design/switching.hpp"
#include "robot/joint_model.hpp"
#include "supervisor/joint_design.hpp"
#include "supervisor/slot_update.hpp"

namespace farrier::bench {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr std::array kMassFactors{0.3, 0.5, 0.7, 1.5, 2.5, 4.0};
constexpr std::array kDampingFactors{0.7, 1.5};
constexpr std::array kGainFactors{0.75, 1.35};
constexpr double kGainError = 0.02;  // one sigma, of the valve's gain
constexpr double kValidity = 0.9;
constexpr std::uint32_t kSamples = 500;
constexpr int kMaxLooks = 100;

/// A slot that needs one more look at its estimate.
struct Case {
  supervisor::SlotUpdate slot;
  signals::JointModelEstimate estimate;
  control::DiscreteModel model;
  const robot::Joint* joint;
};

// As on a robot that stands: no dwell time of the joint's two loops is worked out.
signals::UpdateVerdict look(Case& one, Tick tick) {
  return one.slot.look(one.estimate, tick, {one.slot.gains(), control::kNoDwell, false}).verdict;
}

signals::JointModelEstimate estimate_of(const robot::Joint& joint, const control::DiscreteModel& model) {
  signals::JointModelEstimate estimate;
  estimate.joint = joint.number;
  estimate.a = control::rows_of(model.a);
  estimate.b = control::entries_of(model.b);
  estimate.b_error = control::entries_of(kGainError * model.b.cwiseAbs());
  estimate.validity = kValidity;
  estimate.samples = kSamples;
  return estimate;
}

/// Shows the slot its estimate until the next look will accept it; leaves out what is never accepted.
void keep_if_accepted(Case candidate, std::vector<Case>& cases) {
  for (int i = 0; i < kMaxLooks; ++i) {
    const Case before = candidate;
    const signals::UpdateVerdict verdict = look(candidate, i);
    if (verdict == signals::UpdateVerdict::kAccepted) {
      cases.push_back(before);
    }
    if (verdict != signals::UpdateVerdict::kNotConverged) {
      return;
    }
  }
}

Result<std::vector<Case>> make_cases(const robot::Robot& robot, int delay_ticks) {
  std::vector<Case> cases;
  for (const robot::Joint& joint : robot.joints) {
    for (const plant::LoadParams& designed_for : {joint.swing_load, joint.stance_load}) {
      const auto first = FARRIER_TRY(supervisor::design_joint(joint, designed_for, robot.period_s, delay_ticks));
      const supervisor::SlotUpdate slot(joint, robot.update_logic, robot.period_s, robot.estimate_period_ticks, first);
      for (const double mass : kMassFactors) {
        for (const double damping : kDampingFactors) {
          for (const double gain : kGainFactors) {
            plant::LoadParams load = designed_for;
            load.mass *= mass;
            load.damping *= damping;
            control::DiscreteModel model = robot::model_of(joint, load, robot.period_s);
            model.b *= gain;
            keep_if_accepted({slot, estimate_of(joint, model), model, &joint}, cases);
          }
        }
      }
    }
  }
  if (cases.empty()) {
    return Error{"no estimate of " + robot.name + " leads to a redesign"};
  }
  return cases;
}

}  // namespace

Result<RedesignBench> bench_redesign(const robot::Robot& robot, int rounds, std::int64_t (*allocations_so_far)()) {
  using Clock = std::chrono::steady_clock;
  RedesignBench bench{0.0, 0.0, 0, 0};
  volatile double sink = 0.0;
  for (const int delay_ticks : {robot.loop_delay_lockstep, robot.loop_delay_realtime}) {
    const auto cases = FARRIER_TRY(make_cases(robot, delay_ticks));
    const auto count = static_cast<double>(cases.size());
    double redesign_s = kInfinity;
    double lqr_s = kInfinity;
    for (int round = 0; round < std::max(rounds, 1); ++round) {
      std::vector<Case> ready = cases;
      std::size_t accepted = 0;
      const std::int64_t before = allocations_so_far != nullptr ? allocations_so_far() : 0;
      const auto start = Clock::now();
      for (Case& each : ready) {
        accepted += look(each, kMaxLooks) == signals::UpdateVerdict::kAccepted ? 1 : 0;
      }
      const auto between = Clock::now();
      for (const Case& each : ready) {
        sink = control::design_lqr(each.model, each.joint->design.weights, each.joint->normalisation, each.joint->form,
                                   delay_ticks)
                   .value()
                   .force;
      }
      const auto end = Clock::now();
      bench.allocations += allocations_so_far != nullptr ? allocations_so_far() - before : 0;
      if (accepted != ready.size()) {
        return Error{"a timed redesign was refused: " + std::to_string(accepted) + " of " +
                     std::to_string(ready.size()) + " accepted"};
      }
      redesign_s = std::min(redesign_s, std::chrono::duration<double>(between - start).count() / count);
      lqr_s = std::min(lqr_s, std::chrono::duration<double>(end - between).count() / count);
    }
    bench.redesign_s = std::max(bench.redesign_s, redesign_s);
    bench.lqr_s = std::max(bench.lqr_s, lqr_s);
    bench.redesigns = std::max(bench.redesigns, static_cast<int>(cases.size()));
  }
  static_cast<void>(sink);
  if (allocations_so_far == nullptr) {
    bench.allocations = -1;
  }
  return bench;
}

}  // namespace farrier::bench
