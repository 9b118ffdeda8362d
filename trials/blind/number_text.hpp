#pragma once

#include <cstdio>
#include <string>

namespace farrier::blind {

/// A number as a format of printf for a double has it.
inline std::string number_text(const char* format, double value) {
  char text[40];
  std::snprintf(text, sizeof text, format, value);
  return text;
}

}  // namespace farrier::blind
