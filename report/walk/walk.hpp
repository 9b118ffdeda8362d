#pragma once

// A walk of the whole robot: what its body did, from the truth of the simulation.

#include <Eigen/Core>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "report/figures/outcome.hpp"
#include "signals/signals.hpp"

namespace farrier::report {

/// The walk that was asked for.
struct WalkPlan {
  double period_s;
  double forward_m_s, left_m_s, yaw_rate_rad_s;
  double height_m;         ///< of the trunk above the ground, wanted
  double walk_s;           ///< from here on the robot was to walk; from the settled trot on it is judged
  Eigen::Vector3d normal;  ///< of the ground's plane
  bool plain;              ///< level ground without pushes and payloads: the figures have bounds
};

inline constexpr double kMillimetres = 1000.0;  ///< of a metre

/// Time from the command to walk until means count.
inline constexpr double kWalkSettles_s = 4.0;

struct WalkFigures {
  std::optional<double> fell_s;  ///< when
  std::string reason;            ///< of the fall
  double seconds = 0.0;          ///< judged
  double way_m = 0.0;            ///< horizontally, from walk_s on
  double height_rms_m = 0.0, height_offset_m = 0.0, tilt_rms_rad = 0.0;
  double speed_error = 0.0;          ///< relative to the command; of the yaw rate where no velocity is asked for
  double lateral_drift_m_min = 0.0;  ///< of the trunk from the commanded line, per minute
  double largest_foot_force_N = 0.0;
};

/// Judges the truth, in the order of its ticks.
WalkFigures judge_walk(const WalkPlan& plan, std::span<const signals::BodyTruth> truth);

/// Adds trot.body.*.
void add_walk(Figures& figures, const WalkPlan& plan, const WalkFigures& walk);

/// A sentence for people: "walked 4.8 m without a fall" or "fell after 9.3 s: ...".
std::string walk_text(const WalkFigures& walk);

}  // namespace farrier::report
