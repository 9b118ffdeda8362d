#include "tools/playback/csv_reader.hpp"

#include <algorithm>

namespace farrier::playback {

bool CsvReader::next(std::vector<std::string>& cells) {
  using Traits = std::char_traits<char>;
  cells.assign(1, {});
  line_ = next_line_;
  bool quoted = false;
  for (auto letter = file_.get(); letter != Traits::eof(); letter = file_.get()) {
    next_line_ += letter == '\n' ? 1 : 0;
    if (quoted) {
      if (letter != '"') {
        cells.back() += Traits::to_char_type(letter);
      } else if (file_.peek() == '"') {
        cells.back() += Traits::to_char_type(file_.get());
      } else {
        quoted = false;
      }
    } else if (letter == '"') {
      quoted = true;
    } else if (letter == ',') {
      cells.emplace_back();
    } else if (letter == '\n') {
      return true;
    } else if (letter != '\r') {
      cells.back() += Traits::to_char_type(letter);
    }
  }
  return cells.size() > 1 || !cells.front().empty();
}

std::uint64_t CsvReader::position() {
  file_.clear();
  return static_cast<std::uint64_t>(std::max<std::streamoff>(file_.tellg(), 0));
}

}  // namespace farrier::playback
