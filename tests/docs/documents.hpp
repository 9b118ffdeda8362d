#pragma once

// The repository's documents, as the tests of tests/docs read them.

#include <filesystem>
#include <set>
#include <string>
#include <vector>

namespace farrier::docs {

struct Line {
  int number;  ///< from 1 on
  std::string text;
};

/// A fenced block of code.
struct Block {
  std::string language;  ///< "" where none is given
  std::vector<Line> lines;
};

struct Document {
  std::string path;         ///< from the repository's root, "docs/tour.md"
  std::vector<Line> prose;  ///< without fenced blocks
  std::vector<Block> blocks;
};

/// Every Markdown file of the repository, in order of path.
const std::vector<Document>& documents();

/// "path:line".
std::string at(const Document& document, const Line& line);

/// Contents of the spans in back-quotes of a line.
std::vector<std::string> code_spans(const std::string& text);

/// Where the links of a line lead, as written.
std::vector<std::string> links(const std::string& text);

/// Names of a document's headings, as code forges and the site make them. Headings with letters beyond ASCII, of which
/// those would make different names, have none.
std::set<std::string> anchors(const Document& document);

/// The content of a file. Empty where it cannot be read.
std::string content_of(const std::filesystem::path& path);

/// Output and status of a command line for sh.
struct Ran {
  int status;
  std::string output;  ///< and what it says on standard error
};
Ran run(const std::string& command_line);

/// Output of git in the repository; empty where git fails.
std::string git(const std::string& arguments);

/// The commit that a change is compared with: the one where it left the main branch, on that branch the last commit's
/// parent. Empty without a history.
std::string base_of_the_change();

/// Paths of the files that the change adds or modifies, from the repository's root.
std::vector<std::string> changed_files();

}  // namespace farrier::docs
