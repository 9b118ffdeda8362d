#include "cli/manual/command_table.hpp"

#include <algorithm>

#include "cli/base/command_text.hpp"

namespace farrier::cli {
namespace {

/// A bar would end a cell, a bracket outside code would begin a tag.
std::string cell(const std::string& text) {
  std::string escaped;
  for (const char c : text) {
    escaped += c == '|' ? "\\|" : c == '<' ? "&lt;" : std::string(1, c);
  }
  return escaped;
}

std::string code_cell(const std::string& text) {
  std::string escaped;
  for (const char c : text) {
    escaped += c == '|' ? "\\|" : std::string(1, c);
  }
  return "`" + escaped + "`";
}

std::string section(const CommandText& command) {
  std::string text = "## " + command.full_name() + "\n\n" + command.sentence + ".\n\n";
  std::string words;
  std::string rows;
  for (const OptionText& option : command.options) {
    if (option.at_its_place) {
      words += " " + usage_of(option);
    } else if (option.names.back() == "--help") {
      continue;
    }
    rows += "| " + code_cell(heading_of(option)) + " | " + (option.required ? "required" : cell(option.unless_told)) +
            " | " + cell(option.meaning) + " |\n";
  }
  const bool options = std::ranges::any_of(
      command.options, [](const OptionText& o) { return !o.at_its_place && o.names.back() != "--help"; });
  text += "```\n" + command.full_name() + words + (options ? " [<option>...]" : "") + "\n```\n\n";
  return rows.empty() ? text : text + "| option | unless told | meaning |\n|---|---|---|\n" + rows + "\n";
}

}  // namespace

std::string command_table(const CLI::App& farrier) {
  std::string text;
  for (const CommandText& command : command_texts(farrier)) {
    text += section(command);
  }
  text.pop_back();
  return text;
}

}  // namespace farrier::cli
