#include "cli/base/installation.hpp"

#include <filesystem>

namespace farrier::cli {
namespace {

namespace fs = std::filesystem;

fs::path prefix() { return fs::path(this_command()).parent_path().parent_path(); }

}  // namespace

std::string this_command() { return fs::canonical("/proc/self/exe"); }

std::string processes_directory() { return prefix() / "libexec/farrier"; }

// In a build directory that folder is a link to the sources': what is said of a file there names the file itself.
std::string robots_directory() { return fs::weakly_canonical(prefix() / "share/farrier/robots"); }

std::string shipped_robot(const std::string& name) { return fs::path(robots_directory()) / name; }

std::string page_directory() { return prefix() / "share/farrier/page"; }

}  // namespace farrier::cli
