#pragma once

// Keys and permissions for tests, made once per binary; copies of them to corrupt.

#include <gtest/gtest.h>

#include <filesystem>
#include <string>

#include "tests/support/scratch_directory.hpp"
#include "tools/pki/pki.hpp"

namespace farrier::test {

inline constexpr const char* kRobot = "testrobot";

/// The CAs of a robot and what they issued. `days`: see pki::Plan.
class Pki {
 public:
  explicit Pki(int days = 365) {
    const auto made = pki::make({.robot = kRobot, .out = out(), .ca = ca(), .days = days});
    FARRIER_ENSURE(made.ok(), made.error().message.c_str());
  }
  std::string out() const { return folder_.file("keys"); }
  std::string ca() const { return folder_.file("ca"); }

  /// A copy of the issued folder, to corrupt; it goes with this object.
  std::string copy() {
    const std::string path = folder_.file("copy" + std::to_string(++copies_));
    std::filesystem::copy(out(), path, std::filesystem::copy_options::recursive);
    return path;
  }

 private:
  ScratchDirectory folder_;
  int copies_ = 0;
};

}  // namespace farrier::test
