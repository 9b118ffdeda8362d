#pragma once

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>

#include "tests/support/scratch_directory.hpp"
#include "tools/deploy/rendering.hpp"

namespace farrier::deploy {

inline std::string read(const std::filesystem::path& path) {
  std::ifstream file(path);
  std::ostringstream text;
  text << file.rdbuf();
  return text.str();
}

inline const std::string kHyqPath = FARRIER_ROBOTS "hyq.yaml";

inline const robot::Robot& hyq() {
  static const robot::Robot robot = robot::load_robot(kHyqPath).value();
  return robot;
}

inline std::vector<RenderedFile> rendered(const std::string& host, const Places& places = standard_places(hyq())) {
  auto files = render_host(hyq(), read(kHyqPath), host, places);
  EXPECT_TRUE(files.ok()) << (files ? "" : files.error().message);
  return files ? std::move(files).value() : std::vector<RenderedFile>{};
}

using test::ScratchDirectory;

}  // namespace farrier::deploy
