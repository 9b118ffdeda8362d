#pragma once

#include <string>
#include <vector>

#include "core/result.hpp"

namespace farrier::cli {

/// A directory for a run's results, made where it is missing. No other run writes there while this object lives.
class OutputDirectory {
 public:
  static Result<OutputDirectory> claim(const std::string& path);
  ~OutputDirectory();
  OutputDirectory(OutputDirectory&& other) noexcept;
  OutputDirectory& operator=(OutputDirectory&&) = delete;

 private:
  explicit OutputDirectory(int file) : file_(file) {}

  int file_;
};

/// Refuses a path that cannot be written, before the work whose result is to go there, and removes the file an
/// earlier run left, which must not pass for this run's. Devices and pipes are left alone.
Result<Done> make_way(const std::string& path);

/// The same for all of a command's outputs, those without a path left out. Refuses first any that is one of `inputs`.
Result<Done> make_way(const std::vector<std::string>& outputs, const std::vector<std::string>& inputs);

}  // namespace farrier::cli
