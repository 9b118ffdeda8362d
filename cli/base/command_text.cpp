#include "cli/base/command_text.hpp"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <sstream>

#include "core/pattern.hpp"
#include "core/text.hpp"

namespace farrier::cli {
namespace {

/// More choices than these are told behind the meaning, not in the usage.
constexpr std::size_t kMostInUsage = 5;

std::vector<std::string> split(const std::string& text, char separator) {
  std::vector<std::string> parts;
  std::istringstream stream(text);
  for (std::string part; std::getline(stream, part, separator);) {
    parts.push_back(part);
  }
  return parts;
}

PathKind path_kind(const std::string& value) {
  const bool file = value.find("file") != std::string::npos;
  const bool folder = value.find("dir") != std::string::npos || value.find("folder") != std::string::npos;
  return file ? PathKind::kFile : folder ? PathKind::kFolder : PathKind::kNone;
}

/// CLI11 says "<type>:<check>:<check>", where a check is "{a,b}", "INT in [0 - 232]" or a word.
void read_type(const std::string& type, OptionText& option) {
  // Groups: 2 the choices, 3 and 4 the range.
  static const Pattern check(R"(^:(\{([^}]*)\}|[A-Z]+ in \[([^ ]+) - ([^]]+)\]|[A-Z]+))");
  const std::size_t named_end = type.rfind('>');  // a name may have a colon: "<address:port>"
  const std::size_t colon = type.find(':', named_end == std::string::npos ? 0 : named_end);
  option.value = type.substr(0, colon);
  for (std::size_t at = colon; at != std::string::npos; at = type.find(':', at + 1)) {
    const auto found = check.find(type.substr(at));
    if (found && !(*found)[2].empty()) {
      option.choices = split((*found)[2], ',');
    } else if (found && !(*found)[3].empty()) {
      option.range = (*found)[3] + " to " + (*found)[4];
    }
  }
  const bool named = option.value.find('<') != std::string::npos;
  if (option.choices.empty() && !named && option.value.find('|') != std::string::npos) {
    option.choices = split(option.value, '|');
  } else if (!option.choices.empty() && !named && option.choices.size() <= kMostInUsage) {
    option.value = join(option.choices, "|");
  }
  option.path = path_kind(option.value);
}

OptionText option_text(const CLI::Option& option) {
  OptionText text;
  text.at_its_place = option.get_positional();
  text.takes_value = option.get_items_expected_max() > 0;
  if (text.at_its_place) {
    text.names = {option.get_name(true)};
  } else {
    for (const std::string& name : option.get_snames()) {
      text.names.push_back("-" + name);
    }
    for (const std::string& name : option.get_lnames()) {
      text.names.push_back("--" + name);
    }
  }
  text.required = option.get_required();
  text.value_may_be_left_out = text.takes_value && option.get_items_expected_min() == 0;
  text.takes_several = option.get_items_expected_max() > 1;
  text.separator = option.get_delimiter();
  if (text.takes_value) {
    read_type(option.get_type_name(), text);
  }
  text.meaning = option.get_description();
  const std::string all = join(text.choices, "|");
  if (!text.choices.empty() && text.value != all) {
    const std::string list = join(text.choices, ", ");
    if (text.meaning.find(list) == std::string::npos) {
      text.meaning += "; of " + list;
    }
  }
  if (!text.range.empty()) {
    text.meaning += ", " + text.range;
  }
  text.unless_told = option.get_default_str();
  return text;
}

}  // namespace

CommandText command_text(const CLI::App& app) {
  CommandText text{app.get_parent() == nullptr ? "" : app.get_name(), app.get_description(), {}};
  for (const CLI::Option* option : app.get_options()) {
    text.options.push_back(option_text(*option));
  }
  std::ranges::stable_partition(text.options, &OptionText::at_its_place);
  return text;
}

std::vector<CommandText> command_texts(const CLI::App& farrier) {
  std::vector<CommandText> texts;
  for (const CLI::App* command : farrier.get_subcommands({})) {
    texts.push_back(command_text(*command));
  }
  return texts;
}

std::string usage_of(const OptionText& option) {
  const std::string text =
      option.at_its_place ? option.value : option.names.back() + (option.value.empty() ? "" : " " + option.value);
  return option.required ? text : "[" + text + "]";
}

std::string heading_of(const OptionText& option) {
  if (option.at_its_place) {
    const std::string& name = option.names.front();
    return option.value.find("<" + name + ">") == 0 ? option.value : name + " " + option.value;
  }
  return join(option.names, ",") + (option.value.empty() ? "" : " " + option.value);
}

}  // namespace farrier::cli
