#include "diagnosis/data/csv_columns.hpp"

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <limits>

#include "diagnosis/data/csv_text.hpp"
#include "diagnosis/judge/finding_text.hpp"

namespace farrier::diagnosis {
namespace {

constexpr std::size_t kMostOthers = 64;

/// Why a file cannot be read at all; empty when it can.
std::vector<Finding> refusal(const std::string& path) {
  std::error_code code;
  if (std::filesystem::is_directory(path, code)) {
    return {{"directory", 0, "cannot read the file " + path + ": it is a directory; name a CSV file"}};
  }
  errno = 0;
  std::ifstream file(path);
  if (!file) {
    return {{"unreadable", 0, "cannot read the file " + path + ": " + std::strerror(errno == 0 ? EIO : errno)}};
  }
  if (file.peek() == std::ifstream::traits_type::eof()) {
    return {{"empty", 0, "the file " + path + " is empty; record at least " + rounded(kShortestDuration_s) + " s"}};
  }
  return {};
}

Finding not_text(std::size_t line) {
  return {"not_text", line,
          "line " + std::to_string(line) + " is not a line of text; save the recording as CSV in UTF-8"};
}

/// Faults in the cells of one column.
class CellFaults {
 public:
  double read(const std::string& cell, std::size_t line) {
    double value = 0.0;
    switch (parse_cell(cell, value)) {
      case Cell::kNumber: return value;
      case Cell::kEmpty: empty_.add(line); break;
      case Cell::kNotFinite: not_finite_.add(line); break;
      case Cell::kText:
        first_text_ = text_.count() == 0 ? shown(cell) : first_text_;
        text_.add(line);
        break;
    }
    return std::numeric_limits<double>::quiet_NaN();
  }

  void report(const std::string& name, std::vector<Finding>& findings) const {
    const auto add = [&](const char* what, const Places& places, const std::string& sentence) {
      if (places.count() > 0) {
        findings.push_back({what, places.first(), places.text() + ", column " + name + ": " + sentence});
      }
    };
    const std::string remedy = "; cut the recording there, or record again";
    add("empty_cell", empty_, counted(empty_.count(), "cell") + " without a value" + remedy);
    add("not_a_number", text_, counted(text_.count(), "cell") + " that cannot be read as a number, first " +
                                   first_text_ + "; write plain numbers with a decimal point");
    add("nan", not_finite_, counted(not_finite_.count(), "value") + " not finite (NaN or infinite)" + remedy);
  }

 private:
  Places empty_, text_, not_finite_;
  std::string first_text_;
};

/// Rows of another length than the header.
struct RaggedRows {
  Places places;
  std::size_t first_cells = 0;
  bool cut_off = false;  ///< the last line alone, and the file ends within it

  void add(std::size_t cells, const CsvLines& lines) {
    first_cells = places.count() == 0 ? cells : first_cells;
    places.add(lines.number());
    cut_off = places.count() == 1 && lines.cut_off();
  }

  void report(CsvColumns& table) const {
    if (places.count() == 0) {
      return;
    }
    const std::size_t columns = table.header.size();
    std::string text = places.text() + ": " + counted(places.count(), "row") +
                       " with another number of cells than the " + std::to_string(columns) + " of line " +
                       std::to_string(table.header_line) + " (first " + std::to_string(first_cells) + "); ";
    if (cut_off) {
      text += "the last line is cut off: delete it";
    } else if (first_cells > columns) {
      text += "write numbers with a decimal point, not a comma";
    } else {
      text += "complete or delete them";
    }
    table.findings.push_back({"ragged_row", places.first(), text});
  }
};

/// Reads one file.
class ColumnReader {
 public:
  ColumnReader(const std::string& path, const std::vector<std::string>& names, const std::optional<CsvFilter>& filter)
      : names_(names), filter_(filter), lines_(path), faults_(names.size()) {
    table_.present.resize(names.size());
    table_.columns.resize(names.size());
  }

  CsvColumns read() && {
    if (read_header_line()) {
      read_rows();
    }
    return std::move(table_);
  }

 private:
  bool read_header_line() {
    if (!lines_.next()) {
      table_.findings.push_back(lines_.too_long() ? not_text(lines_.number() + 1)
                                                  : Finding{"empty", 0, "the file holds nothing but comments"});
      return false;
    }
    if (!is_text(lines_.text())) {
      table_.findings.push_back(not_text(lines_.number()));
      return false;
    }
    split(lines_.text(), cells_);
    table_.header_line = lines_.number();
    check_header();
    if (!table_.findings.empty()) {
      return false;
    }
    table_.header = cells_;
    for (std::size_t i = 0; i < names_.size(); ++i) {
      place_.push_back(place_of(names_[i]));
      table_.present[i] = place_[i] < cells_.size();
    }
    return true;
  }

  std::size_t place_of(const std::string& name) const {
    return static_cast<std::size_t>(std::find(cells_.begin(), cells_.end(), name) - cells_.begin());
  }

  void check_header() {
    const auto refuse = [&](const char* what, const std::string& text) {
      const std::size_t line = table_.header_line;
      table_.findings.push_back({what, line, "line " + std::to_string(line) + text});
    };
    if (std::none_of(names_.begin(), names_.end(), [&](const auto& name) { return place_of(name) < cells_.size(); })) {
      double value = 0.0;
      const bool semicolons = lines_.text().find(';') != std::string_view::npos;
      if (cells_.size() == 1 && (semicolons || lines_.text().find('\t') != std::string_view::npos)) {
        refuse("wrong_separator", std::string(" separates its columns with ") + (semicolons ? "';'" : "tabs") +
                                      "; save the file with commas between columns and decimal points");
      } else if (parse_cell(cells_[0], value) == Cell::kNumber) {
        refuse("no_header", " holds numbers; begin the file with the names of its columns, such as " + names_[0]);
      } else {
        refuse("not_a_recording", " names no column of a recording; begin with their names, such as " + names_[0]);
      }
    }
    for (const std::string& name : names_) {
      if (const auto count = std::count(cells_.begin(), cells_.end(), name); count > 1) {
        refuse("duplicate_column", ", column " + name + " is there " + std::to_string(count) + " times; keep one");
      }
    }
  }

  void read_rows() {
    const std::size_t filter_place = filter_ ? place_of(filter_->column) : table_.header.size();
    while (lines_.next()) {
      split(lines_.text(), cells_);
      const bool whole = cells_.size() == table_.header.size();
      if (whole && filter_place < cells_.size() && cells_[filter_place] != filter_->value) {
        note_other(cells_[filter_place]);
        continue;
      }
      if (table_.line.size() == kMostSamples) {
        table_.findings.push_back({"too_long", lines_.number(),
                                   "line " + std::to_string(lines_.number()) + " is beyond " +
                                       counted(kMostSamples, "sample") + "; cut out the part to be diagnosed"});
        break;
      }
      if (!whole) {
        ragged_.add(cells_.size(), lines_);
      }
      table_.line.push_back(lines_.number());
      for (std::size_t i = 0; i < names_.size(); ++i) {
        if (table_.present[i]) {
          table_.columns[i].push_back(whole ? faults_[i].read(cells_[place_[i]], lines_.number())
                                            : std::numeric_limits<double>::quiet_NaN());
        }
      }
    }
    if (lines_.too_long()) {
      table_.findings.push_back(not_text(lines_.number() + 1));
    }
    ragged_.report(table_);
    for (std::size_t i = 0; i < names_.size(); ++i) {
      faults_[i].report(names_[i], table_.findings);
    }
  }

  void note_other(const std::string& other) {
    auto& others = table_.others;
    if (others.size() < kMostOthers && std::find(others.begin(), others.end(), other) == others.end()) {
      others.push_back(other);
    }
  }

  const std::vector<std::string>& names_;
  const std::optional<CsvFilter>& filter_;
  CsvLines lines_;
  CsvColumns table_{};
  std::vector<std::string> cells_;
  std::vector<std::size_t> place_;
  std::vector<CellFaults> faults_;
  RaggedRows ragged_;
};

}  // namespace

CsvColumns read_columns(const std::string& path, const std::vector<std::string>& names,
                        const std::optional<CsvFilter>& filter) {
  CsvColumns refused;
  refused.findings = refusal(path);
  return refused.findings.empty() ? ColumnReader(path, names, filter).read() : refused;
}

std::vector<std::string> read_header(const std::string& path) {
  std::vector<std::string> header;
  if (refusal(path).empty()) {
    CsvLines lines(path);
    if (lines.next()) {
      split(lines.text(), header);
    }
  }
  return header;
}

}  // namespace farrier::diagnosis
