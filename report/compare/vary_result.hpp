#pragma once

// Result of `farrier compare varied`: one row for every seed, controller and joint.

#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <span>
#include <string>
#include <vector>

#include "core/result.hpp"
#include "report/figures/figures.hpp"

namespace farrier::report {

/// Controllers that are compared on a varied robot.
enum class Contender {
  kAdaptive,               ///< knows the nominal robot and what it measures
  kPerfect,                ///< designed for the varied robot, switched at the actual touchdowns: no robot can have it
  kStance,                 ///< one design for the nominal stance load
  kSwing,                  ///< one design for the nominal swing load
  kFeedbackLinearisation,  ///< inverts the nominal flow law
  kPid,                    ///< the gains of the robot file
  kGreyBox,                ///< inverts the flow law with the physics it estimates
};
/// Those of compare varied.
inline constexpr std::array kContenders{Contender::kAdaptive, Contender::kPerfect, Contender::kStance,
                                        Contender::kSwing, Contender::kFeedbackLinearisation};

/// As in figures and files: "adaptive", "perfect", "stance", "swing", "feedback_linearisation", "pid", "greybox".
const char* to_string(Contender contender) noexcept;

inline constexpr double kFailedNrmse = 0.3;

/// NaN counts as worse than any number.
inline double infinite_if_lost(double nrmse) noexcept {
  return std::isnan(nrmse) ? std::numeric_limits<double>::infinity() : nrmse;
}

/// One joint under one contender in one seed's robot.
struct VaryRow {
  std::uint64_t seed = 0;
  Contender contender = Contender::kAdaptive;
  std::string joint;
  double supply_factor = 1.0, friction_factor = 1.0, valve_factor = 1.0;  ///< drawn, over nominal
  double stance_mass_kg_or_kgm2 = 0.0;                                    ///< drawn
  double peak_demand = 0.0;  ///< largest reference in judged stance over what the drawn supply gives at rest
  double stance_nrmse = 0.0, swing_nrmse = 0.0;  ///< as track() judges, phases by the plan for every contender
  bool left_tracking = false;                    ///< tripped at any tick, or at null or damping at a judged one

  /// No torque source at all: it left tracking, or its stance NRMSE is above 1 or not a number.
  bool diverged() const noexcept { return left_tracking || !(stance_nrmse <= 1.0); }
  /// It diverged, or its stance NRMSE is above kFailedNrmse: a third of what it was to follow.
  bool failed() const noexcept { return diverged() || stance_nrmse > kFailedNrmse; }
};

inline constexpr double kWorstAdaptive = 0.15;
inline constexpr double kMedianRatioPerfect = 1.3;

/// Adds trot.vary.*. Every seed has a row for each contender and joint.
void add_vary(Figures& figures, std::span<const VaryRow> rows);

/// Text for people: a line per contender, then lines for joints and seeds in which a fixed baseline was better than
/// adaptation. These begin with the widest margins and are at most `longest` (the CSV has all).
std::string vary_text(std::span<const VaryRow> rows, std::size_t longest);

/// Every row as CSV with a header line. Refuses if the disk does not take all of it.
Result<Done> write_vary_csv(const std::string& path, std::span<const VaryRow> rows);

}  // namespace farrier::report
