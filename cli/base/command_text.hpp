#pragma once

// Text of a command line, read from the app that parses it: help, man pages, completions and docs/cli.md are written
// from this and cannot say anything else.

#include <CLI/CLI.hpp>
#include <string>
#include <vector>

namespace farrier::cli {

enum class PathKind { kNone, kFile, kFolder };

/// One option, or one word at its place.
struct OptionText {
  std::vector<std::string> names;    ///< "-h", "--help"; the name alone for a positional argument
  bool at_its_place = false;
  bool required = false;
  bool takes_value = false;
  bool value_may_be_left_out = false;
  bool takes_several = false;
  char separator = '\0';             ///< between several in one word; 0: none
  std::string value;                 ///< "<file>", "cyclone|fast"; empty where there is no value
  std::vector<std::string> choices;  ///< all there are; empty where anything may stand
  PathKind path = PathKind::kNone;
  std::string range;                 ///< "0 to 232"; empty without
  std::string meaning;               ///< with range and choices if `value` does not name them
  std::string unless_told;           ///< empty where nothing stands in for it
};

struct CommandText {
  std::string name;      ///< "trot"; empty for farrier itself
  std::string sentence;  ///< without a full stop
  std::vector<OptionText> options;

  std::string full_name() const { return name.empty() ? "farrier" : "farrier " + name; }
};

CommandText command_text(const CLI::App& app);

/// Returns the texts of all commands of `farrier`, in order.
std::vector<CommandText> command_texts(const CLI::App& farrier);

/// "[--dds cyclone|fast]", "<file>".
std::string usage_of(const OptionText& option);

/// Returns the heading of an option: "-h,--help", "--dds cyclone|fast", "from <file|folder>".
std::string heading_of(const OptionText& option);

}  // namespace farrier::cli
