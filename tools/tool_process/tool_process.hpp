#pragma once

#include <string>
#include <vector>

#include "core/result.hpp"

namespace farrier {

/// A program of the system, and the Debian package it comes in.
struct Tool {
  std::string program;
  std::string package;
};

/// Runs it in `directory` to its end, without input; what it prints goes to the file `log`. Refuses with the reason when
/// it is not installed, does not start, or ends with another status than 0; then with what it printed.
Result<Done> run_tool(const Tool& tool, const std::vector<std::string>& arguments, const std::string& directory,
                      const std::string& log);

}  // namespace farrier
