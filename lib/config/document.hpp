#pragma once

#include <string>
#include <vector>

#include "config/problem.hpp"
#include "core/result.hpp"

namespace farrier::config {

/// A node of a parsed file. Anchors are resolved, merge keys (`<<`) expanded; nothing is interpreted yet.
struct Value {
  enum class Kind { kNothing, kScalar, kList, kMap };
  struct Entry;

  Kind kind = Kind::kNothing;
  int line = 0;  ///< 1-based; 0 for a value that did not come from the file
  std::string scalar;
  bool quoted = false;  ///< a quoted scalar is text, whatever it looks like
  std::vector<Value> items;
  std::vector<Entry> entries;  ///< in the order of the file; may hold a key twice
};

struct Value::Entry {
  std::string key;
  int line = 0;
  Value value;
};

/// Parses exactly one YAML document. Refuses, with file and line, text that is not YAML, an empty text, more than one
/// document and keys that are not plain text. Also refuses nesting deeper than 32 and more than 100000 nodes (aliases
/// counted each time they are used). Does not throw.
Result<Value, Problem> parse_yaml(const std::string& text, const std::string& file);

/// Reads the file and parses it. Refuses one that cannot be read or is larger than 4 MB.
Result<Value, Problem> parse_yaml_file(const std::string& path);

/// Replaces or adds the scalar at the dotted path, creating maps on the way; its line becomes 0. Returns false when
/// the path leads through something that is not a map.
bool override_scalar(Value& root, const std::string& where, const std::string& scalar);

}  // namespace farrier::config
