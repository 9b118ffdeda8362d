#include "cli/manual/completion.hpp"

#include "core/text.hpp"

namespace farrier::cli {
namespace {

/// Text between brackets or colons of a specification.
std::string inside(const std::string& text) {
  std::string escaped;
  for (const char c : text) {
    escaped += (c == '[' || c == ']' || c == ':' || c == '\\' ? "\\" : "") + std::string(1, c);
  }
  return escaped;
}

/// ":what:how it is completed", nothing for an option that takes no value.
std::string zsh_action(const OptionText& option) {
  if (!option.takes_value) {
    return "";
  }
  const std::string name = inside(option.at_its_place ? option.names.front() : option.value);
  const std::string colon = option.value_may_be_left_out || !(option.required || !option.at_its_place) ? "::" : ":";
  std::string action = " ";
  if (!option.choices.empty()) {
    action = option.separator == ',' ? "_values -s , value " + join(option.choices, " ")
                                     : "(" + join(option.choices, " ") + ")";
  } else if (option.path != PathKind::kNone) {
    action = option.path == PathKind::kFolder ? "_files -/" : "_files";
  }
  return colon + name + ":" + action;
}

std::string specifications(const CommandText& command, const std::string& indent) {
  std::string text;
  int place = 0;
  for (const OptionText& option : command.options) {
    if (option.at_its_place) {
      ++place;
      text += " \\\n" + indent +
              quoted((option.takes_several ? "*" : std::to_string(place)) + zsh_action(option));
      continue;
    }
    for (const std::string& name : option.names) {
      const std::string alternatives = option.names.size() > 1 ? "(" + join(option.names, " ") + ")" : "";
      text += " \\\n" + indent + quoted(alternatives + name + "[" + inside(option.meaning) + "]" + zsh_action(option));
    }
  }
  return text;
}

}  // namespace

std::string zsh_completion(const CommandText& farrier, const std::vector<CommandText>& commands) {
  std::string text =
      "#compdef farrier\n# zsh completion of farrier, written by 'farrier completion zsh'.\n\n_farrier() {\n"
      "    local curcontext=\"$curcontext\" state\n    local -a line commands\n    typeset -A opt_args\n"
      "    _arguments -C" +
      specifications(farrier, "        ") +
      " \\\n        '1:command:->command' \\\n        '*::argument:->argument' && return\n    case $state in\n"
      "        command)\n            commands=(";
  for (const CommandText& command : commands) {
    text += "\n                " + quoted(command.name + ":" + inside(command.sentence));
  }
  text += ")\n            _describe command commands\n            ;;\n        argument)\n            case $words[1] in\n";
  for (const CommandText& command : commands) {
    text += "                " + command.name + ")\n                    _arguments" +
            specifications(command, "                        ") + "\n                    ;;\n";
  }
  return text +
         "            esac\n            ;;\n    esac\n}\n\n# Read from fpath it is the function; sourced, it must be made "
         "known.\nif [[ $funcstack[1] == _farrier ]]; then\n    _farrier \"$@\"\nelse\n    compdef _farrier farrier\nfi\n";
}

}  // namespace farrier::cli
