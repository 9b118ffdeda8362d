#pragma once

#include <cctype>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace farrier {

/// "a, b, c" of {"a", "b", "c"} and ", ".
inline std::string join(const std::vector<std::string>& parts, std::string_view between) {
  std::string text;
  for (const std::string& part : parts) {
    text += text.empty() ? "" : between;
    text += part;
  }
  return text;
}

/// "1 value", "3 values"; `one` takes an "s".
inline std::string counted(std::uint64_t count, const std::string& one) {
  return std::to_string(count) + " " + one + (count == 1 ? "" : "s");
}

/// ASCII letters in lower case.
inline std::string lower(std::string_view text) {
  std::string low;
  for (const char letter : text) {
    low += static_cast<char>(std::tolower(static_cast<unsigned char>(letter)));
  }
  return low;
}

}  // namespace farrier
