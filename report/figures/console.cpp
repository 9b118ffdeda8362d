#include "report/figures/console.hpp"

#include <unistd.h>

#include <algorithm>
#include <array>
#include <cstdlib>

#include "report/figures/text_format.hpp"

namespace farrier::report {
namespace {

constexpr std::size_t kWidth = 100;

struct Cell {
  std::string text;
  bool fails = false;
};
using Row = std::vector<Cell>;

class Paper {
 public:
  explicit Paper(bool colour) : colour_(colour) {}

  /// Columns as wide as their longest cell, and two more where one fails; the first is flush left, others right.
  void table(const std::vector<Row>& rows) {
    std::vector<std::size_t> widths;
    std::vector<bool> marked;
    for (const Row& row : rows) {
      widths.resize(std::max(widths.size(), row.size()));
      marked.resize(widths.size());
      for (std::size_t i = 0; i < row.size(); ++i) {
        widths[i] = std::max(widths[i], row[i].text.size());
        marked[i] = marked[i] || row[i].fails;
      }
    }
    for (const Row& row : rows) {
      for (std::size_t i = 0; i < row.size(); ++i) {
        const std::string gap(widths[i] - row[i].text.size(), ' ');
        const std::string cell = row[i].fails ? red(row[i].text + " !") : row[i].text + (marked[i] ? "  " : "");
        text += i == 0 ? cell + gap : "  " + gap + cell;
      }
      end_line();
    }
    text += '\n';
  }

  /// `items` separated by commas, broken at kWidth; the first line starts with `head`, the others as far right.
  void wrapped(const std::string& head, const std::vector<std::string>& items) {
    text += head;
    std::size_t column = head.size();
    for (std::size_t i = 0; i < items.size(); ++i) {
      const std::string item = items[i] + (i + 1 < items.size() ? ", " : "");
      if (column > head.size() && column + item.size() > kWidth) {
        end_line();
        text.append(head.size(), ' ');
        column = head.size();
      }
      text += item;
      column += item.size();
    }
    end_line();
  }

  void line(const std::string& content) {
    text += content;
    end_line();
  }
  void end_line() {
    text.erase(text.find_last_not_of(' ') + 1);
    text += '\n';
  }

  std::string red(const std::string& content) const { return paint("\033[31m", content); }
  std::string green(const std::string& content) const { return paint("\033[32m", content); }

  std::string text;

 private:
  std::string paint(const char* code, const std::string& content) const {
    return colour_ ? code + content + "\033[0m" : content;
  }

  bool colour_;
};

struct ConsoleColumn {
  const char* title;
  const char* figure;
};
constexpr std::array kConsoleColumns{ConsoleColumn{"updates", "updates"},
                                     ConsoleColumn{"stance NRMSE", "stance_nrmse"},
                                     ConsoleColumn{"swing design", "swing_design_stance_nrmse"},
                                     ConsoleColumn{"swing NRMSE", "swing_nrmse"},
                                     ConsoleColumn{"swing design", "swing_design_swing_nrmse"},
                                     ConsoleColumn{"missed", "missed_ticks"},
                                     ConsoleColumn{"travel rad", "travel_rad"},
                                     ConsoleColumn{"radius stance", "stance_spectral_radius"},
                                     ConsoleColumn{"swing", "swing_spectral_radius"}};

bool is_in_joint_table(const Figure& figure) {
  return std::ranges::any_of(kConsoleColumns, [&](const ConsoleColumn& column) {
    return match(std::string("trot.<joint>.") + column.figure, figure.name).has_value();
  });
}

void add_joint_table(Paper& paper, const Figures& figures) {
  const std::vector<std::string> joints = joints_of(figures);
  if (joints.empty()) {
    return;
  }
  std::vector<Row> rows{{{"joint"}}};
  for (const std::string& joint : joints) {
    rows.push_back({{joint}});
  }
  for (const ConsoleColumn& column : kConsoleColumns) {
    std::vector<Cell> cells;
    bool any = false;
    for (const std::string& joint : joints) {
      const Figure* figure = figures.find("trot." + joint + "." + column.figure);
      any = any || figure != nullptr;
      cells.push_back(figure == nullptr ? Cell{} : Cell{short_number(figure->value), !figure->holds()});
    }
    if (any) {
      rows[0].push_back({column.title});
      for (std::size_t i = 0; i < cells.size(); ++i) {
        rows[i + 1].push_back(std::move(cells[i]));
      }
    }
  }
  paper.table(rows);
}

void add_other_figures(Paper& paper, const Figures& figures) {
  std::vector<Row> rows;
  for (const Figure& figure : figures.all()) {
    const bool nothing_to_tell =
        (figure.name.ends_with(".not_tracking_ticks") || figure.name.ends_with(".refused_designs")) &&
        figure.value == 0 && figure.holds();
    const bool elsewhere = nothing_to_tell || is_in_joint_table(figure) || figure.name.starts_with("trot.packets.") ||
                           figure.name.starts_with("trot.latency_");
    if (!elsewhere) {
      rows.push_back({{figure.name}, {value_with_unit(figure), !figure.holds()}, {bound_text(figure)}});
    }
  }
  if (!rows.empty()) {
    paper.table(rows);
  }
}

std::string padded(std::string text, std::size_t width) {
  text.resize(std::max(text.size(), width), ' ');
  return text;
}

void add_processes(Paper& paper, const RunInfo& run) {
  std::size_t name_width = 0;
  std::size_t pid_width = 0;
  std::size_t vendor_width = 0;
  for (const ProcessInfo& process : run.processes) {
    name_width = std::max(name_width, process.name.size());
    pid_width = std::max(pid_width, std::to_string(process.pid).size());
    vendor_width = std::max(vendor_width, process.vendor.size());
  }
  for (const ProcessInfo& process : run.processes) {
    const std::string head = padded(process.name, name_width) + "  pid " +
                             padded(std::to_string(process.pid), pid_width) + "  " +
                             padded(process.vendor, vendor_width) + "  ";
    std::vector<std::string> items = topic_texts(process);
    if (process.missed_periods > 0) {
      items.insert(items.begin(), std::to_string(process.missed_periods) + " missed periods");
    }
    paper.wrapped(head, items);
  }
  if (!run.processes.empty()) {
    paper.text += '\n';
  }
}

void add_latency(Paper& paper, const Figures& figures) {
  const Figure* median = figures.find("trot.latency_p50_us");
  const Figure* tail = figures.find("trot.latency_p99_us");
  if (median != nullptr && tail != nullptr) {
    paper.line("latency from sensor sample to valve command: median " + value_with_unit(*median) + ", 99 % within " +
               value_with_unit(*tail));
  }
}

void add_verdict(Paper& paper, const Outcome& outcome) {
  for (const std::string& warning : outcome.warnings) {
    paper.line("warning: " + warning);
  }
  for (const std::string& reason : reasons_to_fail(outcome.figures, outcome.failures)) {
    paper.line(paper.red("! " + reason));
  }
  paper.line(outcome.command + ": " + (outcome.passes() ? paper.green("pass") : paper.red("fail")));
}

}  // namespace

bool wants_colour(int file_descriptor) { return ::isatty(file_descriptor) == 1 && std::getenv("NO_COLOR") == nullptr; }

std::string console_text(const Outcome& outcome, bool colour) {
  Paper paper(colour);
  add_joint_table(paper, outcome.figures);
  add_other_figures(paper, outcome.figures);
  add_processes(paper, outcome.run);
  add_latency(paper, outcome.figures);
  add_verdict(paper, outcome);
  return std::move(paper.text);
}

std::string verdict_text(const Outcome& outcome, bool colour) {
  Paper paper(colour);
  add_verdict(paper, outcome);
  return std::move(paper.text);
}

}  // namespace farrier::report
