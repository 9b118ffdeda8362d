// farrier convert: a recording as a folder of CSV files, and back.

#include <CLI/CLI.hpp>
#include <cstdio>
#include <filesystem>
#include <memory>

#include "participant/loop.hpp"
#include "cli/base/command.hpp"
#include "cli/base/long_work.hpp"
#include "recording/recording_file.hpp"
#include "tools/playback/csv_files.hpp"

namespace farrier::cli {
namespace {

int run_convert(const std::string& from, const std::string& to, bool force) {
  const bool of_csv = std::filesystem::is_directory(from);
  if (of_csv && !force) {
    if (auto free = recording::refuse_existing(to); !free) {
      return refuse("convert", free.error().message);
    }
  }
  const KeepOn keep_on = long_work("convert");
  const auto converted = of_csv ? playback::from_csv(from, to, keep_on) : playback::to_csv(from, to, keep_on);
  if (participant::stop_requested()) {
    return participant::stop_status();
  }
  if (!converted) {
    return refuse("convert", converted.error().message);
  }
  if (!converted.value().refusal.empty()) {
    return fail("convert", converted.value().refusal);
  }
  std::printf("%s: %llu samples\n", to.c_str(), static_cast<unsigned long long>(converted.value().samples));
  if (!converted.value().ending.empty()) {
    return fail("convert", from + ": " + converted.value().ending + "; the rest is converted");
  }
  return kPassed;
}

}  // namespace

std::function<int()> declare_convert(CLI::App& app) {
  struct Paths {
    std::string from, to;
    bool force = false;
  };
  auto paths = std::make_shared<Paths>();
  app.add_option("from", paths->from, "recording, or a folder that this command has made of one")
      ->required()
      ->type_name("<file|folder>");
  app.add_option("to", paths->to, "empty folder for CSV files, a topic each; or the recording that is made of them")
      ->required()
      ->type_name("<folder|file>");
  app.add_flag("--force", paths->force, "replace the recording if it is there");
  return [paths] { return run_convert(paths->from, paths->to, paths->force); };
}

}  // namespace farrier::cli
