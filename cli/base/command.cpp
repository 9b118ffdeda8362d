#include "cli/base/command.hpp"

#include <cstdio>

#include "participant/loop.hpp"

namespace farrier::cli {

int fail(const char* command, const std::string& message, int status) {
  std::fprintf(stderr, "farrier %s: %s\n", command, message.c_str());
  return participant::stop_requested() ? participant::stop_status() : status;
}

int refuse(const char* command, const std::string& message) { return fail(command, message, kBadInput); }

}  // namespace farrier::cli
