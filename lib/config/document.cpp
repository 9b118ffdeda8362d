#include "config/document.hpp"

#include <algorithm>
#include <exception>
#include <fstream>
#include <sstream>

#include <yaml-cpp/yaml.h>

namespace farrier::config {
namespace {

constexpr int kDeepest = 32;
constexpr int kMostNodes = 100000;
constexpr std::size_t kLargestFile = 4u << 20;

// Why a conversion stopped; thrown and caught in this file only, like the exceptions of yaml-cpp itself.
struct Refusal {
  int line;
  std::string message;
};

int line_of(const YAML::Node& node) { return node.Mark().line + 1; }

bool has_key(const Value& map, const std::string& key) {
  return std::any_of(map.entries.begin(), map.entries.end(),
                     [&](const Value::Entry& entry) { return entry.key == key; });
}

class Converter {
 public:
  Value convert(const YAML::Node& node, int depth) {
    if (depth > kDeepest) {
      throw Refusal{line_of(node), "is nested deeper than 32 levels; an alias may contain itself"};
    }
    if (++nodes_ > kMostNodes) {
      throw Refusal{line_of(node), "expands to more than 100000 values; aliases may multiply each other"};
    }
    Value value;
    value.line = line_of(node);
    switch (node.Type()) {
      case YAML::NodeType::Undefined:
      case YAML::NodeType::Null:
        break;
      case YAML::NodeType::Scalar:
        value.kind = Value::Kind::kScalar;
        value.scalar = node.Scalar();
        value.quoted = node.Tag() == "!";
        break;
      case YAML::NodeType::Sequence:
        value.kind = Value::Kind::kList;
        for (const YAML::Node& item : node) {
          value.items.push_back(convert(item, depth + 1));
        }
        break;
      case YAML::NodeType::Map:
        value.kind = Value::Kind::kMap;
        convert_map(node, depth, value);
        break;
    }
    return value;
  }

 private:
  void convert_map(const YAML::Node& node, int depth, Value& map) {
    std::vector<Value> merged;
    for (const auto& pair : node) {
      if (!pair.first.IsScalar()) {
        throw Refusal{line_of(pair.first), "has a key that is not plain text"};
      }
      Value value = convert(pair.second, depth + 1);
      if (pair.first.Scalar() == "<<") {
        merged.push_back(std::move(value));
      } else {
        map.entries.push_back({pair.first.Scalar(), line_of(pair.first), std::move(value)});
      }
    }
    for (const Value& source : merged) {
      merge(source, map);
    }
  }

  // YAML 1.1 merge key: what the map says itself wins, then the earlier source.
  void merge(const Value& source, Value& map) {
    if (source.kind == Value::Kind::kList) {
      for (const Value& item : source.items) {
        merge(item, map);
      }
      return;
    }
    if (source.kind != Value::Kind::kMap) {
      throw Refusal{source.line, "merges (<<) something that is not a map"};
    }
    for (const Value::Entry& entry : source.entries) {
      if (!has_key(map, entry.key)) {
        map.entries.push_back(entry);
      }
    }
  }

  int nodes_ = 0;
};

bool is_marker(const std::string& line, const char* marker) {
  constexpr std::size_t kLength = 3;
  return line.starts_with(marker) && (line.size() == kLength || line.find_first_of(" \t\r", kLength) == kLength);
}

/// Line with which another document begins after one with content (YAML 1.2, 9.1: --- begins one, ... ends one); 0 for
/// none.
int second_document(const std::string& text) {
  constexpr const char* kBlank = " \t\r";
  std::istringstream lines(text);
  std::string line;
  bool has_content = false;
  bool has_ended = false;
  for (int number = 1; std::getline(lines, line); ++number) {
    const bool begins = is_marker(line, "---");
    const auto first = line.find_first_not_of(kBlank, begins ? 3 : 0);
    const bool is_directive = line.starts_with('%') && !has_content;
    const bool says = first != std::string::npos && line[first] != '#' && !is_directive;
    if (is_marker(line, "...")) {
      has_ended = has_content;
    } else if ((begins && has_content) || (says && has_ended)) {
      return number;
    } else {
      has_content = has_content || says;
    }
  }
  return 0;
}

}  // namespace

Result<Value, Problem> parse_yaml(const std::string& text, const std::string& file) {
  if (text.size() > kLargestFile) {
    return Problem{file, 0, "", "is larger than 4 MB: this is not a configuration"};
  }
  try {
    // Not LoadAll: yaml-cpp 0.7 finds documents without end in some broken text.
    const YAML::Node document = YAML::Load(text);
    if (!document.IsDefined() || document.IsNull()) {
      return Problem{file, 0, "", "is empty"};
    }
    if (const int line = second_document(text); line > 0) {
      return Problem{file, line, "", "starts a second document: give one"};
    }
    return Converter().convert(document, 0);
  } catch (const Refusal& refusal) {
    return Problem{file, refusal.line, "", refusal.message};
  } catch (const YAML::Exception& error) {
    return Problem{file, error.mark.is_null() ? 0 : error.mark.line + 1, "", "is not valid YAML: " + error.msg};
  } catch (const std::exception& error) {
    return Problem{file, 0, "", std::string("is not valid YAML: ") + error.what()};
  }
}

Result<Value, Problem> parse_yaml_file(const std::string& path) {
  std::ifstream stream(path, std::ios::binary);
  std::ostringstream text;
  if (!stream || (stream.peek(), stream.bad()) || (!stream.eof() && !(text << stream.rdbuf()))) {
    return Problem{path, 0, "", "cannot be read: check the path and its permissions"};
  }
  return parse_yaml(text.str(), path);
}

bool override_scalar(Value& root, const std::string& where, const std::string& scalar) {
  Value* value = &root;
  std::istringstream keys(where);
  for (std::string key; std::getline(keys, key, '.');) {
    if (value->kind == Value::Kind::kNothing) {
      value->kind = Value::Kind::kMap;
    }
    if (value->kind != Value::Kind::kMap) {
      return false;
    }
    auto entry = std::find_if(value->entries.begin(), value->entries.end(),
                              [&](const Value::Entry& candidate) { return candidate.key == key; });
    if (entry == value->entries.end()) {
      entry = value->entries.insert(entry, Value::Entry{key, 0, Value{}});
    }
    entry->line = 0;
    value = &entry->value;
  }
  value->kind = Value::Kind::kScalar;
  value->scalar = scalar;
  value->line = 0;
  value->quoted = false;
  return true;
}

}  // namespace farrier::config
