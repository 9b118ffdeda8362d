#pragma once

#include <string>

#include "core/result.hpp"
#include "report/figures/outcome.hpp"

namespace farrier::report {

/// The verdict beside a title, in a colour of its own.
enum class Tone { kGood, kWarning, kBad };
struct Badge {
  std::string text;
  Tone tone;
};

/// Beginning of every report: head with style, title, verdict, and the reasons if it fails.
std::string page_head(const std::string& title, const Outcome& outcome);
/// The same with other words for the verdict.
std::string page_head(const std::string& title, const Outcome& outcome, const Badge& badge);

/// End of every report: figures, processes, run, configuration.
std::string page_foot(const Outcome& outcome);

/// Writes out_dir/index.html, as replace_file does, and returns its path; refuses what the disk does not take.
Result<std::string> write_page(const std::string& out_dir, const std::string& page);

}  // namespace farrier::report
