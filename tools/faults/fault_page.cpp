#include "tools/faults/fault_page.hpp"

#include <algorithm>
#include <cmath>

#include "report/figures/text_format.hpp"

namespace farrier::faults {
namespace {

std::string milliseconds(double time_s) {
  return std::isfinite(time_s) ? report::short_number(time_s * 1e3) + " ms" : "never";
}

/// Returns the different values among the cells, in their order.
template <class Of>
std::string listed(const std::vector<Cell>& cells, Of&& of) {
  std::vector<std::string> names;
  std::string text;
  for (const Cell& cell : cells) {
    const std::string name = of(cell);
    if (std::ranges::find(names, name) == names.end()) {
      text += (names.empty() ? "" : ", ") + name;
      names.push_back(name);
    }
  }
  return text;
}

std::string text_of(const Check& check) {
  return check.what + " " + milliseconds(check.measured_s) + " of " + milliseconds(check.asked_s);
}

std::string checks_text(const std::vector<Check>& checks) {
  std::string text;
  for (const Check& check : checks) {
    text += (text.empty() ? "" : "<br>") + text_of(check) + (check.holds() ? "" : " **not held**");
  }
  return text;
}

}  // namespace

std::vector<Check> worst_checks(const std::vector<Cell>& cells, const std::string& row) {
  std::vector<Check> worst;
  for (const Cell& cell : cells) {
    for (const Check& check : cell.checks) {
      const auto known = std::ranges::find(worst, check.what, &Check::what);
      if (cell.row != row) {
        continue;
      }
      if (known == worst.end()) {
        worst.push_back(check);
      } else {
        known->measured_s = std::max(known->measured_s, check.measured_s);
      }
    }
  }
  return worst;
}

std::string why_not(const Cell& cell) {
  std::string text = cell.error;
  for (const Check& check : cell.checks) {
    text += check.holds() ? "" : (text.empty() ? "" : ", ") + text_of(check);
  }
  return text;
}

std::string faults_table_markdown() {
  std::string table = "| row | fault | answer of the processes | event |\n|---|---|---|---|\n";
  for (const Row& row : rows()) {
    table += "| `" + std::string(row.name) + "` | " + row.fault + " | " + row.does + " | " +
             (row.expected.event == nullptr ? "" : "`" + std::string(row.expected.event) + "`") + " |\n";
  }
  return table;
}

std::string fault_page_markdown(const std::vector<Cell>& cells, std::size_t planned, int slow) {
  const auto held = std::ranges::count_if(cells, &Cell::holds);
  int repeats = 0;
  for (const Cell& cell : cells) {
    repeats += cell.repeats;
  }
  std::string page =
      "# Faults\n\nWritten by `farrier faults --page`, which makes each fault of [faults.md](../faults.md) happen to a "
      "trot "
      "of real processes on the real-time\nclock" +
      (slow == 1 ? "" : ", in slow motion by " + std::to_string(slow)) +
      "; where a process starts, in slow motion by " + std::to_string(slow * kSlowerWhereProcessesStart) +
      ". Every row is made in stance and in swing, over each\nvendor, by each seed. Times are the longest of a row's "
      "cells, in control periods of `sim_bridge`, beside what is\nasked.\n\n" +
      std::to_string(held) + " of " + std::to_string(planned) + " cells held, " +
      std::to_string(planned - cells.size()) +
      " were not run. Vendors: " + listed(cells, [](const Cell& cell) { return cell.vendor; }) +
      ". Seeds: " + listed(cells, [](const Cell& cell) { return std::to_string(cell.seed); }) + ". " +
      std::to_string(repeats) +
      " runs in which the computer\nitself stood still and a check did not hold were made again. Others, which a fault "
      "does not hit, are not judged\nwhile the computer stands still for longer than a period, nor for " +
      std::to_string(kAfterPause) + " periods after.\n\n" + "| row | measured |\n|---|---|\n";
  for (const Row& row : rows()) {
    const auto worst = worst_checks(cells, row.name);
    if (!worst.empty()) {
      page += "| `" + std::string(row.name) + "` | " + checks_text(worst) + " |\n";
    }
  }
  std::string failures;
  for (const Cell& cell : cells) {
    if (!cell.holds()) {
      failures += "| `" + cell.row + "` | " + cell.phase + " | " + cell.vendor + " | " + std::to_string(cell.seed) +
                  " | " + why_not(cell) + " |\n";
    }
  }
  if (failures.empty()) {
    return page;
  }
  return page + "\n## Cells that did not hold\n\n| row | phase | vendor | seed | why |\n|---|---|---|---|---|\n" +
         failures;
}

}  // namespace farrier::faults
