#pragma once

// Result of `farrier compare adaptation`.

#include <span>
#include <string>
#include <vector>

#include "report/figures/figures.hpp"
#include "trials/body/adaptation_study.hpp"
#include "trials/body/fixed_search.hpp"

namespace farrier::report {

/// Bounds on the adaptive design's force error in stance over perfect knowledge: after steps and in drifts, and where one
/// fixed design is as good.
inline constexpr double kAdaptiveRatioAtMost = 1.3;
inline constexpr double kNoCostRatioAtMost = 1.1;

/// The runs of a design in a row under a condition.
struct AdaptationCell {
  std::string design;
  int runs = 0, falls = 0;
  // Medians over the runs without a fall; 0 if all fell:
  double stance_nrmse = 0.0, height_rms_m = 0.0, speed_error = 0.0, energy_J_m = 0.0;
};

/// All designs in a row under a condition.
struct AdaptationRow {
  std::string row, condition;
  bool moves = false;  ///< a step or a drift
  std::vector<AdaptationCell> cells;
  int lost = 0;    ///< seeds with which perfect knowledge walks and the adaptive design falls
  int caused = 0;  ///< seeds with which the file's fixed design walks and the adaptive one falls
  /// Force error of the adaptive design over that of perfect knowledge, and of the tuned one; none where all runs of one
  /// of them fell.
  std::optional<double> ratio = std::nullopt, tuned_ratio = std::nullopt;
};

/// Puts runs together: one AdaptationRow for each row and condition that has runs, in the order of the study.
std::vector<AdaptationRow> adaptation_rows(std::span<const trials::StudyDesign> designs,
                                           std::span<const trials::TrotRow> runs);

/// Adds compare.adaptation.*.
void add_adaptation(Figures& figures, std::span<const AdaptationRow> rows);

/// For people: a line for each row and condition, with falls and force error of every design.
std::string adaptation_text(std::span<const AdaptationRow> rows);

/// Candidates of a search, the best first.
std::string search_text(std::span<const trials::FixedSearch::Candidate> candidates);

}  // namespace farrier::report
