#include "tools/faults/fault_page.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>

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

/// A row's demand on a robot that walks on a ground.
std::string on_ground_text(const Row& row) {
  if (row.where == Where::kBench) {
    return "not run";
  }
  return std::string(walks_on(row) ? "walks on" : "may fall") +
         (row.where == Where::kEverywhere ? "" : ", on a ground only");
}

constexpr const char* kTimesText =
    "Times are the longest of a row's cells, in control periods of `sim_bridge`, beside what is\nasked.";

std::string counts_text(const std::vector<Cell>& cells, const PageFacts& facts) {
  int repeats = 0;
  for (const Cell& cell : cells) {
    repeats += cell.repeats;
  }
  const std::string drawn = facts.draw_seed
                                ? "Cells are drawn, each row once before a row comes twice, with the seed " +
                                      std::to_string(*facts.draw_seed) + ". "
                                : "";
  return drawn + std::to_string(std::ranges::count_if(cells, &Cell::holds)) + " of " + std::to_string(facts.planned) +
         " cells held, " + std::to_string(facts.planned - cells.size()) +
         " were not run. Vendors: " + listed(cells, [](const Cell& cell) { return cell.vendor; }) +
         ". Seeds: " + listed(cells, [](const Cell& cell) { return std::to_string(cell.seed); }) + ". " +
         std::to_string(repeats) +
         " runs in which the computer\nitself was paused and a check did not hold were made again. Others, which a "
         "fault "
         "does not hit, are not judged\nwhile the computer is paused for longer than a period, nor for " +
         std::to_string(kAfterPause) + " periods after.\n\n";
}

/// The cells that did not hold, under a heading of that depth; empty if all held.
std::string failures_text(const std::vector<Cell>& cells, const std::string& depth) {
  std::string failures;
  for (const Cell& cell : cells) {
    if (!cell.holds()) {
      failures += "| `" + cell.row + "` | " + cell.phase + " | " + cell.vendor + " | " + std::to_string(cell.seed) +
                  " | " + why_not(cell) + " |\n";
    }
  }
  return failures.empty()
             ? ""
             : "\n" + depth +
                   " Cells that did not hold\n\n| row | phase | vendor | seed | why |\n|---|---|---|---|---|\n" +
                   failures;
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

std::optional<BodyAfterFault> worst_body(const std::vector<Cell>& cells, const std::string& row) {
  std::optional<BodyAfterFault> worst;
  for (const Cell& cell : cells) {
    if (cell.row != row || !cell.body) {
      continue;
    }
    worst = worst.value_or(*cell.body);
    worst->fell = worst->fell || cell.body->fell;
    worst->not_walking_s = std::max(worst->not_walking_s, cell.body->not_walking_s);
    worst->trunk_speed_m_s = std::max(worst->trunk_speed_m_s, cell.body->trunk_speed_m_s);
    worst->ground_force_N = std::max(worst->ground_force_N, cell.body->ground_force_N);
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
  std::string table = "| row | fault | answer of the processes | event | walking robot |\n|---|---|---|---|---|\n";
  for (const Row& row : rows()) {
    table += "| `" + std::string(row.name) + "` | " + row.fault + " | " + row.does + " | " +
             (row.expected.event == nullptr ? "" : "`" + std::string(row.expected.event) + "`") + " | " +
             on_ground_text(row) + " |\n";
  }
  return table;
}

std::string fault_page_markdown(const std::vector<Cell>& cells, const PageFacts& facts) {
  std::string page =
      "# Faults\n\nWritten by `farrier faults --page`, which makes each fault of [faults.md](../faults.md) happen to a "
      "trot "
      "of real processes on the real-time\nclock" +
      (facts.slow == 1 ? "" : ", in slow motion by " + std::to_string(facts.slow)) +
      "; where a process starts, in slow motion by " + std::to_string(facts.slow * kSlowerWhereProcessesStart) +
      ". Every row is made in stance and in swing, over each\nvendor, by each seed. " + kTimesText + "\n\n" +
      counts_text(cells, facts) + "| row | measured |\n|---|---|\n";
  for (const Row& row : rows()) {
    const auto worst = worst_checks(cells, row.name);
    if (!worst.empty()) {
      page += "| `" + std::string(row.name) + "` | " + checks_text(worst) + " |\n";
    }
  }
  return page + failures_text(cells, "##");
}

std::string ground_page_markdown(const std::vector<Cell>& cells, const PageFacts& facts, const std::string& robot) {
  std::string page =
      "## On a ground\n\nWritten by `farrier faults --world body --page`. The faults happen to " + robot +
      " while it trots on a plane, on the joints and the supply of its file, in slow motion by " +
      std::to_string(facts.slow) + "; where a process starts, by " +
      std::to_string(facts.slow * kSlowerWhereProcessesStart) + ".\n" + kTimesText +
      " A fall is counted and breaks no bound by itself. In a row that says \"walks on\" the robot must "
      "not fall, and no stride may be slower than half of the command.\nSpeed is the largest of the trunk "
      "downwards, force the largest of the ground on a foot, from the fault on.\n\n" +
      counts_text(cells, facts) + "Falls of the robot: " + std::to_string(std::ranges::count_if(cells, &Cell::fell)) +
      ".\n\n| row | walking robot | cells | held | falls | speed, m/s | force, N | measured "
      "|\n|---|---|---|---|---|---|---|---|\n";
  for (const Row& row : rows()) {
    std::vector<Cell> of_row;
    std::ranges::copy_if(cells, std::back_inserter(of_row), [&](const Cell& cell) { return cell.row == row.name; });
    if (of_row.empty()) {
      continue;
    }
    const auto worst = worst_body(cells, row.name);
    const auto number = [&](double BodyAfterFault::*of) { return worst ? report::short_number(*worst.*of) : "-"; };
    page += "| `" + std::string(row.name) + "` | " + on_ground_text(row) + " | " + std::to_string(of_row.size()) +
            " | " + std::to_string(std::ranges::count_if(of_row, &Cell::holds)) + " | " +
            std::to_string(std::ranges::count_if(of_row, &Cell::fell)) + " | " +
            number(&BodyAfterFault::trunk_speed_m_s) + " | " + number(&BodyAfterFault::ground_force_N) + " | " +
            checks_text(worst_checks(of_row, row.name)) + " |\n";
  }
  return page + failures_text(cells, "###");
}

}  // namespace farrier::faults
