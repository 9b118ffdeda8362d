#pragma once

#include <string>
#include <vector>

#include "core/result.hpp"
#include "report/figures/figures.hpp"
#include "report/figures/run_info.hpp"

namespace farrier::report {

/// A statement of a text, measured. Its figure stands among the outcome's too.
struct Claim {
  std::string id;        ///< "7.8.quarter_2"
  std::string figure;    ///< of the text: "7.8"
  std::string section;   ///< of the text: "7.5"
  std::string sentence;  ///< its own words
  std::string claim;     ///< what was measured for it
  std::string name;      ///< of the figure: "reproduce.7.8.quarter_2"
  double value;
  std::string unit;
  Relation relation;
  double bound;
  std::string verdict;   ///< "holds", "refuted", "fails"
  std::string reason;    ///< why it is refuted or fails; empty when it holds
};

/// Result of a command that measures.
struct Outcome {
  std::string command;  ///< "trot", "bench", ...
  Figures figures;
  RunInfo run;
  std::vector<std::string> failures;  ///< errors besides figures: "joint_node_lf ended with status 1"
  std::vector<std::string> warnings = {};  ///< what went wrong and fails nothing
  std::vector<Claim> claims = {};          ///< of a command that checks a text's
  std::string finding = {};                ///< the verdict in one word of a command that finds out; empty: pass or fail

  /// Every figure holds and nothing else failed.
  bool passes() const noexcept { return failures.empty() && figures.all_hold(); }
  std::string verdict() const { return !finding.empty() ? finding : passes() ? "pass" : "fail"; }
};

/// {"command", "verdict": "pass"|"fail" or the finding, "failures", "warnings" (only when there are any), "figures":
/// [{"name", "value", "unit"}], "claims" (only when there are any), "run": {...}}. A figure with a bound also has
/// "relation", "bound", "holds". A claim is {"id", "figure", "section", "sentence", "claim", "measured": {"name",
/// "value", "unit", "relation", "bound"}, "verdict", "reason"}. Values that are not finite are null.
std::string to_json(const Outcome& outcome);

/// Writes to_json() to `path`, as replace_file does; refuses what the disk does not take.
Result<Done> write_json(const std::string& path, const Outcome& outcome);

}  // namespace farrier::report
