// farrier man: the manual pages, from the options as they are declared.

#include <CLI/CLI.hpp>
#include <cstdio>
#include <filesystem>
#include <fstream>

#include "cli/base/command.hpp"
#include "cli/manual/all_verbs.hpp"
#include "cli/manual/man_page.hpp"
#include "report/figures/run_info.hpp"

namespace farrier::cli {
namespace {

int write_pages(const CLI::App& farrier, const std::string& folder) {
  std::error_code refused;
  std::filesystem::create_directories(folder, refused);
  for (const auto& [name, page] : man_pages(command_text(farrier), command_texts(farrier), report::run_info(0).version)) {
    const std::string path = folder + "/" + name;
    std::ofstream file(path);
    if (!(file << page << std::flush)) {
      std::fprintf(stderr, "farrier man: cannot write %s\n", path.c_str());
      return kFailed;
    }
  }
  return kPassed;
}

}  // namespace

std::function<int()> declare_man(CLI::App& app) {
  auto folder = std::make_shared<std::string>();
  app.add_option("--out", *folder, "folder for farrier.1 and a page for each command")->required()->type_name("<dir>");
  return [folder] { return write_pages(*whole_command_line(), *folder); };
}

}  // namespace farrier::cli
