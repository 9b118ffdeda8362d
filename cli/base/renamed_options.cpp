#include "cli/base/renamed_options.hpp"

#include <algorithm>
#include <cstdio>
#include <iterator>

namespace farrier::cli {
namespace {

/// An option of `trot` that is a verb of its own now.
struct Renamed {
  const char* option;
  const char* value;                  ///< the value it must have; empty: any or none
  std::vector<std::string> instead;   ///< in place of "trot", the option and its value
  bool keeps_value = false;           ///< the value goes behind `instead`
};

const std::vector<Renamed>& renamed() {
  static const std::vector<Renamed> all{{"--vary", "", {"compare", "varied"}},
                                        {"--experiment", "switching", {"compare", "switching"}},
                                        {"--experiment", "update-logic", {"compare", "update-logic"}},
                                        {"--experiment", "controllers", {"compare", "controllers"}},
                                        {"--experiment", "fig7.8", {"reproduce", "7.8"}},
                                        {"--hide", "", {"trial", "--hide"}, true}};
  return all;
}

}  // namespace

std::vector<std::string> with_new_names(std::vector<std::string> arguments) {
  if (arguments.size() < 2 || arguments[1] != "trot") {
    return arguments;
  }
  for (const Renamed& one : renamed()) {
    const auto option = std::ranges::find(arguments, one.option);
    const bool has_value = one.keeps_value || one.value[0] != '\0';
    if (option == arguments.end() || (has_value && std::next(option) == arguments.end()) ||
        (one.value[0] != '\0' && *std::next(option) != one.value)) {
      continue;
    }
    std::vector<std::string> instead{arguments[0]};
    instead.insert(instead.end(), one.instead.begin(), one.instead.end());
    if (one.keeps_value) {
      instead.push_back(*std::next(option));
    }
    instead.insert(instead.end(), arguments.begin() + 2, option);
    instead.insert(instead.end(), option + (has_value ? 2 : 1), arguments.end());
    std::string text;
    for (const std::string& word : one.instead) {
      text += " " + word;
    }
    std::fprintf(stderr, "farrier trot %s%s%s: this is now 'farrier%s'; the old name will go with the next release\n",
                 one.option, one.value[0] != '\0' ? " " : "", one.value, text.c_str());
    return instead;
  }
  return arguments;
}

}  // namespace farrier::cli
