#pragma once

#include <functional>
#include <string>
#include <vector>

#include "config/document.hpp"
#include "config/visitor.hpp"
#include "core/result.hpp"

namespace farrier::config {

/// A parameter set from outside the file (command line), by its dotted path: {"gait.frequency_Hz", "2"}.
struct Setting {
  std::string where;
  std::string value;
};

/// Reads `declare_all` from the document. Every mistake of the file is a Problem: unknown, missing and repeated keys,
/// wrong types, values out of range or not finite, unknown choices, failed checks.
Problems read_document(const Value& root, const std::string& file, const std::function<void(Visitor&)>& declare_all);

/// Loads a struct that has a `declare`, settings applied on top; refuses with all mistakes in the order of the file.
template <class T>
Result<T, Problems> read_text(const std::string& text, const std::string& file,
                              const std::vector<Setting>& settings = {});
template <class T>
Result<T, Problems> read_file(const std::string& path, const std::vector<Setting>& settings = {});

/// Applies settings to a parsed file, or says which cannot be.
Problems apply(const std::vector<Setting>& settings, const std::string& file, Value& root);

namespace detail {

template <class T>
Result<T, Problems> read(Result<Value, Problem> parsed, const std::string& file, const std::vector<Setting>& settings) {
  if (!parsed) {
    return Problems{parsed.error()};
  }
  Problems problems = apply(settings, file, parsed.value());
  T value{};
  const Problems found = read_document(parsed.value(), file, [&value](Visitor& v) { declare(v, value); });
  problems.insert(problems.end(), found.begin(), found.end());
  if (!problems.empty()) {
    sort_by_line(problems);
    return problems;
  }
  return value;
}

}  // namespace detail

template <class T>
Result<T, Problems> read_text(const std::string& text, const std::string& file, const std::vector<Setting>& settings) {
  return detail::read<T>(parse_yaml(text, file), file, settings);
}

template <class T>
Result<T, Problems> read_file(const std::string& path, const std::vector<Setting>& settings) {
  return detail::read<T>(parse_yaml_file(path), path, settings);
}

}  // namespace farrier::config
