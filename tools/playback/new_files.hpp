#pragma once

#include <filesystem>
#include <string>
#include <system_error>

namespace farrier::playback {

/// The files made in an empty folder, which go again unless they are kept.
class NewFiles {
 public:
  explicit NewFiles(std::string folder) : folder_(std::move(folder)) {}
  NewFiles(const NewFiles&) = delete;
  NewFiles& operator=(const NewFiles&) = delete;
  ~NewFiles() {
    std::error_code gone;
    for (const std::filesystem::directory_entry& file : std::filesystem::directory_iterator(folder_, gone)) {
      if (!kept_) {
        std::filesystem::remove(file.path(), gone);
      }
    }
  }
  void keep() { kept_ = true; }

 private:
  std::string folder_;
  bool kept_ = false;
};

}  // namespace farrier::playback
