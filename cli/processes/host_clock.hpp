#pragma once

#include <string>
#include <vector>

#include "core/result.hpp"

namespace farrier::cli {

/// The wall clock of a computer that is set while processes run on it (tools/wall_clock).
class HostClock {
 public:
  /// `executables`: directory of the library to preload. `path`: the file from which processes read the clock's offset;
  /// it is overwritten.
  static Result<HostClock> create(const std::string& executables, const std::string& path);

  /// Environment of a process that uses this clock: `NAME=value`.
  std::vector<std::string> environment() const;

  /// From now on it shows `offset_s` more than the real one.
  Result<Done> set(int offset_s) const;

 private:
  HostClock(std::string library, std::string path) : library_(std::move(library)), path_(std::move(path)) {}

  std::string library_;
  std::string path_;
};

}  // namespace farrier::cli
