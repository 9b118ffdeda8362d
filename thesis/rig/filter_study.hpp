#pragma once

#include <vector>

#include "control/law/low_pass.hpp"
#include "core/result.hpp"
#include "robot/robot.hpp"
#include "signals/signals.hpp"

namespace farrier::thesis {

/// Properties of the sensors in a run of the filter study.
struct FilterCase {
  double velocity_cut_off_Hz = 0.0;  ///< 0: none
  int order = 2;                     ///< 1 or 2, with the robot file's damping or 0.7071
  bool oversampled = false;          ///< kStudyConversions a tick behind an analog low-pass of kStudyAntiAlias_Hz
};

inline constexpr int kStudyConversions = 8;
inline constexpr double kStudyAntiAlias_Hz = 1500.0;

/// The cases of Hubacher (2014), 10.2 and 10.3: no filter, and 400, 200, 100 and 50 Hz at both orders; plain, then
/// oversampled.
std::vector<FilterCase> filter_cases();

/// Result of one case.
struct FilterRow {
  FilterCase filter;
  double load_mass_kg = 0.0;                 ///< on the rig, and what the gains are for
  double nrmse = 0.0;                        ///< RMS(F_ref - F) / RMS(F_ref); above 1, or not finite: it tracks nothing
  double current_step_rms_A = 0.0;           ///< RMS of the valve current's change from tick to tick: what noise does
  bool stayed_armed = false;                 ///< no joint left tracking, and no valve was at its limit
  control::FilterCoefficients velocity_filter;  ///< as the loop has it at each tick
  double conversion_delay_ticks = 0.0;       ///< mean age of the conversions in a sample
  signals::JointControllerGains gains;       ///< that acted
};

/// The rig under its multisine for `duration_s` in process, fixed LQR for the load it carries, once with the light load
/// (swing) and once with the heavy one (stance) per case, in that order. Judged from 0.2 s after the lead-in on; no
/// probing current. Refuses robots with more than one joint, cases no sensor can be and runs that do not run, with the
/// reason.
Result<std::vector<FilterRow>> filter_study(const robot::Robot& rig, const std::vector<FilterCase>& cases,
                                            double duration_s = 2.0, std::uint64_t seed = 1);

}  // namespace farrier::thesis
