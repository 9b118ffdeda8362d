#include "diagnosis/data/timed_rows.hpp"

#include <algorithm>
#include <utility>

namespace farrier::diagnosis {

void TimedRows::keep(const RowNumbers& rows) {
  const auto chosen = [&](auto& values) {
    const auto old = std::exchange(values, {});
    for (const std::size_t row : rows) {
      values.push_back(old[row]);
    }
  };
  chosen(time_s_);
  chosen(line_);
  for (const TimedColumn& column : columns_) {
    if (!column.values->empty()) {
      chosen(*column.values);
    }
  }
}

bool TimedRows::same(std::size_t a, std::size_t b) const {
  return std::ranges::all_of(columns_, [&](const TimedColumn& column) {
    return column.values->empty() || (*column.values)[a] == (*column.values)[b];
  });
}

TimedRows::Copy TimedRows::copy() const {
  Copy made{.time_s = time_s_, .line = line_, .values = {}};
  for (const TimedColumn& column : columns_) {
    made.values.push_back(*column.values);
  }
  return made;
}

void TimedRows::restore(const Copy& copy) {
  time_s_ = copy.time_s;
  line_ = copy.line;
  for (std::size_t i = 0; i < columns_.size(); ++i) {
    *columns_[i].values = copy.values[i];
  }
}

}  // namespace farrier::diagnosis
