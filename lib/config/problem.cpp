#include "config/problem.hpp"

#include <algorithm>

namespace farrier::config {

std::string to_string(const Problem& problem) {
  std::string text = problem.file;
  if (problem.line > 0) {
    text += ":" + std::to_string(problem.line);
  }
  text += ": ";
  if (!problem.where.empty()) {
    text += problem.where + ": ";
  }
  return text + problem.message;
}

std::string to_string(const Problems& problems) {
  std::string text;
  for (const Problem& problem : problems) {
    text += to_string(problem) + "\n";
  }
  return text;
}

void sort_by_line(Problems& problems) {
  std::stable_sort(problems.begin(), problems.end(),
                   [](const Problem& a, const Problem& b) { return a.line < b.line; });
}

}  // namespace farrier::config
