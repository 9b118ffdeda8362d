#include "cli/manual/completion.hpp"

#include "core/text.hpp"

namespace farrier::cli {
namespace {

std::string action_of(const OptionText& option) {
  if (!option.takes_value) {
    return "";
  }
  const std::string flag = option.at_its_place ? "" : " -x";
  if (!option.choices.empty()) {
    const std::string words = join(option.choices, " ");
    return flag + " -a " +
           quoted(option.separator == ',' ? "(__fish_append , " + words + ")" : words);
  }
  switch (option.path) {
    case PathKind::kFile: return option.at_its_place ? " -F" : " -r -F";
    case PathKind::kFolder: return flag + " -a '(__fish_complete_directories (commandline -ct))'";
    case PathKind::kNone: break;
  }
  return flag;
}

std::string lines_of(const CommandText& command, const std::string& condition) {
  std::string text;
  for (const OptionText& option : command.options) {
    std::string names;
    for (const std::string& name : option.names) {
      names += option.at_its_place ? "" : name.starts_with("--") ? " -l " + name.substr(2) : " -s " + name.substr(1);
    }
    const std::string action = action_of(option);
    if (!names.empty() || !action.empty()) {
      text += "complete -c farrier -n " + quoted(condition) + names + action + " -d " + quoted(option.meaning) + "\n";
    }
  }
  return text;
}

}  // namespace

std::string fish_completion(const CommandText& farrier, const std::vector<CommandText>& commands) {
  std::string text =
      "# fish completion of farrier, written by 'farrier completion fish'.\n\n"
      "function __farrier_is --description 'the command so far is this one; none without an argument'\n"
      "    set -l words (commandline -opc)\n    test \"$words[2]\" = \"$argv[1]\"\nend\n\n"
      "complete -c farrier -f\n" +
      lines_of(farrier, "__farrier_is");
  for (const CommandText& command : commands) {
    text += "complete -c farrier -n '__farrier_is' -a " + command.name + " -d " + quoted(command.sentence) + "\n";
  }
  for (const CommandText& command : commands) {
    text += "\n" + lines_of(command, "__farrier_is " + command.name);
  }
  return text;
}

}  // namespace farrier::cli
