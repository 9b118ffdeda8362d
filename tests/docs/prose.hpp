#pragma once

// Finds English in comments and test names that a reader has to read twice. The rules stand in docs/style.md.

#include <string>
#include <vector>

#include "tests/architecture/source_tree.hpp"

namespace farrier::docs {

struct Finding {
  int line;          ///< from 1 on
  std::string rule;  ///< "begins with 'What'"
  std::string text;  ///< the sentence or the test's name
};

/// The words and phrases that docs/style.md bans, in lower case.
std::vector<std::string> banned_words();

/// The findings in the comments of a C++ source and in the names of its tests, in order of line. A finding is a sentence
/// that begins with "What", "Whether", "Who", "Of" or "How" and is no question, a sentence of more than 35 words, or a
/// banned word.
std::vector<Finding> prose_findings(const architecture::Source& source, const std::vector<std::string>& banned);

}  // namespace farrier::docs
