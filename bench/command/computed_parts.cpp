#include "bench/command/computed_parts.hpp"

#include <cstdio>

#include "bench/command/allocation_count.hpp"
#include "bench/command/body_part.hpp"
#include "bench/bench_control.hpp"
#include "bench/bench_estimators.hpp"
#include "bench/bench_forgetting.hpp"
#include "bench/bench_grey_box.hpp"
#include "bench/bench_plant.hpp"
#include "bench/bench_redesign.hpp"
#include "bench/bench_riccati.hpp"
#include "bench/bench_rls.hpp"
#include "bench/bench_tick.hpp"

namespace farrier::cli {
namespace {

// The least the product promises; figures without a bound are for people.
constexpr double kPlantSpeedup = 20.0;
constexpr double kEffectsRatio = 1.3;
constexpr double kRiccatiSpeedup = 3.0;
constexpr double kRiccatiResidual = 1e-12;
constexpr double kRlsSpeedup = 20.0;
constexpr double kRlsDifference = 1e-12;
constexpr double kGreyBoxUs = 15.0;
constexpr double kTickUs = 50.0;
constexpr double kRedesignUs = 10.0;
constexpr double kForgettingFallMs = 20.0;
constexpr double kForgettingReturnMs = 200.0;

Result<Done> bench_plant(report::Figures& figures) {
  std::fputs("plant: ours against CVODE at equal accuracy\n", stderr);
  const bench::PlantBench bench = bench::bench_plant(400);
  figures.add("bench.plant.us_per_tick", 1e6 * bench.ours_s_per_tick);
  figures.add("bench.plant.cvode_us_per_tick", 1e6 * bench.cvode_s_per_tick);
  figures.add("bench.plant.speedup", bench.cvode_s_per_tick / bench.ours_s_per_tick, kPlantSpeedup);
  figures.add("bench.plant.effects_ratio", bench.effects_s_per_tick / bench.ours_s_per_tick, kEffectsRatio);
  figures.add("bench.plant.error", bench.ours_error);
  figures.add("bench.plant.cvode_error", bench.cvode_error);
  return Done{};
}

Result<Done> bench_riccati(report::Figures& figures) {
  std::fputs("riccati: doubling against the thesis's iteration and SLICOT SB02OD\n", stderr);
  const bench::RiccatiBench bench = bench::bench_riccati(50);
  figures.add("bench.riccati.doubling_us", 1e6 * bench.doubling_s);
  figures.add("bench.riccati.iteration_us", 1e6 * bench.iteration_s);
  figures.add("bench.riccati.slicot_us", 1e6 * bench.slicot_s);
  figures.add("bench.riccati.speedup_iteration", bench.iteration_s / bench.doubling_s, kRiccatiSpeedup);
  figures.add("bench.riccati.speedup_slicot", bench.slicot_s / bench.doubling_s, kRiccatiSpeedup);
  figures.add("bench.riccati.relative_residual", bench.doubling_residual, kRiccatiResidual);
  return Done{};
}

Result<Done> bench_control(report::Figures& figures) {
  std::fputs("control: one joint's control step\n", stderr);
  const bench::ControlBench bench = bench::bench_control(200'000, allocation_count);
  figures.add("bench.control.step_ns", 1e9 * bench.step_s);
  figures.add("bench.control.allocations", static_cast<double>(bench.allocations), 0.0);
  return Done{};
}

Result<Done> bench_rls(report::Figures& figures) {
  std::fputs("rls: one covariance for three rows against the thesis's 12 x 12\n", stderr);
  const bench::RlsBench bench = bench::bench_rls(4000, allocation_count);
  figures.add("bench.rls.ns_per_update", 1e9 * bench.update_s);
  figures.add("bench.rls.ns_per_update_bias", 1e9 * bench.update_bias_s);
  figures.add("bench.rls.textbook_ns_per_update", 1e9 * bench.textbook_s);
  figures.add("bench.rls.speedup", bench.textbook_s / bench.update_s, kRlsSpeedup);
  figures.add("bench.rls.difference", bench.difference, kRlsDifference);
  figures.add("bench.rls.allocations", static_cast<double>(bench.allocations), 0.0);
  return Done{};
}

Result<Done> bench_estimators(report::Figures& figures) {
  std::fputs("estimators: one joint's tick by every method, and what the gates add\n", stderr);
  const bench::EstimatorsBench bench = bench::bench_estimators(4000, allocation_count);
  for (const auto& method : bench.methods) {
    figures.add(std::string("bench.estimator.") + method.name + "_ns", 1e9 * method.take_s);
  }
  figures.add("bench.estimator.pe_gate_ns", 1e9 * bench.pe_s);
  figures.add("bench.estimator.fft_gate_ns", 1e9 * bench.fft_s);
  figures.add("bench.estimator.allocations", static_cast<double>(bench.allocations), 0.0);
  return Done{};
}

Result<Done> bench_grey_box(report::Figures& figures) {
  std::fputs("greybox: one joint's tick of the grey-box estimator, and one estimate\n", stderr);
  const bench::GreyBoxBench bench = bench::bench_grey_box(4000, allocation_count);
  figures.add("bench.greybox.tick_us", 1e6 * bench.take_s, kGreyBoxUs);
  figures.add("bench.greybox.slowest_tick_us", 1e6 * bench.take_slowest_s);
  figures.add("bench.greybox.estimate_us", 1e6 * bench.estimate_s);
  figures.add("bench.greybox.allocations", static_cast<double>(bench.allocations), 0.0);
  return Done{};
}

Result<Done> bench_tick(const robot::Robot& robot, report::Figures& figures) {
  std::fputs("tick: every joint's control, estimation and update logic on one core\n", stderr);
  const auto tick = FARRIER_TRY(bench::bench_tick(robot, 20, allocation_count));
  figures.add("bench.tick.us", 1e6 * tick.tick_s, kTickUs);
  figures.add("bench.tick.estimation_us", 1e6 * tick.estimation_s);
  figures.add("bench.tick.update_logic_us", 1e6 * tick.update_logic_s);
  figures.add("bench.tick.control_us", 1e6 * tick.control_s);
  figures.add("bench.tick.allocations", static_cast<double>(tick.allocations), 0.0);
  return Done{};
}

Result<Done> bench_redesign(const robot::Robot& robot, report::Figures& figures) {
  std::fputs("redesign: of one joint's gains, as an update of its estimate asks for\n", stderr);
  const auto redesign = FARRIER_TRY(bench::bench_redesign(robot, 50, allocation_count));
  figures.add("bench.redesign.us", 1e6 * redesign.redesign_s, kRedesignUs);
  figures.add("bench.redesign.lqr_us", 1e6 * redesign.lqr_s);
  figures.add("bench.redesign.allocations", static_cast<double>(redesign.allocations), 0.0);
  return Done{};
}

Result<Done> bench_forgetting(const robot::Robot& robot, report::Figures& figures) {
  std::fputs("forgetting: of the method aff after a change of load\n", stderr);
  constexpr int kSeeds = 8;
  const auto forgetting = FARRIER_TRY(bench::bench_forgetting(robot, kSeeds));
  figures.add("bench.forgetting.fall_ms", 1e3 * forgetting.fall_s, kForgettingFallMs);
  figures.add("bench.forgetting.return_ms", 1e3 * forgetting.return_s, kForgettingReturnMs);
  return Done{};
}

}  // namespace

std::vector<ComputedPart> computed_parts(const robot::Robot& robot) {
  return {
      {"plant", {"plant", bench_plant}},
      {"riccati", {"riccati", bench_riccati}},
      {"control", {"control", bench_control}},
      {"rls", {"rls", bench_rls}},
      {"estimators", {"estimators", bench_estimators}},
      {"estimators", {"forgetting", [&robot](report::Figures& figures) { return bench_forgetting(robot, figures); }}},
      {"greybox", {"greybox", bench_grey_box}},
      {"tick", {"tick", [&robot](report::Figures& figures) { return bench_tick(robot, figures); }}},
      {"tick", {"redesign", [&robot](report::Figures& figures) { return bench_redesign(robot, figures); }}},
      {"body", {"body", [&robot](report::Figures& figures) { return measure_body(robot, figures); }}}};
}

}  // namespace farrier::cli
