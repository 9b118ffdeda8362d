#pragma once

#include <array>
#include <cstddef>
#include <string>
#include <vector>

#include "core/text.hpp"
#include "diagnosis/data/recording.hpp"

namespace farrier::diagnosis {

/// Places of a finding: their number, and the first lines.
class Places {
 public:
  void add(std::size_t line) noexcept {
    if (count_ < first_.size()) {
      first_[count_] = line;
    }
    ++count_;
  }

  std::size_t count() const noexcept { return count_; }
  /// Line of the first; 0 for none.
  std::size_t first() const noexcept { return count_ == 0 ? 0 : first_[0]; }
  /// "line 12", "lines 12 and 40", "lines 12, 40, 41 and 17 more". Lines 0, of data without a file, give "".
  std::string text() const;

 private:
  std::array<std::size_t, 3> first_{};
  std::size_t count_ = 0;
};

/// A number for a sentence, four digits.
std::string rounded(double value);

/// Names of the columns of position, velocity and force: "position_m" or "angle_rad", ...
const char* position_column(Coordinates coordinates) noexcept;
const char* velocity_column(Coordinates coordinates) noexcept;
const char* force_column(Coordinates coordinates) noexcept;

/// Puts findings in the order of their lines; those of the file as a whole come first.
void sort_by_line(std::vector<Finding>& findings);

/// Text of a file in quotes, short and printable enough for a sentence.
std::string shown(const std::string& text);

}  // namespace farrier::diagnosis
