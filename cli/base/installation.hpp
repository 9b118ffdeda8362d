#pragma once

#include <string>

namespace farrier::cli {

// This command stands in bin/ of its installation, the processes in libexec/farrier/, the robot files in
// share/farrier/robots/ and the monitor's page in share/farrier/page/ beside it: below /usr where the packages put them, below the build directory where they were
// built.

/// Path of this command.
std::string this_command();

/// Folder of the processes' executables.
std::string processes_directory();

/// Folder of the robot files that are shipped.
std::string robots_directory();

/// Path of one of them.
std::string shipped_robot(const std::string& name);

/// Folder of the page of `farrier monitor --web`.
std::string page_directory();

}  // namespace farrier::cli
