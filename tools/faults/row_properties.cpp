// Properties that follow from the fields of a row.

#include <algorithm>
#include <csignal>

#include "tools/faults/fault_rows.hpp"

namespace farrier::faults {

bool leaves_trace(const Row& row) {
  return std::ranges::none_of(row.acts, [](const ProcessAct& act) {
    return act.signal == SIGKILL && std::string_view(act.member) == to_string(Program::kSimBridge);
  });
}

bool is_row_of(const Row& row, Where robot) {
  return row.where == Where::kEverywhere || row.where == robot ||
         (row.where == Where::kGround && robot == Where::kSupply);
}

bool walks_on(const Row& row) {
  return row.expected.reaction == signals::JointState::kTracking && !row.expected.may_stutter && leaves_trace(row);
}

bool starts_process(const Row& row) {
  return std::ranges::any_of(
      row.acts, [](const ProcessAct& act) { return act.signal == run::kStart || act.signal == run::kStartTwin; });
}

Row paced(Row row, int slow) {
  const bool sets = std::ranges::any_of(row.acts, [](const ProcessAct& act) { return run::sets_clock(act.signal); });
  row.lasts_s /= sets ? slow : 1;
  return row;
}

const Row* find_row(std::string_view name) {
  const auto found = std::ranges::find(rows(), name, [](const Row& row) { return std::string_view(row.name); });
  return found == rows().end() ? nullptr : &*found;
}

}  // namespace farrier::faults
