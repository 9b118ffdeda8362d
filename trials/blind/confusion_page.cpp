#include <algorithm>
#include <map>

#include "core/number_as.hpp"
#include "core/text.hpp"
#include "trials/blind/score.hpp"

namespace farrier::blind {
namespace {

std::string hidden_name(const Outcome& outcome) {
  std::string name;
  for (const truth::Hidden& hidden : outcome.plan.plan.hidden) {
    name += (name.empty() ? "" : " + ") + hidden.name;
  }
  return name.empty() ? "none" : name;
}

std::string answer_name(const Outcome& outcome) {
  if (outcome.verdict == diagnosis::Verdict::kUnknown) {
    return "unknown";
  }
  std::string name;
  for (const Named& named : outcome.named) {
    name += (name.empty() ? "" : " + ") + named.name;
  }
  return name.empty() ? to_string(outcome.verdict) : name;
}

const char* name_of(truth::Excitation excitation) {
  switch (excitation) {
    case truth::Excitation::kMultisine:
      return "multisine";
    case truth::Excitation::kRandomSteps:
      return "random steps";
    case truth::Excitation::kForceTracking:
      return "force tracking";
  }
  return "";
}

}  // namespace

std::string confusion_page(const std::vector<Outcome>& outcomes) {
  std::string page =
      "# What the diagnosis says of what\n\n"
      "Written by `farrier diagnose --benchmark --confusion FILE`. Each row is what a truth generator that shares no\n"
      "code with the diagnosis hid in recordings of 8 s; the answers are what `diagnose` made of them, and how "
      "often.\n\n"
      "| hidden | trials | answers |\n|---|---|---|\n";
  std::map<std::string, std::map<std::string, int>> table;
  std::vector<std::string> order;
  for (const Outcome& outcome : outcomes) {
    const std::string hidden = outcome.plan.kind == Kind::kSet ? "(set) " + hidden_name(outcome) : hidden_name(outcome);
    if (!table.contains(hidden)) {
      order.push_back(hidden);
    }
    ++table[hidden][answer_name(outcome)];
  }
  std::ranges::sort(order);  // trials run in a mixed order
  for (const std::string& hidden : order) {
    std::vector<std::pair<int, std::string>> answers;
    int trials = 0;
    for (const auto& [answer, count] : table[hidden]) {
      answers.emplace_back(-count, answer);
      trials += count;
    }
    std::ranges::sort(answers);
    page += "| " + hidden + " | " + std::to_string(trials) + " | ";
    for (std::size_t i = 0; i < answers.size(); ++i) {
      page += (i == 0 ? "" : ", ") + answers[i].second + " " + std::to_string(-answers[i].first);
    }
    page += " |\n";
  }
  page +=
      "\n## Effects of the library\n\n"
      "Of the trials in which the effect changes the held-out error by more than 10 %: named (first, or in a pair\n"
      "that the recording does not tell apart), first and alone, and of those the parameter within 15 % of its\n"
      "distance from neutral. Control: force tracking error of a controller for the nominal joint over that of one\n"
      "which knows what was named, where it can use it, on the joint with what is hidden; median, trials.\n\n"
      "| effect | counted | named | first alone | parameter | error before / after | control |\n"
      "|---|---|---|---|---|---|---|\n";
  for (const auto& [name, s] : score_by_effect(outcomes)) {
    page += "| " + name + " | " + std::to_string(s.counted) + " | " + number_as("%.0f %%", 100 * s.named) + " | " +
            number_as("%.0f %%", 100 * s.first_alone) + " | " + number_as("%.0f %%", 100 * s.within_tolerance) + " | " +
            number_as("%.1f", s.median_gain) + " | " +
            (s.controlled > 0 ? number_as("%.2f", s.control_gain) + ", " + std::to_string(s.controlled) : "") + " |\n";
  }
  page +=
      "\n## Trials that went wrong\n\n| hidden | size | excitation | seed | change of the error | cannot be separated "
      "| answer |\n"
      "|---|---|---|---|---|---|---|\n";
  for (const Outcome& o : outcomes) {
    const bool good = o.plan.kind == Kind::kNone      ? o.verdict == diagnosis::Verdict::kNone
                      : o.plan.kind == Kind::kOutside ? o.verdict == diagnosis::Verdict::kUnknown ||
                                                            o.verdict == diagnosis::Verdict::kCannotSeparate
                      : o.plan.kind == Kind::kSet ? all_named(o)
                                                  : first_alone(o) && o.parameter_error <= kParameterTolerance;
    if (!good) {
      page += "| " + hidden_name(o) + " | " +
              (o.plan.plan.hidden.empty() ? "" : std::to_string(o.plan.plan.hidden.front().magnitude)) + " | " +
              name_of(o.plan.plan.excitation) + " | " + std::to_string(o.plan.plan.seed) + " | " +
              number_as("%.0f %%", 100 * o.detectable) + " | " + join(o.inseparable, ", ") + " | " +
              (o.refused.empty() ? answer_name(o) : o.refused) + " |\n";
    }
  }
  return page;
}

}  // namespace farrier::blind
