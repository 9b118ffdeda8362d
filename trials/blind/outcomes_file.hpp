#pragma once

#include <map>
#include <string>

#include "core/result.hpp"
#include "trials/blind/blind_trials.hpp"

namespace farrier::blind {

// Outcomes of trials, a line of JSON each, so that an interrupted benchmark goes on where it was.

/// Appends the outcome of trial `index`. `origin` names all that outcomes depend on. Refuses a file that cannot be written.
Result<Done> append_outcome(const std::string& path, const std::string& origin, std::size_t index,
                            const Outcome& outcome);

/// Returns the outcomes of this origin by the index of their trial; none where there is no file. Their `plan` is `plans`'.
std::map<std::size_t, Outcome> read_outcomes(const std::string& path, const std::string& origin,
                                             const std::vector<TrialPlan>& plans);

}  // namespace farrier::blind
