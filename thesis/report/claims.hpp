#pragma once

#include <string>
#include <vector>

#include "thesis/study/study.hpp"
#include "report/figures/outcome.hpp"

namespace farrier::thesis {

/// A study with what came of it.
struct StudyRun {
  thesis::Study study;
  Result<thesis::StudyResult> result;
};

/// Every claim of the study in its order, judged. A claim that was not measured fails and says so; so do all of a
/// study that could not run. A measurement without a claim is a bug and aborts.
std::vector<report::Claim> claims_of(const StudyRun& run);

/// Adds the claims and their figures to the outcome. A claim that holds or fails bounds its figure; one that is refuted
/// does not, for it is the text that is wrong.
void add_claims(report::Outcome& outcome, const std::vector<report::Claim>& claims);

/// Adds the figures of a study that no claim judges.
void add_figures(report::Outcome& outcome, const StudyRun& run);

/// "8.9.order  0.998 >= 1.5  refuted", with sentence and reason, for a terminal.
std::string claim_text(const report::Claim& claim);
/// "6.1.aff.rich_low.clean.gain_dB  1.2 dB"
std::string figure_text(const thesis::StudyFigure& figure);

/// "8.9  Iterative solution ..." and each claim with the sentence it comes from and what must hold.
std::string listing(const thesis::Study& study);

}  // namespace farrier::thesis
