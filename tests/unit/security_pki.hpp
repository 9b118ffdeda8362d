#pragma once

// Keys and permissions for tests, made once per binary; copies of them to spoil.

#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <string>

#include "tools/pki/pki.hpp"

namespace farrier::test {

inline constexpr const char* kRobot = "testrobot";

/// A folder that goes with its test.
class PkiFolder {
 public:
  PkiFolder() {
    std::string pattern = std::filesystem::temp_directory_path() / "farrier-pki-test-XXXXXX";
    FARRIER_ENSURE(::mkdtemp(pattern.data()) != nullptr, "a temporary folder");
    path_ = pattern;
  }
  ~PkiFolder() { std::filesystem::remove_all(path_); }
  PkiFolder(const PkiFolder&) = delete;
  PkiFolder& operator=(const PkiFolder&) = delete;

  std::string file(const std::string& name) const { return path_ / name; }

 private:
  std::filesystem::path path_;
};

/// The CAs of a robot and what they issued. `days`: see pki::Plan.
class Pki {
 public:
  explicit Pki(int days = 365) {
    const auto made = pki::make({.robot = kRobot, .out = out(), .ca = ca(), .days = days});
    FARRIER_ENSURE(made.ok(), made.error().message.c_str());
  }
  std::string out() const { return folder_.file("keys"); }
  std::string ca() const { return folder_.file("ca"); }

  /// A copy of what they issued, to spoil; it goes with this object.
  std::string copy() {
    const std::string path = folder_.file("copy" + std::to_string(++copies_));
    std::filesystem::copy(out(), path, std::filesystem::copy_options::recursive);
    return path;
  }

 private:
  PkiFolder folder_;
  int copies_ = 0;
};

}  // namespace farrier::test
