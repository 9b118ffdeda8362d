#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/result.hpp"
#include "report/figures/figures.hpp"
#include "report/figures/run_info.hpp"

namespace farrier::report {

/// A condition under which a claim was measured, too.
struct ClaimCondition {
  std::string name;     ///< "strong filters"
  std::string meaning;  ///< a sentence
  std::string source;   ///< of the condition
  double value;         ///< as the claim's
  double worst;
};

/// A statement of a text, measured. Its figure stands among the outcome's too.
struct Claim {
  std::string id;        ///< "7.8.quarter_2"
  std::string figure;    ///< of the text: "7.8"
  std::string section;   ///< of the text: "7.5"
  std::string sentence;  ///< its own words
  std::string claim;     ///< what was measured for it
  std::string name;      ///< of the figure: "reproduce.7.8.quarter_2"
  double value;          ///< the median over the seeds
  std::string unit;
  Relation relation;
  double bound;
  std::string verdict;              ///< "holds", "needs", "refuted", "fails"
  std::string reason;               ///< the proof, the condition or the cause of a failure; a note when it holds
  std::string kind = "text";        ///< "text", "proof", "aim"
  std::vector<double> values = {};  ///< by seed; one if nothing is drawn
  double worst = 0.0;               ///< of them
  std::string tried = {};           ///< what was tried for one that fails
  std::optional<ClaimCondition> condition = std::nullopt;
};

/// Result of a command that measures.
struct Outcome {
  std::string command;  ///< "trot", "bench", ...
  Figures figures;
  RunInfo run;
  std::vector<std::string> failures;       ///< errors besides figures: "joint_node_lf ended with status 1"
  std::vector<std::string> warnings = {};  ///< what went wrong and fails nothing
  std::vector<Claim> claims = {};          ///< of a command that checks a text's
  std::string finding = {};                ///< the verdict in one word of a command that finds out; empty: pass or fail

  /// Every figure holds and nothing else failed.
  bool passes() const noexcept { return failures.empty() && figures.all_hold(); }
  std::string verdict() const { return !finding.empty() ? finding : passes() ? "pass" : "fail"; }
};

/// {"command", "verdict": "pass"|"fail" or the finding, "failures", "warnings" (only when there are any), "figures":
/// [{"name", "value", "unit"}], "totals" and "claims" (only when there are any), "run": {...}}. A figure with
/// a bound also has "relation", "bound", "holds". Totals count claims by kind and verdict: {"text": {"holds": 3}}. A claim
/// is {"id", "figure", "section", "sentence", "claim", "kind", "measured": {"name", "value", "worst", "by_seed", "unit",
/// "relation", "bound"}, "verdict", "reason"}, and "condition": {"name", "meaning", "source", "value", "worst"} and
/// "tried" where there are any. Values that are not finite are null.
std::string to_json(const Outcome& outcome);

/// Writes to_json() to `path`, as replace_file does; refuses what the disk does not take.
Result<Done> write_json(const std::string& path, const Outcome& outcome);

}  // namespace farrier::report
