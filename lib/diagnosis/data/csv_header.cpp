#include "diagnosis/data/csv_header.hpp"

#include <algorithm>

#include "diagnosis/data/csv_faults.hpp"

namespace farrier::diagnosis {
namespace {

void understand(CsvHeader& header, const std::vector<std::string>& names, const CsvNaming& naming) {
  if (naming.meanings) {
    header.meaning = meaning_of(header.cells, names, naming.joint);
    return;
  }
  header.meaning = {};
  for (const std::string& cell : header.cells) {
    const bool known = std::ranges::find(names, cell) != names.end();
    header.meaning.columns.push_back(known ? std::optional(MeantColumn{.name = cell}) : std::nullopt);
  }
}

bool names_a_column(const CsvHeader& header) {
  return !header.meaning.findings.empty() ||
         std::ranges::any_of(header.meaning.columns, [](const auto& column) { return column.has_value(); });
}

/// The columns that were probably meant, for the end of a sentence.
std::string suggestions(const std::vector<std::string>& cells) {
  std::string text;
  for (const std::string& cell : cells) {
    if (const auto meant = meant_column(cell); meant && meant->group.empty()) {
      text += (text.empty() ? "; perhaps " : ", ") + meant->name + " for " + shown(cell);
    }
  }
  return text;
}

void check(CsvHeader& header, const std::vector<std::string>& names, const CsvNaming& naming) {
  const auto refuse = [&](const std::string& what, const std::string& text) {
    header.findings.push_back({what, header.line, "line " + std::to_string(header.line) + text});
  };
  for (const Finding& finding : header.meaning.findings) {
    refuse(finding.what, ", " + finding.text);
  }
  if (!names_a_column(header)) {
    double value = 0.0;
    if (parse_cell(header.cells[0], value) == Cell::kNumber) {
      refuse("no_header", " holds numbers; begin the file with the names of its columns, such as " + names[0]);
    } else {
      refuse("not_a_recording", " names no column of a recording; begin with their names, such as " + names[0] +
                                    (naming.meanings ? suggestions(header.cells) : ""));
    }
  }
  for (const std::string& name : names) {
    const auto count = std::ranges::count_if(header.meaning.columns,
                                             [&](const auto& column) { return column && column->name == name; });
    if (count > 1) {
      refuse("duplicate_column", ", column " + name + " is there " + std::to_string(count) + " times; keep one");
    }
  }
}

}  // namespace

std::size_t CsvHeader::place_of(const std::string& name) const {
  const auto found =
      std::ranges::find_if(meaning.columns, [&](const auto& column) { return column && column->name == name; });
  return static_cast<std::size_t>(found - meaning.columns.begin());
}

CsvHeader read_csv_header(const std::string& path, const std::vector<std::string>& names, const CsvNaming& naming) {
  CsvHeader first, before, header;
  CsvLines lines(path);
  for (std::size_t looked = 0; looked < kMostPreamble && lines.next(); ++looked) {
    header = {};
    header.line = lines.number();
    if (!is_text(lines.text())) {
      header.findings.push_back(not_text(header.line));
      return first.line == 0 ? header : first;
    }
    header.separator = separator_of(lines.text());
    split(lines.text(), header.separator, header.cells);
    understand(header, names, naming);
    if (names_a_column(header)) {
      break;
    }
    if (CsvHeader with_units = before; before.line > 0 && naming.meanings &&
                                       take_units(with_units, header.cells, names, naming) &&
                                       names_a_column(with_units)) {
      header = with_units;
      header.findings.clear();
      first = first.line == header.line ? CsvHeader{} : first;
      break;
    }
    before = header;
    if (first.line == 0) {
      first = header;
      check(first, names, naming);
    }
  }
  if (header.line == 0) {
    header.findings.push_back(lines.too_long() ? not_text(lines.number() + 1)
                                               : Finding{"empty", 0, "the file holds nothing but comments"});
    return header;
  }
  if (!names_a_column(header)) {
    return first;
  }
  check(header, names, naming);
  if (first.line > 0) {
    header.remarks.push_back("The names of the columns are in line " + std::to_string(header.line) +
                             "; lines before it are not read.");
  }
  if (header.separator != ',') {
    header.remarks.push_back(std::string("Columns are separated by ") + (header.separator == ';' ? "';'" : "tabs") +
                             ".");
  }
  return header;
}

bool take_units(CsvHeader& header, const std::vector<std::string>& cells, const std::vector<std::string>& names,
                const CsvNaming& naming) {
  double value = 0.0;
  if (std::ranges::none_of(cells, is_unit) ||
      std::ranges::any_of(cells, [&](const std::string& cell) { return parse_cell(cell, value) == Cell::kNumber; })) {
    return false;
  }
  for (std::size_t i = 0; i < std::min(cells.size(), header.cells.size()); ++i) {
    const bool exact = std::ranges::find(names, header.cells[i]) != names.end();
    if (is_unit(cells[i]) && !exact && !(header.meaning.columns[i] && header.meaning.columns[i]->has_unit)) {
      const bool brackets = cells[i].front() == '[' || cells[i].front() == '(';
      header.cells[i] += brackets ? " " + cells[i] : " [" + cells[i] + "]";
    }
  }
  understand(header, names, naming);
  check(header, names, naming);
  return true;
}

}  // namespace farrier::diagnosis
