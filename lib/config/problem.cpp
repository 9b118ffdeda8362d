#include "config/problem.hpp"

#include <algorithm>

#include "config/visitor.hpp"

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

Problem Place::problem(const std::string& key, std::string message) const {
  const auto found = lines.find(key);
  const std::string separator = where.empty() || key.empty() ? "" : ".";
  return {file, found == lines.end() ? line : found->second, where + separator + key, std::move(message)};
}

}  // namespace farrier::config
