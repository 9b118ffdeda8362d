#include "tools/report/gnuplot.hpp"

#include <fcntl.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <sstream>

extern char** environ;

namespace farrier::report {
namespace {

std::string text_of_file(const std::string& path) {
  std::ostringstream text;
  text << std::ifstream(path).rdbuf();
  return text.str();
}

constexpr const char* kScript = "data/pictures.gp";

}  // namespace

Result<Done> make_picture_folders(const std::string& out_dir) {
  for (const char* folder : {"/data", "/pictures"}) {
    std::error_code failure;
    std::filesystem::create_directories(out_dir + folder, failure);
    if (failure) {
      return Error{"cannot make the folder " + out_dir + folder + ": " + failure.message()};
    }
  }
  return Done{};
}

Result<Done> write_plot_data(const std::string& path, const std::string& lines) {
  std::ofstream file(path);
  file << lines << std::flush;
  if (!file) {
    return Error{"cannot write the data of the report's pictures to " + path + ": " + std::strerror(errno)};
  }
  return Done{};
}

Result<Done> draw(const std::string& out_dir, const std::string& script) {
  std::ofstream file(out_dir + "/" + kScript);
  file << script << std::flush;
  if (!file) {
    return Error{"cannot write " + out_dir + "/" + kScript + ": " + std::strerror(errno)};
  }
  return run_gnuplot(out_dir, kScript);
}

Result<Done> run_gnuplot(const std::string& directory, const std::string& script) {
  const std::string log = (std::filesystem::absolute(directory) / (script + ".log")).string();
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_addchdir_np(&actions, directory.c_str());
  posix_spawn_file_actions_addopen(&actions, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
  posix_spawn_file_actions_addopen(&actions, STDOUT_FILENO, log.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0644);
  posix_spawn_file_actions_adddup2(&actions, STDOUT_FILENO, STDERR_FILENO);
  std::string name = "gnuplot";
  std::string argument = script;
  char* const arguments[] = {name.data(), argument.data(), nullptr};
  pid_t pid = 0;
  const int refused = ::posix_spawnp(&pid, "gnuplot", &actions, nullptr, arguments, environ);
  posix_spawn_file_actions_destroy(&actions);
  if (refused == ENOENT) {
    return Error{"cannot draw the report's pictures: gnuplot is not on the PATH; install it (Debian: gnuplot-nox)"};
  }
  if (refused != 0) {
    return Error{std::string("cannot draw the report's pictures: gnuplot does not start: ") + std::strerror(refused)};
  }
  int status = 0;
  while (::waitpid(pid, &status, 0) < 0 && errno == EINTR) {
  }
  if (!WIFEXITED(status) || WEXITSTATUS(status) != 0) {
    const std::string ending = WIFEXITED(status) ? "status " + std::to_string(WEXITSTATUS(status))
                                                 : "signal " + std::to_string(WTERMSIG(status));
    return Error{"cannot draw the report's pictures: gnuplot ended with " + ending + ": " + text_of_file(log)};
  }
  return Done{};
}

}  // namespace farrier::report
