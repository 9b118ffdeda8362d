#pragma once

#include <string>

namespace farrier::cli {

/// Makes a write to a closed pipe, and one beyond a limit of file size, fail instead of ending the program. A standard
/// stream that is closed is opened, so that no file takes its number; writing to it fails.
void prepare_standard_streams();

/// Exit status of a command that ends with `status`. If standard output did not take all that was printed, prints the
/// reason on standard error, and returns kFailed in place of kPassed. `verb`: empty for farrier itself.
int status_of_output(const std::string& verb, int status);

}  // namespace farrier::cli
