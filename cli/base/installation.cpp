#include "cli/base/installation.hpp"

#include <filesystem>

namespace farrier::cli {
namespace {

namespace fs = std::filesystem;

/// This program stands in <prefix>/bin or in <prefix>/libexec/farrier.
fs::path prefix() {
  const fs::path folder = fs::canonical("/proc/self/exe").parent_path();
  return folder.filename() == "bin" ? folder.parent_path() : folder.parent_path().parent_path();
}

}  // namespace

std::string farrier_command() { return prefix() / "bin/farrier"; }

std::string program_path(const std::string& program) {
  return program == "farrier" ? farrier_command() : processes_directory() + "/farrier-" + program;
}

std::string processes_directory() { return prefix() / "libexec/farrier"; }

// In a build directory that folder is a link to the sources': what is said of a file there names the file itself.
std::string robots_directory() { return fs::weakly_canonical(prefix() / "share/farrier/robots"); }

std::string shipped_robot(const std::string& name) { return fs::path(robots_directory()) / name; }

std::string page_directory() { return prefix() / "share/farrier/page"; }

}  // namespace farrier::cli
