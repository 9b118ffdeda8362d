#pragma once

#include <gtest/gtest.h>

#include <string>

#include "tests/unit/robot/test_files.hpp"

namespace farrier::urdf {

/// Shipped robots that are described as rigid bodies.
inline constexpr const char* kWithBody[] = {"hyq", "hexapod", "electric_quad", "go1"};

using robot::load_shipped;

/// The text with `from` replaced, which must be there.
inline std::string with(std::string text, const std::string& from, const std::string& to) {
  const std::size_t at = text.find(from);
  EXPECT_NE(at, std::string::npos) << from;
  return at == std::string::npos ? text : text.replace(at, from.size(), to);
}

}  // namespace farrier::urdf
