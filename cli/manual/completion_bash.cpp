#include "cli/manual/completion.hpp"

#include "core/text.hpp"

namespace farrier::cli {
namespace {

/// Returns the kind of an option's value in the words of _farrier_offer.
std::string kind_of(const OptionText& option) {
  if (!option.choices.empty()) {
    return (option.separator == ',' ? "list " : "words ") + join(option.choices, " ");
  }
  switch (option.path) {
    case PathKind::kFile: return "file";
    case PathKind::kFolder: return "folder";
    case PathKind::kNone: break;
  }
  return "any";
}

std::string line(const std::string& pattern, const std::string& kind) {
  return "        " + pattern + ") kind=" + quoted(kind) + " ;;\n";
}

constexpr const char* kBody = R"bash(
# Puts into COMPREPLY what may stand for $1 where _farrier_option or _farrier_place has put its kind into $kind.
_farrier_offer() {
    local word=$1 before=
    case $kind in
        file) mapfile -t COMPREPLY < <(compgen -f -- "$word"); compopt -o filenames 2>/dev/null || : ;;
        folder) mapfile -t COMPREPLY < <(compgen -d -- "$word"); compopt -o filenames 2>/dev/null || : ;;
        words\ *) mapfile -t COMPREPLY < <(compgen -W "${kind#words }" -- "$word") ;;
        list\ *)
            before=${word%"${word##*,}"}
            mapfile -t COMPREPLY < <(compgen -P "$before" -W "${kind#list }" -- "${word##*,}")
            ;;
    esac
}

_farrier() {
    local word=${COMP_WORDS[COMP_CWORD]} last=$((COMP_CWORD - 1)) command=${COMP_WORDS[1]} kind= place=0 i
    COMPREPLY=()
    if ((COMP_CWORD == 1)); then
        kind="words $_farrier_commands"
        _farrier_offer "$word"
        return 0
    fi
    # "--dds=fast" comes as three words.
    if [[ $word == = ]]; then
        word=
    elif [[ ${COMP_WORDS[last]} == = ]]; then
        last=$((last - 1))
    fi
    if _farrier_option "$command" "${COMP_WORDS[last]}"; then
        _farrier_offer "$word"
        return 0
    fi
    if [[ $word == -* ]]; then
        kind="words $(_farrier_options "$command")"
        _farrier_offer "$word"
        return 0
    fi
    for ((i = 2; i <= COMP_CWORD; i++)); do
        if _farrier_option "$command" "${COMP_WORDS[i]}"; then
            [[ ${COMP_WORDS[i + 1]-} == = ]] && i=$((i + 1))
            i=$((i + 1))
        elif [[ ${COMP_WORDS[i]} != -* ]]; then
            place=$((place + 1))
        fi
    done
    _farrier_place "$command" "$place" && _farrier_offer "$word"
    return 0
}

complete -F _farrier farrier
)bash";

}  // namespace

std::string bash_completion(const CommandText& farrier, const std::vector<CommandText>& commands) {
  std::vector<std::string> first;
  std::string options;  // of each command
  std::string values;   // what stands behind an option
  std::string places;   // what stands where no option does
  for (const CommandText& command : commands) {
    first.push_back(command.name);
    std::vector<std::string> names;
    int place = 0;
    for (const OptionText& option : command.options) {
      if (option.at_its_place) {
        ++place;
        places += line(option.takes_several ? "\"" + command.name + " \"*"
                                            : "\"" + command.name + " " + std::to_string(place) + "\"",
                       kind_of(option));
        continue;
      }
      for (const std::string& name : option.names) {
        names.push_back(name);
        if (option.takes_value) {
          values += line("\"" + command.name + " " + name + "\"", kind_of(option));
        }
      }
    }
    options += "        " + command.name + ") echo " + quoted(join(names, " ")) + " ;;\n";
  }
  for (const OptionText& option : farrier.options) {
    first.insert(first.end(), option.names.begin(), option.names.end());
  }
  return "# bash completion of farrier, written by 'farrier completion bash'.\n_farrier_commands=" +
         quoted(join(first, " ")) +
         "\n\n# What stands behind option $2 of command $1; fails where nothing does.\n_farrier_option() {\n    case \"$1 "
         "$2\" in\n" +
         values +
         "        *) return 1 ;;\n    esac\n}\n\n# What stands at the $2nd place of command $1 that is no "
         "option's.\n_farrier_place() {\n    case \"$1 $2\" in\n" +
         places + "        *) return 1 ;;\n    esac\n}\n\n_farrier_options() {\n    case $1 in\n" + options +
         "    esac\n}\n" + kBody;
}

}  // namespace farrier::cli
