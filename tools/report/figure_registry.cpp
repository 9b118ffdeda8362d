#include <array>

#include "tools/report/figures.hpp"

namespace farrier::report {
namespace {

using enum Relation;

// clang-format off
constexpr std::array kSpecs{
    // trot: torque tracking from the third stride on, standing from 1 s after the lead-in on
    FigureSpec{"trot.<joint>.stance_nrmse", "1", kAtMost,
               "RMS force error in stance over the RMS of the reference about its mean there, which counts for at least 5 % of the actuator's rating."},
    FigureSpec{"trot.<joint>.swing_nrmse", "1", kNone, "The same in swing."},
    FigureSpec{"trot.<joint>.swing_design_stance_nrmse", "1", kNone,
               "Stance NRMSE of a second run in which every joint keeps the controller designed for swing."},
    FigureSpec{"trot.<joint>.swing_design_swing_nrmse", "1", kNone, "Swing NRMSE of that second run."},
    FigureSpec{"trot.<joint>.missed_ticks", "1", kAtMost,
               "Ticks whose valve command answered sensors older than the loop delay allows."},
    FigureSpec{"trot.<joint>.not_tracking_ticks", "1", kAtMost,
               "Judged ticks in which the joint was at null or damping instead of tracking its reference."},
    FigureSpec{"trot.tripped_joints", "1", kAtMost, "Joints that were tripped at any tick of the run, on either clock."},
    FigureSpec{"trot.<joint>.travel_rad", "rad", kAtLeast, "Largest less smallest joint angle."},
    FigureSpec{"trot.<joint>.stance_spectral_radius", "1", kBelow,
               "Largest modulus of the closed-loop poles: stance design on the stance load."},
    FigureSpec{"trot.<joint>.swing_spectral_radius", "1", kBelow,
               "Largest modulus of the closed-loop poles: swing design on the swing load."},
    FigureSpec{"trot.<joint>.updates", "1", kAtLeast, "Redesigned gains that the supervisor issued, both slots."},
    FigureSpec{"trot.<joint>.refused_designs", "1", kNone,
               "Redesigns it refused: no controller, or one unstable on the estimate or on the stored model within its uncertainty."},
    FigureSpec{"trot.updates", "1", kNone, "Redesigned gains issued, all joints."},
    FigureSpec{"trot.dither_cost_ratio", "1", kNone,
               "With --dither-cost: stance NRMSE of a run with a fixed design per phase and the robot file's dither over that of one without, median over joints."},
    FigureSpec{"trot.strides", "1", kNone, "Strides that every leg completed."},
    FigureSpec{"trot.ticks", "1", kNone, "Ticks of the run."},
    FigureSpec{"trot.ticks_per_s", "1/s", kNone, "Ticks per second of wall time."},
    FigureSpec{"trot.latency_p50_us", "us", kNone, "Median time from a sensor sample to the valve command that answers it."},
    FigureSpec{"trot.latency_p99_us", "us", kNone, "The same time that 99 % of the samples do not exceed."},
    FigureSpec{"trot.packets.<process>.<topic>.sent", "1", kNone, "Samples of a topic that a process published."},
    FigureSpec{"trot.packets.<process>.<topic>.received", "1", kNone, "Samples of a topic that a process received."},
    FigureSpec{"trot.lost_samples", "1", kAtMost, "Samples that any process knows it lost, all topics."},

    // trot --experiment fig7.8: Hubacher (2014), Section 7.5; quarters are named quarter1 to quarter4
    FigureSpec{"trot.fig7_8.fixed.<quarter>_nrmse", "1", kAtLeast,
               "RMS force error over RMS reference, from 0.2 s after the load's change to the quarter's end: gains fixed, designed for the light load."},
    FigureSpec{"trot.fig7_8.adaptive.<quarter>_nrmse", "1", kAtMost, "The same with adaptive gains."},
    FigureSpec{"trot.fig7_8.true_load.<quarter>_nrmse", "1", kNone,
               "The same with gains designed for the true load of each quarter, switched exactly."},
    FigureSpec{"trot.fig7_8.true_load_dithered.<quarter>_nrmse", "1", kNone, "The same with the dither that the adaptive run has."},
    FigureSpec{"trot.fig7_8.greybox.<quarter>_nrmse", "1", kAtMost,
               "The same with the physics a grey box estimates and the flow law inverted, no dither."},
    FigureSpec{"trot.fig7_8.greybox_noiseless.<quarter>_nrmse", "1", kAtMost, "The same without sensor noise."},
    FigureSpec{"trot.fig7_8.light_ratio_<quarter>", "1", kAtMost, "Adaptive over true load, light quarters: the dither's cost is in it."},
    FigureSpec{"trot.fig7_8.dithered_light_ratio_<quarter>", "1", kNone, "Adaptive over true load with the same dither, light quarters."},
    FigureSpec{"trot.fig7_8.gain_updates", "1", kNone, "Gain updates of the adaptive run after its first gains."},
    // trot --experiment switching: what it is worth that gains change with the announced phase
    FigureSpec{"trot.switching.stepped_ratio", "1", kAtMost,
               "Integrated force error over 30 ms after actual touchdowns, hips and knees, switching on over off; gains adapted before, reference and weight step at touchdown. On: both sets, stance_lead_s before planned touchdowns. Off: the adapted swing gains, which act when a leg lands, in both phases. No dither, no redesign."},
    FigureSpec{"trot.switching.ramped_ratio", "1", kNone, "The same with the load transfer of the robot file."},
    FigureSpec{"trot.switching.stepped_to_stance_ratio", "1", kNone, "As stepped_ratio, over the adapted stance gains in both phases."},
    FigureSpec{"trot.switching.ramped_to_stance_ratio", "1", kNone, "As ramped_ratio, over the adapted stance gains in both phases."},
    FigureSpec{"trot.switching.touchdowns", "1", kAtLeast, "Touchdowns that were judged, of the leg with the fewest."},
    FigureSpec{"trot.switching.gain_updates", "1", kNone, "Gain updates of the run that adapted the gains, after its first ones."},
    FigureSpec{"trot.switching.bump", "1", kAtMost,
               "Largest jump of the valve command at a gain switch at unchanged reference and measurement, over the valve's nominal current; of the force controllers, replayed on the trace."},
    FigureSpec{"trot.<joint>.switching_stepped_ratio", "1", kNone, "trot.switching.stepped_ratio of one joint."},
    FigureSpec{"trot.<joint>.switching_ramped_ratio", "1", kNone, "trot.switching.ramped_ratio of one joint."},
    // trot --experiment update-logic: Hubacher (2014), Section 5.3.1; methods are named as in a robot file
    FigureSpec{"trot.update_logic.<method>.<quarter>_nrmse", "1", kNone,
               "As trot.fig7_8.adaptive.<quarter>_nrmse, by this update logic, on the shipped rig."},
    FigureSpec{"trot.update_logic.<method>.rig_updates", "1", kNone, "Gains it issued in that run."},
    FigureSpec{"trot.update_logic.<method>.rig_designs", "1", kNone, "Controllers it designed in that run."},
    FigureSpec{"trot.update_logic.<method>.rig_diverged", "1", kAtMost, "Quarters with an NRMSE above 1."},
    FigureSpec{"trot.update_logic.<method>.stance_nrmse_median", "1", kNone,
               "Stance NRMSE of an adaptive trot by this update logic, median over joints."},
    FigureSpec{"trot.update_logic.<method>.stance_nrmse_worst", "1", kNone, "The worst joint's."},
    FigureSpec{"trot.update_logic.<method>.swing_nrmse_median", "1", kNone, "Swing NRMSE, median over joints."},
    FigureSpec{"trot.update_logic.<method>.diverged", "1", kAtMost,
               "Joints that tripped, were at null or damping while judged, or had a stance NRMSE above 1."},
    FigureSpec{"trot.update_logic.<method>.updates", "1", kNone, "Gains it issued in the trot."},
    FigureSpec{"trot.update_logic.<method>.designs", "1", kNone, "Controllers it designed in the trot."},
    FigureSpec{"trot.update_logic.<method>.looks", "1", kNone, "Estimates it looked at in the trot."},
    FigureSpec{"trot.update_logic.<method>.look_us", "us", kNone, "Mean time of a look, its design included."},
    // trot --experiment controllers: tests are varied_trot, joints and seeds of --vary, and load_steps, the cycle of
    // Fig. 7.8 with the worse heavy quarter as stance and the worse light quarter as swing
    FigureSpec{"trot.controllers.<controller>.<test>.stance_nrmse_median", "1", kNone, "Median stance NRMSE."},
    FigureSpec{"trot.controllers.<controller>.<test>.stance_nrmse_worst", "1", kNone, "Largest stance NRMSE."},
    FigureSpec{"trot.controllers.<controller>.<test>.swing_nrmse_median", "1", kNone, "Median swing NRMSE."},
    FigureSpec{"trot.controllers.<controller>.<test>.swing_nrmse_worst", "1", kNone, "Largest swing NRMSE."},
    FigureSpec{"trot.controllers.<controller>.<test>.ratio_to_best", "1", kAtMost,
               "Median stance NRMSE over that of the best controller of the test."},
    FigureSpec{"trot.controllers.<controller>.<test>.diverged", "1", kAtMost,
               "Joints and seeds that left tracking or had a stance NRMSE above 1."},
    FigureSpec{"trot.controllers.<controller>.<test>.seeds_failed", "1", kAtMost,
               "Seeds in which any joint diverged or had a stance NRMSE above 0.3."},
    // trot --vary: stance NRMSE over all pairs of a joint and a seed
    FigureSpec{"trot.vary.seeds", "1", kNone, "Robots drawn."},
    FigureSpec{"trot.vary.adaptive_stance_nrmse_median", "1", kNone, "Median stance NRMSE of adaptation over joints and seeds."},
    FigureSpec{"trot.vary.perfect_stance_nrmse_median", "1", kNone,
               "The same of perfect knowledge: designs for the drawn robot, switched at the actual touchdowns."},
    FigureSpec{"trot.vary.median_ratio_perfect", "1", kAtMost, "The first over the second."},
    FigureSpec{"trot.vary.ratio_perfect_median", "1", kNone,
               "Median over joints and seeds of the stance NRMSE of adaptation over that of perfect knowledge."},
    FigureSpec{"trot.vary.adaptive_worst", "1", kAtMost, "Largest stance NRMSE of adaptation, any joint and seed."},
    FigureSpec{"trot.vary.adaptive_worst_within_supply", "1", kNone,
               "The same without the joints and seeds whose supply cannot carry, at rest, what perfect knowledge was asked for."},
    FigureSpec{"trot.vary.perfect_worst", "1", kNone, "Largest stance NRMSE of perfect knowledge, any joint and seed."},
    FigureSpec{"trot.vary.beyond_supply", "1", kNone, "Joints and seeds left out by adaptive_worst_within_supply."},
    FigureSpec{"trot.vary.adaptive_diverged", "1", kAtMost,
               "Joints and seeds in which adaptation tripped, was at null or damping while judged, or had a stance NRMSE above 1."},
    FigureSpec{"trot.vary.<controller>.seeds_failed", "1", kAtMost,
               "Seeds in which a joint diverged, as above, or had a stance NRMSE above 0.3."},
    FigureSpec{"trot.vary.<baseline>.median_ratio", "1", kNone,
               "Median stance NRMSE of a fixed baseline over that of adaptation: stance, swing, feedback_linearisation."},
    FigureSpec{"trot.vary.<baseline>.wins", "1", kNone,
               "Joints and seeds in which a fixed baseline has a smaller stance NRMSE than adaptation."},

    // trot --hide: an effect that only sim_bridge knows, looked for in the recordings of the run
    FigureSpec{"hide.seeds", "1", kNone, "Effects that were hidden, one at a time."},
    FigureSpec{"hide.named", "1", kAtLeast,
               "Seeds in which the joint with the largest held-out gain is the hidden one and its first effect the hidden effect."},
    FigureSpec{"hide.named_or_tied", "1", kNone, "The same where the hidden effect may also be one that the recording does not tell from a named one."},
    FigureSpec{"hide.false_joints", "1", kAtMost, "Joints that are as their file says and were suspected, all seeds."},
    FigureSpec{"hide.nrmse_nominal", "1", kNone, "Stance NRMSE of the hidden joints without what is hidden, mean over the seeds."},
    FigureSpec{"hide.nrmse_hidden", "1", kNone, "The same with it, known to nobody."},
    FigureSpec{"hide.nrmse_known", "1", kAtMost,
               "The same with what was found in the robot file of everybody, or known to nobody where nothing was found."},

    FigureSpec{"bench.lockstep.<vendor>.ticks_per_s", "1/s", kNone, "Ticks per second of a robot in lock-step over this vendor."},
    FigureSpec{"bench.lockstep.<vendor>.bare_ticks_per_s", "1/s", kNone,
               "Ticks per second of the bare vendor: the same samples between the same processes, nothing computed."},
    FigureSpec{"bench.lockstep.<vendor>.ratio", "1", kAtLeast, "The first over the second."},
    FigureSpec{"bench.plant.us_per_tick", "us", kNone, "Time to integrate twelve joints over one tick of 1 ms."},
    FigureSpec{"bench.plant.cvode_us_per_tick", "us", kNone, "The same with CVODE at equal error."},
    FigureSpec{"bench.plant.speedup", "1", kAtLeast, "The second over the first."},
    FigureSpec{"bench.plant.error", "1", kNone, "Largest error of the integrator against a converged solution, over the range of each state."},
    FigureSpec{"bench.plant.cvode_error", "1", kNone, "The same of CVODE."},
    FigureSpec{"bench.riccati.doubling_us", "us", kNone, "Time of one Riccati solution by structured doubling."},
    FigureSpec{"bench.riccati.iteration_us", "us", kNone, "Time of the same by iterating the Riccati recursion."},
    FigureSpec{"bench.riccati.slicot_us", "us", kNone, "Time of the same by SLICOT."},
    FigureSpec{"bench.riccati.speedup_iteration", "1", kAtLeast, "Time by iteration over time by doubling."},
    FigureSpec{"bench.riccati.speedup_slicot", "1", kAtLeast, "Time by SLICOT over time by doubling."},
    FigureSpec{"bench.riccati.relative_residual", "1", kAtMost, "Largest residual of the Riccati equation relative to its solution."},
    FigureSpec{"bench.control.step_ns", "ns", kNone, "Time of one step of the force controller."},
    FigureSpec{"bench.control.allocations", "1", kAtMost, "Allocations made by the steps of the force controller."},
    FigureSpec{"bench.rls.ns_per_update", "ns", kNone, "Time of one sample of recursive least squares: three measurements, four regressors."},
    FigureSpec{"bench.rls.ns_per_update_bias", "ns", kNone, "The same with five regressors."},
    FigureSpec{"bench.rls.textbook_ns_per_update", "ns", kNone,
               "Time of one sample of the textbook's form: twelve parameters, 12 x 12 covariance."},
    FigureSpec{"bench.rls.speedup", "1", kAtLeast, "The third over the first."},
    FigureSpec{"bench.rls.difference", "1", kAtMost, "Largest difference of the first and the third's estimates, over the largest parameter."},
    FigureSpec{"bench.rls.allocations", "1", kAtMost, "Allocations made by the samples."},
    FigureSpec{"bench.estimator.rls_ns", "ns", kNone, "Time of one tick of a joint's estimator with recursive least squares, four regressors."},
    FigureSpec{"bench.estimator.aff_ns", "ns", kNone, "Time of one tick of a joint's estimator with adaptive forgetting, four regressors."},
    FigureSpec{"bench.estimator.kalman_ns", "ns", kNone, "Time of one tick of a joint's estimator with the random walk, four regressors."},
    FigureSpec{"bench.estimator.iv_ns", "ns", kNone, "Time of one tick of a joint's estimator with instrumental variables, four regressors."},
    FigureSpec{"bench.estimator.vdf_ns", "ns", kNone, "Time of one tick of a joint's estimator with variable-direction forgetting, four regressors."},
    FigureSpec{"bench.estimator.sift_ns", "ns", kNone, "Time of one tick of a joint's estimator with forgetting in the subspace of information, four regressors."},
    FigureSpec{"bench.estimator.pe_gate_ns", "ns", kNone, "What the gate of persistent excitation adds to a tick."},
    FigureSpec{"bench.estimator.fft_gate_ns", "ns", kNone, "What the gate of frequencies adds to a tick."},
    FigureSpec{"bench.estimator.allocations", "1", kAtMost, "Allocations made by these ticks."},
    FigureSpec{"bench.greybox.tick_us", "us", kAtMost, "Time of one tick of the grey-box estimator of a joint, full-range motion, changes of load included."},
    FigureSpec{"bench.greybox.slowest_tick_us", "us", kNone, "Of the slowest of these ticks, which follows a change of load."},
    FigureSpec{"bench.greybox.estimate_us", "us", kNone, "Time of reading one estimate: model, standard errors, poles."},
    FigureSpec{"bench.greybox.allocations", "1", kAtMost, "Allocations made by these ticks and estimates."},
    FigureSpec{"bench.tick.us", "us", kAtMost,
               "Time of one tick of every joint of the robot on one core: control, estimation with poles, update logic, an estimate looked at in every tick, no redesign."},
    FigureSpec{"bench.tick.estimation_us", "us", kNone, "Time of the estimators alone, poles included."},
    FigureSpec{"bench.tick.update_logic_us", "us", kNone, "Time of the update logic alone."},
    FigureSpec{"bench.tick.control_us", "us", kNone, "Time of the joint nodes' steps alone."},
    FigureSpec{"bench.tick.allocations", "1", kAtMost, "Allocations made by these ticks."},
    FigureSpec{"bench.redesign.us", "us", kAtMost,
               "Time from an estimate that asks for new gains to these, every check included but the dwell time of the joint's two loops, which takes milliseconds; for the loop delay, of lock-step and real time, that takes longer."},
    FigureSpec{"bench.redesign.lqr_us", "us", kNone, "Time of the LQR design in it."},
    FigureSpec{"bench.redesign.allocations", "1", kAtMost, "Allocations made by these redesigns."},
    FigureSpec{"reproduce.<chapter>.<number>.<claim>", "its own", kNone,
               "What was measured for a claim of Hubacher (2014) about its figure of that number; farrier reproduce --list names every claim with its unit, relation and bound."},
    FigureSpec{"reproduce.<chapter>.<number>.<method>.<signal>.<sensors>.<figure>", "its own", kNone,
               "Table 6.1: largest error after any of the three changes of load, of that method in that cell, by perfect sensors (clean) or those of fc1d.yaml (noisy): gain_dB and phase_deg of the load-cell transfer function over 0.5 to 100 Hz, mass over the mass."},
    FigureSpec{"reproduce.<chapter>.<number>.<method>.<signal>.<claim>", "its own", kNone,
               "The same about a cell of a table: the method it is about and the valve's signal."},
    // diagnose: a recording against the model of a joint; channels are valve_and_oil, load and velocity_sensor
    FigureSpec{"diagnose.<channel>.one_step_nrmse_before", "1", kNone,
               "RMS error of the simulation one sample ahead over the standard deviation of what was measured, on time no fit has seen: the model as given, its constants fitted within 3 %."},
    FigureSpec{"diagnose.<channel>.one_step_nrmse_after", "1", kNone, "The same of the extended model."},
    FigureSpec{"diagnose.<channel>.ahead_50ms_nrmse_before", "1", kNone, "The same 50 ms ahead, the model as given."},
    FigureSpec{"diagnose.<channel>.ahead_50ms_nrmse_after", "1", kNone, "The same of the extended model."},
    FigureSpec{"diagnose.<channel>.free_running_nrmse_before", "1", kNone, "The same of a simulation that runs freely, the model as given."},
    FigureSpec{"diagnose.<channel>.free_running_nrmse_after", "1", kNone, "The same of the extended model."},
    FigureSpec{"diagnose.<channel>.whiteness_before", "1", kNone,
               "Largest autocorrelation of the residual at lags 1 to 100 times the root of the samples; below 4: white."},
    FigureSpec{"diagnose.<channel>.whiteness_after", "1", kNone, "The same of the extended model."},
    FigureSpec{"diagnose.<channel>.cross_correlation_before", "1", kNone,
               "Largest correlation of the residual with the channel's input at lags -50 to 50 times the root of the samples."},
    FigureSpec{"diagnose.<channel>.cross_correlation_after", "1", kNone, "The same of the extended model."},
    FigureSpec{"diagnose.held_out_nrmse_before", "1", kNone, "Mean square over the channels that were judged: the model as given."},
    FigureSpec{"diagnose.held_out_nrmse_after", "1", kNone, "The same of the extended model."},
    FigureSpec{"diagnose.held_out_ratio", "1", kNone, "The first over the second."},
    FigureSpec{"diagnose.effects", "1", kNone, "Effects that were named."},
    FigureSpec{"diagnose.fit_before_percent", "%", kNone,
               "--units scaled: 100 (1 - |y - s| / |y - mean y|), linear model s fitted to half, free on the other y."},
    FigureSpec{"diagnose.fit_after_percent", "%", kNone, "The same of the model with the effects found."},
    FigureSpec{"diagnose.<effect>.fit_percent", "%", kNone, "The same with this effect alone, accepted or not."},
    FigureSpec{"diagnose.control.old_nrmse", "1", kNone,
               "RMS of force's error over reference's deviation on the extended model, controller for the given one."},
    FigureSpec{"diagnose.control.new_nrmse", "1", kNone, "The same, controller that knows the effects."},
    FigureSpec{"diagnose.control.ratio", "1", kNone, "The first over the second."},
    // diagnose --benchmark: shares are of trials whose hidden effects change the held-out error by more than 10 %
    FigureSpec{"diagnose.benchmark.trials", "1", kNone, "Blind trials that were run."},
    FigureSpec{"diagnose.benchmark.counted", "1", kNone, "Those that hide one effect of the library and count."},
    FigureSpec{"diagnose.benchmark.named", "1", kAtLeast,
               "Of the counted: the effect is named first, or in a pair that the recording does not tell apart."},
    FigureSpec{"diagnose.benchmark.first_alone", "1", kAtLeast, "Of the counted: it is named first and alone."},
    FigureSpec{"diagnose.benchmark.within_tolerance", "1", kAtLeast,
               "Of those: its parameter is within 15 % of its distance from neutral."},
    FigureSpec{"diagnose.benchmark.false_alarms", "1", kAtMost, "Of trials that hide nothing: something is named."},
    FigureSpec{"diagnose.benchmark.outside_admitted", "1", kAtLeast,
               "Of trials with an effect outside the library: unknown or cannot_separate."},
    FigureSpec{"diagnose.benchmark.pairs_named", "1", kAtLeast, "Of trials with two effects: both are named."},
    FigureSpec{"diagnose.benchmark.confidently_wrong", "1", kAtMost,
               "Of all trials: an effect that is not there is named with a confidence above 0.9."},
    FigureSpec{"diagnose.benchmark.median_gain", "1", kAtLeast,
               "Held-out error before over after, median of trials with effects of the library."},
    FigureSpec{"diagnose.benchmark.controlled", "1", kNone, "Trials that named an effect which a controller can use."},
    FigureSpec{"diagnose.benchmark.control_gain", "1", kAtLeast,
               "Of them, median: tracking error of the nominal controller over that of one that knows what was named."},
    FigureSpec{"diagnose.benchmark.effect.<effect>.control_gain", "1", kNone, "As diagnose.benchmark.control_gain."},
    FigureSpec{"diagnose.benchmark.effect.<effect>.counted", "1", kNone, "Trials of this effect that count."},
    FigureSpec{"diagnose.benchmark.effect.<effect>.named", "1", kNone, "Of them: as diagnose.benchmark.named."},
    FigureSpec{"diagnose.benchmark.effect.<effect>.first_alone", "1", kNone, "As diagnose.benchmark.first_alone."},
    FigureSpec{"diagnose.benchmark.effect.<effect>.within_tolerance", "1", kNone,
               "As diagnose.benchmark.within_tolerance."},
};
// clang-format on

// Cuts the first dotted part off `rest`.
std::string_view next_part(std::string_view& rest) noexcept {
  const std::size_t dot = rest.find('.');
  const std::string_view part = rest.substr(0, dot);
  rest = dot == std::string_view::npos ? std::string_view{} : rest.substr(dot + 1);
  return part;
}

// What the angle brackets stand for in one part: <joint>, light_<quarter>, <quarter>_nrmse; never nothing.
std::optional<std::string_view> placeholder(std::string_view wanted, std::string_view given) noexcept {
  const std::size_t open = wanted.find('<');
  const std::size_t close = wanted.find('>');
  if (open == std::string_view::npos || close == std::string_view::npos) {
    return std::nullopt;
  }
  const std::string_view before = wanted.substr(0, open);
  const std::string_view after = wanted.substr(close + 1);
  if (given.size() <= before.size() + after.size() || !given.starts_with(before) || !given.ends_with(after)) {
    return std::nullopt;
  }
  return given.substr(before.size(), given.size() - before.size() - after.size());
}

}  // namespace

std::span<const FigureSpec> figure_specs() noexcept { return kSpecs; }

std::optional<std::vector<std::string_view>> match(std::string_view pattern, std::string_view name) {
  std::vector<std::string_view> names;
  while (!pattern.empty() && !name.empty()) {
    const std::string_view wanted = next_part(pattern);
    const std::string_view given = next_part(name);
    if (const auto stands_for = placeholder(wanted, given)) {
      names.push_back(*stands_for);
    } else if (wanted != given) {
      return std::nullopt;
    }
  }
  if (!pattern.empty() || !name.empty()) {
    return std::nullopt;
  }
  return names;
}

const FigureSpec* find_spec(std::string_view name) noexcept {
  for (const FigureSpec& spec : kSpecs) {
    if (match(spec.pattern, name)) {
      return &spec;
    }
  }
  return nullptr;
}

std::string figures_table_markdown() {
  std::string table = "| figure | unit | bound | meaning |\n|---|---|---|---|\n";
  for (const FigureSpec& spec : kSpecs) {
    table += "| `" + std::string(spec.pattern) + "` | " + spec.unit + " | " +
             (spec.relation == kNone ? "" : "`" + std::string(to_string(spec.relation)) + "`") + " | " + spec.sentence +
             " |\n";
  }
  return table;
}

}  // namespace farrier::report
