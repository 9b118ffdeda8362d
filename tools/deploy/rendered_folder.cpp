#include "tools/deploy/rendered_folder.hpp"

#include <fcntl.h>
#include <stdio.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <optional>
#include <set>
#include <sstream>

namespace farrier::deploy {
namespace {

namespace fs = std::filesystem;

constexpr const char* kFilesFollow = "files:";

Error failed(const std::string& what) { return Error{what + ": " + std::strerror(errno)}; }

/// Returns the files in the folder's own list, itself among them; empty for a folder without one.
std::set<std::string> listed_files(const fs::path& folder) {
  std::set<std::string> names;
  std::istringstream lines(text_of(folder / kManifest).value_or(""));
  bool in_list = false;
  for (std::string line; std::getline(lines, line);) {
    if (in_list) {
      names.insert(line);
    }
    in_list = in_list || line == kFilesFollow;
  }
  if (in_list) {
    names.insert(kManifest);
  }
  return names;
}

/// Refuses a folder that holds anything that was not rendered.
Result<Done> may_replace(const fs::path& folder) {
  if (!fs::is_directory(folder)) {
    return Error{folder.string() + " is no folder: give another"};
  }
  const std::set<std::string> ours = listed_files(folder);
  std::error_code failure;
  for (const auto& entry : fs::directory_iterator(folder, failure)) {
    if (!ours.contains(entry.path().filename().string())) {
      return Error{folder.string() + " has " + entry.path().filename().string() +
                   ", which farrier deploy render did not write: move it away or give another folder"};
    }
  }
  return failure ? Result<Done>(Error{folder.string() + ": " + failure.message()}) : Done{};
}

Result<Done> write_file(const fs::path& path, const std::string& text) {
  const int file = ::open(path.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0644);
  if (file < 0) {
    return failed("cannot write " + path.string());
  }
  std::size_t written = 0;
  while (written < text.size()) {
    const ssize_t count = ::write(file, text.data() + written, text.size() - written);
    if (count < 0 && errno != EINTR) {
      const Error error = failed("cannot write " + path.string());
      ::close(file);
      return error;
    }
    written += count > 0 ? static_cast<std::size_t>(count) : 0;
  }
  const bool safe = ::fsync(file) == 0;
  return ::close(file) == 0 && safe ? Result<Done>(Done{}) : failed("cannot write " + path.string());
}

/// A folder that is removed with this object.
struct Temporary {
  fs::path path;
  ~Temporary() {
    std::error_code ignored;
    fs::remove_all(path, ignored);
  }
};

}  // namespace

std::optional<std::string> text_of(const fs::path& path) {
  std::ifstream file(path, std::ios::binary);
  if (!file) {
    return std::nullopt;
  }
  std::ostringstream text;
  text << file.rdbuf();
  return text.str();
}

Result<Done> write_folder(const std::string& path, const std::vector<RenderedFile>& files, const std::string& heading) {
  const fs::path folder = fs::absolute(fs::path(path) / "").parent_path().lexically_normal();
  const bool replaces = fs::exists(fs::symlink_status(folder));
  if (replaces) {
    if (auto permitted = may_replace(folder); !permitted) {
      return permitted;
    }
  }
  std::error_code failure;
  fs::create_directories(folder.parent_path(), failure);
  std::string name = folder.string() + ".new-XXXXXX";
  if (failure || ::mkdtemp(name.data()) == nullptr) {
    return failed("cannot write beside " + folder.string());
  }
  const Temporary beside{name};
  ::chmod(name.c_str(), 0755);
  std::string manifest = heading + kFilesFollow + "\n";
  for (const RenderedFile& file : files) {
    manifest += file.name + "\n";
    if (auto written = write_file(beside.path / file.name, file.text); !written) {
      return written;
    }
  }
  if (auto written = write_file(beside.path / kManifest, manifest); !written) {
    return written;
  }
  // An exchange leaves no moment without a folder, and the old one to be removed under the temporary name.
  const unsigned how = replaces ? RENAME_EXCHANGE : RENAME_NOREPLACE;
  if (::renameat2(AT_FDCWD, name.c_str(), AT_FDCWD, folder.c_str(), how) != 0) {
    return failed("cannot move the rendered files to " + folder.string());
  }
  return Done{};
}

std::vector<std::string> differing_files(const std::string& path, const std::vector<RenderedFile>& files) {
  std::vector<std::string> names;
  for (const RenderedFile& file : files) {
    if (text_of(fs::path(path) / file.name) != file.text) {
      names.push_back(file.name);
    }
  }
  return names;
}

}  // namespace farrier::deploy
