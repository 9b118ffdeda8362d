#include <array>

#include "report/figures/figure_registries.hpp"

namespace farrier::report {
namespace {

using enum Relation;

// clang-format off
constexpr std::array kDiagnosisSpecs{
    // diagnose: a recording against the model of a joint; channels are valve_and_oil or drive, load and velocity_sensor
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
    FigureSpec{"diagnose.wiring.recordings", "1", kNone, "diagnose --wiring: recordings into which a fault was put."},
    FigureSpec{"diagnose.wiring.named_first", "1", kAtLeast, "Of them: the fault is named first."},
    FigureSpec{"diagnose.wiring.named", "1", kNone, "Of them: the fault is among those that may be meant."},
    FigureSpec{"diagnose.wiring.another_named", "1", kAtMost, "Of them: only other faults are named."},
    FigureSpec{"diagnose.wiring.trials", "1", kNone, "Blind trials without a fault of wiring that were run."},
    FigureSpec{"diagnose.wiring.false_alarms", "1", kAtMost, "In these: faults of wiring that were named."},
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
    FigureSpec{"diagnose.benchmark.outside_unknown", "1", kAtLeast, "Of these: unknown."},
    FigureSpec{"diagnose.benchmark.sets_of_<effects>_named", "1", kNone,
               "Of trials with so many effects: all are named."},
    FigureSpec{"diagnose.benchmark.separable_sets_of_<effects>_counted", "1", kNone,
               "Trials with so many effects that their recordings can separate, as --what-can-be-told --set says."},
    FigureSpec{"diagnose.benchmark.separable_sets_of_<effects>_named", "1", kAtLeast,
               "Of these: all are named. Bounded for two to four."},
    FigureSpec{"diagnose.benchmark.set_names_wrong", "1", kNone,
               "Of the names in trials of several effects: no such effect is hidden."},
    FigureSpec{"diagnose.benchmark.median_size_error", "1", kAtMost,
               "Error of a named value over the hidden effect's distance from neutral, median of all names that are hidden."},
    FigureSpec{"diagnose.benchmark.median_s", "s", kNone, "Processor time of one diagnosis, median of the trials."},
    FigureSpec{"diagnose.benchmark.confidently_wrong", "1", kAtMost,
               "Of all trials: an effect that is not there is named with a confidence above 0.9."},
    FigureSpec{"diagnose.benchmark.statements", "1", kNone, "Names in all trials, each with a confidence."},
    FigureSpec{"diagnose.benchmark.brier", "1", kNone,
               "Mean over the names of the square of confidence less 1 if such an effect is hidden, else 0."},
    FigureSpec{"diagnose.benchmark.spiegelhalter_z", "1", kAtMost,
               "Spiegelhalter's z of these confidences, its magnitude: of standard normal distribution if they are true."},
    FigureSpec{"diagnose.benchmark.calibration_error", "1", kNone,
               "Mean over tenths of the names, by confidence, of the distance of mean confidence from share that is right."},
    FigureSpec{"diagnose.benchmark.calibration_expected", "1", kNone, "The mean of this error if confidences are true."},
    FigureSpec{"diagnose.benchmark.calibration_excess", "1", kAtMost, "The first less the second."},
    FigureSpec{"diagnose.benchmark.most_confidence", "1", kAtMost,
               "Largest confidence; bounded by 1 - 1/n, n the trials that confidences are fitted to."},
    FigureSpec{"diagnose.benchmark.sizes", "1", kNone, "Names whose effect is hidden, each with a size."},
    FigureSpec{"diagnose.benchmark.interval_coverage", "1", kAtLeast, "Of them: the 95 % interval has the hidden size."},
    FigureSpec{"diagnose.benchmark.interval_coverage_low", "1", kAtMost,
               "Lower end of the 95 % interval of that share (Wilson 1927)."},
    FigureSpec{"diagnose.benchmark.interval_coverage_high", "1", kAtLeast, "Its upper end."},
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
    // diagnose --benchmark --healthy
    FigureSpec{"diagnose.healthy.robots", "1", kNone, "Healthy robots of which every joint was diagnosed."},
    FigureSpec{"diagnose.healthy.joints", "1", kNone, "Joints that were diagnosed."},
    FigureSpec{"diagnose.healthy.alarms", "1", kAtMost, "Robots with a joint whose verdict is not none."},
    FigureSpec{"diagnose.healthy.joint_alarms", "1", kNone, "Joints with such a verdict."},
    FigureSpec{"diagnose.healthy.alarms_high", "1", kNone,
               "Upper end of the 95 % interval of the share of robots with an alarm (Wilson 1927)."},
    FigureSpec{"diagnose.healthy.median_s", "s", kNone, "Processor time of one joint's diagnosis, median."},
    // trial hide --controllers
    FigureSpec{"hide.controllers.seeds", "1", kNone, "trial hide --controllers: effects that were hidden, one at a time."},
    FigureSpec{"hide.controllers.same_name", "1", kAtLeast,
               "Of them: the same effect is named first under all kinds of controllers."},
    FigureSpec{"hide.controllers.size_spread", "1", kAtMost,
               "Largest difference of its sizes under two controllers over their mean, the worst of these."},
};
// clang-format on

}  // namespace

std::span<const FigureSpec> diagnosis_figure_specs() noexcept { return kDiagnosisSpecs; }

}  // namespace farrier::report
