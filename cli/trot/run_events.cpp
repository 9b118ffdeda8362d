#include "cli/trot/run_events.hpp"

#include <algorithm>

#include "core/replace_file.hpp"
#include "report/trot/adaptation.hpp"

namespace farrier::cli {

void write_events(const std::string& path, const robot::Robot& robot, const RunOutcome& run,
                  std::span<const report::DecisionInfo> decisions) {
  std::vector<std::pair<Tick, std::string>> lines;
  for (const signals::SystemEvent& event : run.events) {
    std::string line = signals::to_string(event.severity);
    line += ' ' + (event.participant < run.members.size() ? run.members[event.participant].name : "?");
    if (event.joint < robot.joints.size()) {
      line += ' ' + robot.joints[event.joint].name;
    }
    lines.emplace_back(event.tick, line + ": " + std::string(signals::text_of(event.text)));
  }
  for (const report::DecisionInfo& decision : decisions) {
    lines.emplace_back(decision.decision.tick, "gains " + report::decision_text(decision));
  }
  std::ranges::stable_sort(lines, {}, &std::pair<Tick, std::string>::first);
  std::string text;
  for (const auto& [tick, line] : lines) {
    text += "tick " + std::to_string(tick) + ' ' + line + '\n';
  }
  for (const std::string& warning : run.warnings) {
    text += "warning: " + warning + '\n';
  }
  static_cast<void>(replace_file(path, text));  // a run does not fail for it
}

}  // namespace farrier::cli
