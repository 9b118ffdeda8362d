#pragma once

#include <gtest/gtest.h>

#include <fstream>
#include <sstream>
#include <string>

#include "robot/robot.hpp"

namespace farrier::robot {

inline std::string shipped(const std::string& name) { return std::string(FARRIER_ROBOTS) + name + ".yaml"; }

inline std::string text_of(const std::string& name) {
  std::ifstream stream(shipped(name));
  std::ostringstream text;
  text << stream.rdbuf();
  return text.str();
}

/// The same without its section effects, so that a test may append one.
inline std::string text_without_effects(const std::string& name) {
  std::string text = text_of(name);
  const auto begin = text.find("\neffects:\n") + 1;
  auto end = text.find('\n', begin) + 1;
  while (end < text.size() && (text[end] == ' ' || text[end] == '\n')) {
    end = text.find('\n', end) + 1;
  }
  return begin == 0 ? text : text.erase(begin, end - begin);
}

/// A shipped robot; a test that gets none fails with the reasons.
inline Robot load_shipped(const std::string& name, const Overrides& overrides = {}) {
  auto robot = load_robot(shipped(name), overrides);
  EXPECT_TRUE(robot.ok()) << (robot ? "" : to_string(robot.error()));
  return robot ? std::move(robot).value() : Robot{};
}

/// `text` with the only occurrence of `from` replaced.
inline std::string replaced(std::string text, const std::string& from, const std::string& to) {
  const auto at = text.find(from);
  EXPECT_NE(at, std::string::npos) << from;
  if (at != std::string::npos) {
    EXPECT_EQ(text.find(from, at + 1), std::string::npos) << from << " occurs twice";
    text.replace(at, from.size(), to);
  }
  return text;
}

/// Line (1-based) of the only occurrence.
inline int line_of(const std::string& text, const std::string& what) {
  return 1 + static_cast<int>(std::count(text.begin(), text.begin() + static_cast<long>(text.find(what)), '\n'));
}

}  // namespace farrier::robot
