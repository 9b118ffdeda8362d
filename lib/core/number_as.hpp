#pragma once

#include <cstdio>
#include <string>

namespace farrier {

/// A number as `format` of printf writes it, "%.1f N", in at most 95 characters; `format` takes a double.
inline std::string number_as(const char* format, double value) {
  char text[96];
  std::snprintf(text, sizeof text, format, value);
  return text;
}

}  // namespace farrier
