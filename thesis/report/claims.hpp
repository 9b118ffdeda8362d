#pragma once

#include <string>
#include <vector>

#include "thesis/study/study.hpp"
#include "report/figures/outcome.hpp"

namespace farrier::thesis {

/// A run of a study with one seed.
struct SeedRun {
  std::uint64_t seed;
  Result<thesis::StudyResult> result;
};

/// A study with its runs: one per seed, or a single one if the study draws nothing.
struct StudyRun {
  thesis::Study study;
  std::vector<SeedRun> seeds;
};

/// The result whose pictures and figures are shown: that of the first seed; null if it could not run.
const StudyResult* shown(const StudyRun& run) noexcept;

/// Every claim of the study in its order, judged by the median over the seeds; of an even number, by the worse of the two
/// in the middle. A claim that was not measured fails and says so; so do all of a study that could not run. A measurement
/// without a claim is a bug and aborts.
std::vector<report::Claim> claims_of(const StudyRun& run);

/// Adds the claims, those that fail first, and their figures to the outcome. A claim that holds bounds its figure; no
/// other does.
void add_claims(report::Outcome& outcome, std::vector<report::Claim> claims);

/// Adds the figures of a study that no claim judges.
void add_figures(report::Outcome& outcome, const StudyRun& run);

/// "8.9.order  0.998 >= 1.5  refuted", with sentence and reason, for a terminal.
std::string claim_text(const report::Claim& claim);
/// "6.1.aff.rich_low.clean.gain_dB  1.2 dB"
std::string figure_text(const thesis::StudyFigure& figure);

/// "claims of the text: 200 hold, 5 need a condition, 10 are refuted, 3 fail" and a line for each other kind that has any.
std::string totals_text(const report::Outcome& outcome);

/// "8.9  Iterative solution ..." and each claim with the sentence it comes from and what must hold.
std::string listing(const thesis::Study& study);

}  // namespace farrier::thesis
