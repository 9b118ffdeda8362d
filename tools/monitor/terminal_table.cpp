#include "tools/monitor/terminal_table.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "bus/bus.hpp"

namespace farrier::display {
namespace {

constexpr double kRobotSilent_s = 1.0;  // of a robot that runs: summaries come fifty times a second
constexpr int kFewestEvents = 3;        // lines kept for them before anything else gives way
constexpr int kMostEvents = 20;         // where the height is not limited

std::string number(const char* format, double value) {
  char text[48];
  std::snprintf(text, sizeof text, format, value);
  return text;
}

std::string microseconds(double seconds) { return number("%.0f us", seconds * 1e6); }

/// Cells under one another; columns of numbers flush right.
class Grid {
 public:
  explicit Grid(std::vector<std::string> heading, std::vector<bool> right)
      : rows_{{std::move(heading), Tone::kHeading}}, right_(std::move(right)) {}

  void add(std::vector<std::string> cells, Tone tone) { rows_.push_back({std::move(cells), tone}); }

  std::vector<Line> lines() const {
    std::vector<std::size_t> widths(right_.size());
    for (const Row& row : rows_) {
      for (std::size_t i = 0; i < widths.size(); ++i) {
        widths[i] = std::max(widths[i], row.cells[i].size());
      }
    }
    std::vector<Line> lines;
    for (const Row& row : rows_) {
      Line line{"", row.tone};
      for (std::size_t i = 0; i < widths.size(); ++i) {
        const std::string gap(widths[i] - row.cells[i].size(), ' ');
        line.text += (i == 0 ? "" : "  ") + (right_[i] ? gap + row.cells[i] : row.cells[i] + gap);
      }
      lines.push_back(std::move(line));
    }
    return lines;
  }

 private:
  struct Row {
    std::vector<std::string> cells;
    Tone tone;
  };
  std::vector<Row> rows_;
  std::vector<bool> right_;
};

/// The run in one line.
Line run_line(const monitor::Frame& frame, const robot::Robot& robot) {
  if (std::isinf(frame.age_s)) {
    return {robot.name + "  nothing heard yet; farrier doctor says why", Tone::kFaint};
  }
  std::string text = robot.name;
  const bool moded = frame.mode.epoch != 0 && frame.mode.mode <= signals::Mode::kStopped;
  text += std::string("  ") + (moded ? signals::to_string(frame.mode.mode) : "no mode");
  if (frame.tick != kNoTick) {
    text +=
        "  tick " + std::to_string(frame.tick) + number(" (%.2f s)", static_cast<double>(frame.tick) * robot.period_s);
  }
  std::uint64_t lost = 0, missed = 0;
  bool reported = false;
  for (const monitor::ParticipantFrame& process : frame.participants) {
    reported = reported || process.health.tick != kNoTick;
    lost += process.lost();
    missed += process.health.missed_periods;
    if (process.health.latency_s[0] > 0.0) {
      text += "  latency p50 " + microseconds(process.health.latency_s[0]) + ", p99 " +
              microseconds(process.health.latency_s[1]);
    }
  }
  if (reported) {  // in lock-step, at the end
    text += "  lost " + std::to_string(lost) + "  missed periods " + std::to_string(missed);
  }
  if (frame.lost_samples > 0) {
    text += "  lost on the way here " + std::to_string(frame.lost_samples);
  }
  if (frame.age_s > kRobotSilent_s) {
    return {text + number("  SILENT for %.0f s", frame.age_s), Tone::kBad};
  }
  return {text, Tone::kHeading};
}

bool is_number(Column column) {
  return column == Column::kError || column == Column::kNrmse || column == Column::kMass ||
         (column >= Column::kGeneration && column <= Column::kMissed);
}

std::vector<Line> lines_of_columns(const std::vector<JointRow>& rows, const TableView& view,
                                   const std::vector<Column>& columns) {
  std::vector<std::string> heading;
  std::vector<bool> right;
  for (const Column column : columns) {
    heading.push_back(std::string(to_string(column)) + (column == view.sorted_by ? (view.reversed ? " v" : " ^") : ""));
    right.push_back(is_number(column));
  }
  Grid grid(std::move(heading), std::move(right));
  for (const JointRow& row : rows) {
    std::vector<std::string> cells;
    for (const Column column : columns) {
      cells.push_back(row.cells[static_cast<std::size_t>(column)]);
    }
    grid.add(std::move(cells), row.tone);
  }
  return grid.lines();
}

/// Columns give way one by one where the width is short, the faults at the end never.
std::vector<Line> joint_lines(const std::vector<JointRow>& rows, const TableView& view) {
  std::vector<Column> columns;
  for (int i = 0; i < kColumnCount; ++i) {
    columns.push_back(static_cast<Column>(i));
  }
  std::vector<Line> lines = lines_of_columns(rows, view, columns);
  for (const Column least : {Column::kRedesigns, Column::kPhase, Column::kNrmse, Column::kPoles, Column::kMissed,
                             Column::kGeneration, Column::kRate, Column::kMass, Column::kError}) {
    if (view.width <= 0 || lines.front().text.size() <= static_cast<std::size_t>(view.width)) {
      break;
    }
    if (least != view.sorted_by) {
      std::erase(columns, least);
      lines = lines_of_columns(rows, view, columns);
    }
  }
  return lines;
}

std::vector<Line> process_lines(const monitor::Frame& frame) {
  Grid grid({"process", "dds", "tick", "periods", "missed", "lost", "wake-up p99", "health"},
            {false, false, true, true, true, true, true, true});
  for (const monitor::ParticipantFrame& process : frame.participants) {
    if (process.hello.session == 0) {
      continue;
    }
    const signals::SystemHealth& health = process.health;
    const bool heard = health.tick != kNoTick;
    const bool bad = health.missed_periods > 0 || process.lost() > 0;
    const auto count = [&](std::uint64_t value) { return heard ? std::to_string(value) : std::string("-"); };
    grid.add({printable(signals::text_of(process.hello.name)),
              process.hello.vendor <= static_cast<std::uint8_t>(bus::Vendor::kFast)
                  ? bus::to_string(static_cast<bus::Vendor>(process.hello.vendor))
                  : "?",
              heard ? std::to_string(health.tick) : "-", count(health.periods), count(health.missed_periods),
              count(process.lost()), health.wake_up_s[1] > 0.0 ? microseconds(health.wake_up_s[1]) : "-",
              !heard                     ? "-"
              : health.final_report != 0 ? "ended"
                                         : number("%.1f s ago", process.age_s)},
             bad ? Tone::kWarning : Tone::kPlain);
  }
  return grid.lines();
}

Line event_line(const monitor::EventFrame& event) {
  std::string severity = signals::to_string(event.severity);
  severity.resize(7, ' ');  // as long as the longest
  std::string text = number("%8.2f s", event.time_s) + "  " + severity;
  text += "  " + printable(event.who) + (event.joint.empty() ? "" : " " + event.joint) + ": " + printable(event.text);
  return {text, event.severity == signals::Severity::kError     ? Tone::kBad
                : event.severity == signals::Severity::kWarning ? Tone::kWarning
                                                                : Tone::kPlain};
}

std::string foot(const TableView& view, const Table& table) {
  if (view.typing) {
    return "filter: " + view.filter + "_";
  }
  std::string text = "h help  s sort  r reverse  / filter  f faults  p pause  q quit";
  text += view.filter.empty() ? "" : "   filter: " + view.filter;
  text += view.only_faulty ? "   only with faults" : "";
  text += table.shown < table.rows ? "   " + std::to_string(table.shown) + " of " + std::to_string(table.rows) : "";
  return text + (view.paused ? "   PAUSED" : "");
}

void append(std::vector<Line>& to, const std::vector<Line>& lines) { to.insert(to.end(), lines.begin(), lines.end()); }

}  // namespace

Table terminal_table(const monitor::Frame& frame, const robot::Robot& robot,
                     std::span<const monitor::EventFrame> events, const TableView& view) {
  std::vector<JointRow> rows = joint_rows(frame, robot, view);
  const bool limited = view.height > 0;
  const std::vector<Line> processes = process_lines(frame);
  Table table;
  table.rows = static_cast<int>(rows.size());
  table.lines.push_back(run_line(frame, robot));
  table.lines.push_back({});
  // The run, a gap, the heading, the foot, and a gap before the events.
  const int room = limited ? std::max(view.height - 5 - kFewestEvents, 1) : table.rows;
  table.shown = std::min(table.rows, room);
  const int first = std::clamp(view.first_row, 0, table.rows - table.shown);
  rows.erase(rows.begin(), rows.begin() + first);
  rows.resize(static_cast<std::size_t>(table.shown));
  append(table.lines, joint_lines(rows, view));
  const auto left = [&] { return view.height - static_cast<int>(table.lines.size()) - 1; };
  if (processes.size() > 1 && (!limited || left() >= static_cast<int>(processes.size()) + 2 + kFewestEvents)) {
    table.lines.push_back({});
    append(table.lines, processes);
  }
  table.lines.push_back({});
  if (view.help) {
    for (const char* line : help_lines()) {
      table.lines.push_back({line});
    }
  } else {
    const std::size_t most = limited ? static_cast<std::size_t>(std::max(left(), 0)) : kMostEvents;
    for (const monitor::EventFrame& event : events.last(std::min(events.size(), most))) {
      table.lines.push_back(event_line(event));
    }
  }
  if (limited) {
    table.lines.resize(static_cast<std::size_t>(std::max(view.height - 1, 1)));
    table.lines.push_back({foot(view, table), Tone::kFaint});
  }
  for (Line& line : table.lines) {
    if (view.width > 0 && line.text.size() > static_cast<std::size_t>(view.width)) {
      line.text.resize(static_cast<std::size_t>(view.width));
    }
    line.text.erase(line.text.find_last_not_of(' ') + 1);
  }
  return table;
}

std::string text_of(const Table& table) {
  std::string text;
  for (const Line& line : table.lines) {
    text += line.text + '\n';
  }
  return text;
}

}  // namespace farrier::display
