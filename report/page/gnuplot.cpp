#include "report/page/gnuplot.hpp"

#include <filesystem>

#include "core/replace_file.hpp"
#include "tools/tool_process/tool_process.hpp"

namespace farrier::report {
namespace {

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
  return replace_file(path, lines);
}

Result<Done> draw(const std::string& out_dir, const std::string& script) {
  if (auto written = replace_file(out_dir + "/" + kScript, script); !written) {
    return written;
  }
  return run_gnuplot(out_dir, kScript);
}

Result<Done> run_gnuplot(const std::string& directory, const std::string& script) {
  auto drawn = run_tool({"gnuplot", "gnuplot-nox"}, {script}, directory,
                        (std::filesystem::absolute(directory) / (script + ".log")).string());
  if (!drawn) {
    return Error{"cannot draw the report's pictures: " + drawn.error().message};
  }
  return drawn;
}

}  // namespace farrier::report
