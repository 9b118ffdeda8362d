#include "diagnosis/judge/finding_text.hpp"

#include <algorithm>
#include <cstdio>

namespace farrier::diagnosis {

std::string Places::text() const {
  if (first() == 0) {
    return "";
  }
  const std::size_t named = std::min(count_, first_.size());
  std::string text = count_ == 1 ? "line " : "lines ";
  for (std::size_t i = 0; i < named; ++i) {
    const bool last = i + 1 == named && count_ == named;
    text += (i == 0 ? "" : last ? " and " : ", ") + std::to_string(first_[i]);
  }
  return count_ > named ? text + " and " + std::to_string(count_ - named) + " more" : text;
}

std::string rounded(double value) {
  char text[40];
  std::snprintf(text, sizeof text, "%.4g", value);
  return text;
}

const char* position_column(Coordinates coordinates) noexcept {
  return coordinates == Coordinates::kLinear ? "position_m" : "angle_rad";
}

const char* velocity_column(Coordinates coordinates) noexcept {
  return coordinates == Coordinates::kLinear ? "velocity_m_s" : "velocity_rad_s";
}

const char* force_column(Coordinates coordinates) noexcept {
  return coordinates == Coordinates::kLinear ? "force_N" : "torque_Nm";
}

void sort_by_line(std::vector<Finding>& findings) {
  std::stable_sort(findings.begin(), findings.end(), [](const Finding& a, const Finding& b) { return a.row < b.row; });
}

std::string shown(const std::string& text) {
  constexpr std::size_t kLongest = 24;
  std::string start = text.substr(0, kLongest);
  for (char& c : start) {
    const auto byte = static_cast<unsigned char>(c);
    c = byte < 0x20 || byte >= 0x7f ? '?' : c;
  }
  return "'" + start + (text.size() > kLongest ? "...'" : "'");
}

}  // namespace farrier::diagnosis
