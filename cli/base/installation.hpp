#pragma once

#include <string>

namespace farrier::cli {

// An installation is below /usr where packages put it, or below the build directory where it was built. The command is
// in bin/, its other programs and the processes in libexec/farrier/. The robot files are in share/farrier/robots/, the
// monitor's page in share/farrier/page/.

/// Path of the command `farrier`, whichever of its programs this is.
std::string farrier_command();

/// Path of the program that runs a verb (Verb::program).
std::string program_path(const std::string& program);

/// Folder of the processes' executables.
std::string processes_directory();

/// Folder of the robot files that are shipped.
std::string robots_directory();

/// Path of one of them.
std::string shipped_robot(const std::string& name);

/// Folder of the page of `farrier monitor --web`.
std::string page_directory();

}  // namespace farrier::cli
