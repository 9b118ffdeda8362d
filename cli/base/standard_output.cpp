#include "cli/base/standard_output.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <cstdio>
#include <cstring>

#include "cli/base/command.hpp"

namespace farrier::cli {
namespace {

void go_on(int /*signal*/) {}

}  // namespace

void prepare_standard_streams() {
  for (const int stream : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO}) {
    if (::fcntl(stream, F_GETFD) < 0 && errno == EBADF) {
      // The lowest free number is this one. In the wrong direction every use of it fails.
      static_cast<void>(::open("/dev/null", stream == STDIN_FILENO ? O_WRONLY : O_RDONLY));
    }
  }
  // A handler, because programs that are started would inherit SIG_IGN. A signal that is ignored already stays so.
  for (const int signal : {SIGPIPE, SIGXFSZ}) {
    struct sigaction action {};
    if (::sigaction(signal, nullptr, &action) == 0 && action.sa_handler == SIG_DFL) {
      action.sa_handler = go_on;
      action.sa_flags = SA_RESTART;
      ::sigaction(signal, &action, nullptr);
    }
  }
}

int status_of_output(const std::string& verb, int status) {
  errno = 0;
  const bool failed_before = std::ferror(stdout) != 0;
  const bool flushed = std::fflush(stdout) == 0;
  if (flushed && !failed_before) {
    return status;
  }
  if (flushed || errno == 0) {
    // The reason of the failure before is gone: a further byte has the same.
    static_cast<void>(::write(STDOUT_FILENO, "\n", 1));
  }
  std::fprintf(stderr, "farrier%s%s: cannot write standard output: %s\n", verb.empty() ? "" : " ", verb.c_str(),
               errno != 0 ? std::strerror(errno) : "not all of it was taken");
  return status == kPassed ? kFailed : status;
}

}  // namespace farrier::cli
