#include <array>

#include "report/figures/figure_registries.hpp"

namespace farrier::report {
namespace {

using enum Relation;

// clang-format off
constexpr std::array kBodySpecs{
    // trial body: the worst over the runs of a trial, of those without a fall where a mean is taken
    FigureSpec{"body.<trial>.runs", "1", kNone, "Runs of a trial of farrier trial body."},
    FigureSpec{"body.<trial>.falls", "1", kAtMost,
               "Runs in which the trunk sank below half its height at the start, tilted by more than 45 degrees, or moved too wildly to be simulated."},
    FigureSpec{"body.<trial>.upright_share", "1", kAtLeast, "Share of the runs without a fall."},
    FigureSpec{"body.<trial>.height_rms_mm", "mm", kAtMost, "RMS of the trunk's height above the ground's plane about its mean."},
    FigureSpec{"body.<trial>.height_offset_mm", "mm", kAtMost, "Distance of that mean from the default height."},
    FigureSpec{"body.<trial>.sag_mm", "mm", kNone, "Largest depth of the trunk below the default height in a settled trot."},
    FigureSpec{"body.<trial>.sag_after_2_s_mm", "mm", kAtMost, "The same from 2 s after a load is put on the trunk."},
    FigureSpec{"body.<trial>.tilt_rms_deg", "deg", kAtMost, "RMS of the angle between the trunk's z axis and the ground's normal."},
    FigureSpec{"body.<trial>.speed_error_percent", "%", kAtMost,
               "Distance of the mean velocity from the command, relative to it; on the spot that of the mean yaw rate."},
    FigureSpec{"body.<trial>.odometry_error_percent", "%", kAtMost,
               "Distance between estimated and true way since the trot began, over the length of the true one."},
    FigureSpec{"body.<trial>.heading_drift_deg_min", "deg/min", kAtMost,
               "Growth of the error of the estimated heading since the trot began, mean per minute."},
    FigureSpec{"body.<trial>.lateral_drift_m_min", "m/min", kAtMost,
               "Way of the trunk sideways from the commanded line, mean per minute; of commands that do not turn."},
    FigureSpec{"body.push_limit.<side>_Ns", "Ns", kNone,
               "Least tested impulse on the trunk from this side at which half of eight phases of the stride fell."},
    FigureSpec{"body.<trial>.force_nrmse.<place>.<phase>", "1", kNone,
               "Force error of all joints haa, hfe or kfe while their foot swings or stands: RMS over RMS of the reference."},
    FigureSpec{"body.<trial>.planned_switches", "1", kNone, "Planned changes of phase that the joints of all legs were told, over all runs."},
    FigureSpec{"body.<trial>.felt_switches", "1", kNone, "Touchdowns that locomotion felt before their plan and told the joints."},
    FigureSpec{"body.<trial>.late_touchdowns", "1", kNone, "True touchdowns that came while the joints had the gains of swing."},
    FigureSpec{"body.<trial>.mean_late_ms", "ms", kNone, "Mean time from such a touchdown to the gains of stance."},
    FigureSpec{"body.<trial>.largest_late_ms", "ms", kNone, "Longest of these times."},
    FigureSpec{"body.<trial>.energy_error_percent", "%", kAtMost,
               "Work of the pump that the account of supply, oil and body does not find again."},
    FigureSpec{"body.<trial>.least_supply_bar", "bar", kNone, "Least pressure of the shared supply."},
    FigureSpec{"body.<trial>.mean_flow_l_min", "l/min", kNone,
               "Mean flow into the valves, their leakage included."},
    FigureSpec{"body.<trial>.energy_J_m", "J/m", kNone,
               "Work of the pump without what the relief valve spills, per way of the trunk; the largest run."},
    FigureSpec{"body.energy.<term>_J", "J", kNone, "A term of the account of the pump's work over 10 s, the mean of the runs."},
    FigureSpec{"body.energy.residual_percent", "%", kAtMost,
               "Work of the pump that the other terms do not find again; the largest run."},
    FigureSpec{"body.energy.half_step.<figure>_percent", "%", kAtMost,
               "Change of the median of height_rms, tilt_rms or kfe_stance_nrmse with half the step."},
    // trials with a fault of the supply or of an actuator; seconds are since the fault
    FigureSpec{"body.<trial>.acted", "1", kAtMost, "Runs in which locomotion stood or lay down because of the supply or of a joint."},
    FigureSpec{"body.<trial>.slowed", "1", kAtMost, "Runs in which locomotion trotted more slowly because of the supply."},
    FigureSpec{"body.<trial>.not_recovered", "1", kAtMost,
               "Runs that end with less pressure than that from which on a trot slows down."},
    FigureSpec{"body.<trial>.hard_landings", "1", kAtMost,
               "Runs in which the robot fell, never lay, or sank at 0.5 m/s or more."},
    FigureSpec{"body.<trial>.slows_s", "s", kNone, "Time until locomotion trots more slowly; the earliest run."},
    FigureSpec{"body.<trial>.end_speed_m_s", "m/s", kNone,
               "Speed of the trunk from 10 s after the fault to the end, mean of the runs."},
    FigureSpec{"body.<trial>.unnoticed_sags", "1", kAtMost,
               "Runs in which the trunk was 20 mm too low before the supply counted as low."},
    FigureSpec{"body.<trial>.not_lying", "1", kAtMost, "Runs in which the robot never lay."},
    FigureSpec{"body.<trial>.low_s", "s", kNone, "Time to the first sample of the supply that is low; the latest run."},
    FigureSpec{"body.<trial>.sag_20mm_s", "s", kNone, "Time until the trunk is 20 mm too low; the earliest run."},
    FigureSpec{"body.<trial>.acts_s", "s", kNone, "Time until locomotion acts; the earliest run."},
    FigureSpec{"body.<trial>.lying_s", "s", kNone, "Time until the trunk has the height of a robot that lies; the latest run."},
    FigureSpec{"body.<trial>.sinking_m_s", "m/s", kNone, "Largest speed of the trunk downwards."},
    FigureSpec{"body.<trial>.foot_force_N", "N", kNone, "Largest force on a foot, the mean of a tick."},
    FigureSpec{"body.<trial>.largest_torque_Nm", "Nm", kNone, "Largest torque of any joint, falls included."},
    // compare body
    FigureSpec{"compare.body.<contender>.walk_falls", "1", kNone, "Walks of farrier compare body that ended with a fall."},
    FigureSpec{"compare.body.<contender>.step_falls", "1", kNone, "The same of walks up a step."},
    FigureSpec{"compare.body.<contender>.height_rms_mm", "mm", kNone, "As body.<trial>.height_rms_mm, median over the walks without a fall."},
    FigureSpec{"compare.body.<contender>.force_nrmse.<place>.<phase>", "1", kNone, "As body.<trial>.force_nrmse, median over the walks without a fall."},
    // compare adaptation
    FigureSpec{"compare.adaptation.<row>.<condition>.<design>.runs", "1", kNone, "Runs of farrier compare adaptation."},
    FigureSpec{"compare.adaptation.<row>.<condition>.<design>.falls", "1", kNone, "Those in which the robot fell or lay down: it walks at less than half of the speed asked."},
    FigureSpec{"compare.adaptation.<row>.<condition>.<design>.fall_share_low", "1", kNone, "Lower end of the 95 % interval of the share that falls (Wilson 1927)."},
    FigureSpec{"compare.adaptation.<row>.<condition>.<design>.fall_share_high", "1", kNone, "Its upper end."},
    FigureSpec{"compare.adaptation.<row>.<condition>.<design>.stance_nrmse", "1", kNone, "RMS over the kinds of joint of the force error in stance, median over the runs without a fall."},
    FigureSpec{"compare.adaptation.<row>.<condition>.<design>.height_rms_mm", "mm", kNone, "As body.<trial>.height_rms_mm, median over the runs without a fall."},
    FigureSpec{"compare.adaptation.<row>.<condition>.<design>.speed_error", "1", kNone, "Relative error of the mean speed, likewise."},
    FigureSpec{"compare.adaptation.<row>.<condition>.<design>.energy_J_m", "J/m", kNone, "Work of the pump per way of the trunk, likewise."},
    FigureSpec{"compare.adaptation.<row>.<condition>.ratio_to_perfect", "1", kAtMost, "Force error of the adaptive design over that of perfect knowledge."},
    FigureSpec{"compare.adaptation.lost", "1", kAtMost, "Runs that perfect knowledge survives and adaptation does not, same row, condition and seed."},
    FigureSpec{"compare.adaptation.caused", "1", kAtMost, "The same with the file's fixed design in place of perfect knowledge."},
    // compare body --estimators: <estimators> is estimator, or estimator_ideal_valve of a robot with ideal valves
    FigureSpec{"compare.body.<estimators>.<method>.<place>.<phase>.valid_share", "1", kNone,
               "Share of the estimates of a walk with at least the validity that the update logic asks for."},
    FigureSpec{"compare.body.<estimators>.<method>.<place>.<phase>.usable_share", "1", kNone, "Share that no flag forbids."},
    FigureSpec{"compare.body.<estimators>.<method>.<place>.<phase>.valve_ratio", "1", kNone,
               "Effect of the valve on the force, or the valve gain of the grey box, over the true one; median of the usable estimates."},
    FigureSpec{"compare.body.<estimators>.<method>.<place>.<phase>.oil_ratio", "1", kNone,
               "Effect of the velocity on the force, or the bulk modulus of the grey box, over the true one."},
    FigureSpec{"compare.body.<estimators>.<method>.<place>.<phase>.load_ratio", "1", kNone,
               "Load over that of the mass matrix at home."},
    FigureSpec{"compare.body.<estimators>.<method>.<place>.<phase>.misfit", "1", kNone, "RMS error of the estimator's force predictions over that from noise."},
    FigureSpec{"compare.body.<estimators>.<method>.<place>.<phase>.force_error", "1", kNone,
               "RMS error of the predicted change of the true force over a tick, over the RMS change."},
    FigureSpec{"compare.body.adapting.<controller>.<estimator>.walk_falls", "1", kNone, "Walks with adapting or fixed gains that ended with a fall."},
    FigureSpec{"compare.body.adapting.<controller>.<estimator>.step_falls", "1", kNone, "The same of walks up a step."},
    FigureSpec{"compare.body.adapting.<controller>.<estimator>.updates", "1", kNone, "Estimates that became gains, over all runs."},
    FigureSpec{"compare.body.adapting.<controller>.<estimator>.refused", "1", kNone, "Designs that the supervisor or a joint refused, over all runs."},
    FigureSpec{"compare.body.adapting.<controller>.<estimator>.invalid_updates", "1", kAtMost, "Updates from an estimate that is not valid."},
    FigureSpec{"compare.body.adapting.<controller>.<estimator>.height_rms_mm", "mm", kNone, "As compare.body.<contender>.height_rms_mm."},
    FigureSpec{"compare.body.adapting.<controller>.<estimator>.kfe_stance_nrmse", "1", kNone, "As compare.body.<contender>.force_nrmse.kfe.stance."},
    FigureSpec{"compare.body.knowledge_ratio.<place>.<phase>", "1", kAtMost, "Force error of the file's design over that of perfect knowledge."},
};
// clang-format on

}  // namespace

std::span<const FigureSpec> body_figure_specs() noexcept { return kBodySpecs; }

}  // namespace farrier::report
