#include "cli/base/renamed_options.hpp"

#include <algorithm>
#include <cstdio>
#include <iterator>

namespace farrier::cli {
namespace {

using Words = std::vector<std::string>;

/// An option of `trot` that is a verb of its own now.
struct Renamed {
  const char* option;
  const char* value;    ///< the value that makes it this one; empty: any or none
  bool keeps_value;     ///< the value is the new option's, too
  Words instead;        ///< in place of "trot" and the option
  Words ignored = {};   ///< options with a value that the old name took and did not use
};

const std::vector<Renamed>& renamed() {
  static const Words kProcesses{"--dds", "--nodes"};  // comparisons are made in process
  static const std::vector<Renamed> all{
      {"--vary", "", false, {"compare", "varied"}, kProcesses},
      {"--experiment", "switching", false, {"compare", "switching"}, kProcesses},
      {"--experiment", "update-logic", false, {"compare", "update-logic"}, kProcesses},
      {"--experiment", "controllers", false, {"compare", "controllers"}, kProcesses},
      {"--experiment", "fig7.8", false, {"reproduce", "7.8"}, {"--dds", "--nodes", "--robot", "--duration"}},
      {"--hide", "", true, {"trial", "--hide"}}};
  return all;
}

}  // namespace

Words with_new_names(Words arguments) {
  if (arguments.size() < 2 || arguments[1] != "trot") {
    return arguments;
  }
  for (const Renamed& one : renamed()) {
    const bool has_value = one.keeps_value || *one.value != '\0';
    const auto option = std::ranges::find(arguments, one.option);
    if (option == arguments.end() || (has_value && std::next(option) == arguments.end()) ||
        (*one.value != '\0' && *std::next(option) != one.value)) {
      continue;
    }
    std::string text = "farrier";
    for (const std::string& word : one.instead) {
      text += " " + word;
    }
    std::fprintf(stderr, "farrier trot %s%s%s: this is now '%s'; the old name will go with the next release\n",
                 one.option, *one.value != '\0' ? " " : "", one.value, text.c_str());
    Words now{arguments[0]};
    now.insert(now.end(), one.instead.begin(), one.instead.end());
    if (one.keeps_value) {
      now.push_back(*std::next(option));
    }
    now.insert(now.end(), arguments.begin() + 2, option);
    now.insert(now.end(), option + (has_value ? 2 : 1), arguments.end());
    for (const std::string& ignored : one.ignored) {
      if (const auto place = std::ranges::find(now, ignored); place != now.end() && std::next(place) != now.end()) {
        now.erase(place, place + 2);
      }
    }
    return now;
  }
  return arguments;
}

}  // namespace farrier::cli
