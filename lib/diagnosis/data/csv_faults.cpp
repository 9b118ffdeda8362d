#include "diagnosis/data/csv_faults.hpp"

#include <limits>

namespace farrier::diagnosis {

Finding not_text(std::size_t line) {
  return {"not_text", line,
          "line " + std::to_string(line) + " is not a line of text; save the recording as CSV in UTF-8"};
}

double CellFaults::read(const std::string& cell, std::size_t line) {
  double value = 0.0;
  switch (parse_cell(cell, value)) {
    case Cell::kNumber:
      return value;
    case Cell::kEmpty:
      empty_.add(line);
      break;
    case Cell::kNotFinite:
      not_finite_.add(line);
      break;
    case Cell::kText:
      first_text_ = text_.count() == 0 ? shown(cell) : first_text_;
      text_.add(line);
      break;
  }
  return std::numeric_limits<double>::quiet_NaN();
}

void CellFaults::report(const std::string& name, std::vector<Finding>& findings) const {
  const auto add = [&](const char* what, const Places& places, const std::string& sentence) {
    if (places.count() > 0) {
      findings.push_back({what, places.first(), places.text() + ", column " + name + ": " + sentence});
    }
  };
  const std::string remedy = "; cut the recording there, or record again";
  add("empty_cell", empty_, counted(empty_.count(), "cell") + " without a value" + remedy);
  add("not_a_number", text_,
      counted(text_.count(), "cell") + " that cannot be read as a number, first " + first_text_ +
          "; write plain numbers with a decimal point");
  add("nan", not_finite_, counted(not_finite_.count(), "value") + " not finite (NaN or infinite)" + remedy);
}

void RaggedRows::add(std::size_t cells, const CsvLines& lines) {
  first_cells = places.count() == 0 ? cells : first_cells;
  places.add(lines.number());
  cut_off = places.count() == 1 && lines.cut_off();
}

void RaggedRows::report(CsvColumns& table) const {
  if (places.count() == 0) {
    return;
  }
  const std::size_t columns = table.header.size();
  std::string text = places.text() + ": " + counted(places.count(), "row") + " with another number of cells than the " +
                     std::to_string(columns) + " of line " + std::to_string(table.header_line) + " (first " +
                     std::to_string(first_cells) + "); ";
  if (cut_off) {
    text += "the last line is cut off: delete it";
  } else if (first_cells > columns) {
    text += "write numbers with a decimal point, not a comma, or separate the columns with ';'";
  } else {
    text += "complete or delete them";
  }
  table.findings.push_back({"ragged_row", places.first(), text});
}

}  // namespace farrier::diagnosis
