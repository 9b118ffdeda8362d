#include "diagnosis/data/csv_text.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdlib>

namespace farrier::diagnosis {
namespace {

constexpr std::size_t kLongestLine = 65'536;

bool is_space(char c) { return c == ' ' || c == '\t' || c == '\r'; }

bool is_comment(std::string_view content) {
  return content.front() == '#' || content.front() == '%' || content.starts_with("//");
}

std::string_view trimmed(std::string_view text) {
  while (!text.empty() && is_space(text.front())) {
    text.remove_prefix(1);
  }
  while (!text.empty() && is_space(text.back())) {
    text.remove_suffix(1);
  }
  return text;
}

}  // namespace

CsvLines::CsvLines(const std::string& path) : file_(path, std::ios::binary), buffer_(kLongestLine) {}

bool CsvLines::next_of_any_kind() {
  file_.getline(buffer_.data(), static_cast<std::streamsize>(buffer_.size()));
  if (file_.fail()) {
    too_long_ = !file_.eof() && file_.gcount() > 0;
    return false;
  }
  const auto count = static_cast<std::size_t>(file_.gcount());
  ++number_;
  text_ = std::string_view(buffer_.data(), file_.eof() ? count : count - 1);  // the line end counts
  if (number_ == 1 && text_.starts_with("\xef\xbb\xbf")) {
    text_.remove_prefix(3);
  }
  return true;
}

bool CsvLines::next() {
  while (next_of_any_kind()) {
    const std::string_view content = trimmed(text_);
    if (!content.empty() && !is_comment(content)) {
      return true;
    }
  }
  return false;
}

char separator_of(std::string_view line) {
  char best = ',';
  for (const char separator : {';', '\t'}) {
    best = std::ranges::count(line, separator) > std::ranges::count(line, best) ? separator : best;
  }
  return best;
}

void split(std::string_view line, char separator, std::vector<std::string>& cells) {
  std::size_t used = 0;
  for (std::size_t at = 0;;) {
    if (used == cells.size()) {
      cells.emplace_back();
    }
    std::string& cell = cells[used++];
    cell.clear();
    while (at < line.size() && is_space(line[at]) && line[at] != separator) {
      ++at;
    }
    const bool in_quotes = at < line.size() && line[at] == '"';
    at += in_quotes ? 1 : 0;
    for (bool open = in_quotes; at < line.size() && (open || line[at] != separator); ++at) {
      if (open && line[at] == '"') {
        open = at + 1 < line.size() && line[at + 1] == '"';  // a doubled quote is one
        at += open ? 1 : 0;
        if (!open) {
          continue;
        }
      }
      cell += line[at];
    }
    cell = std::string(trimmed(cell));
    if (at >= line.size()) {
      break;
    }
    ++at;  // the separator
  }
  cells.resize(used);
}

Cell parse_cell(const std::string& cell, double& value) {
  if (cell.empty()) {
    return Cell::kEmpty;
  }
  if (std::ranges::count(cell, ',') == 1 && cell.find('.') == std::string::npos) {
    std::string with_point = cell;
    std::ranges::replace(with_point, ',', '.');
    return parse_cell(with_point, value);
  }
  const bool plus = cell.size() > 1 && cell[0] == '+' && cell[1] != '-';
  const char* const end = cell.data() + cell.size();
  const auto result = std::from_chars(cell.data() + (plus ? 1 : 0), end, value);
  if (result.ptr != end || result.ec == std::errc::invalid_argument) {
    return Cell::kText;
  }
  if (result.ec == std::errc::result_out_of_range) {
    value = std::strtod(cell.c_str(), nullptr);  // 1e-400 is 0, 1e400 is infinite
  }
  return std::isfinite(value) ? Cell::kNumber : Cell::kNotFinite;
}

bool is_text(std::string_view line) {
  return std::none_of(line.begin(), line.end(), [](char c) {
    const auto byte = static_cast<unsigned char>(c);
    return byte < 0x20 && !is_space(c);
  });
}

}  // namespace farrier::diagnosis
