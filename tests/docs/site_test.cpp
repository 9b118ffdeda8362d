// The site of the documents: it builds without a warning, needs nothing from anywhere else, and its links lead somewhere.

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <map>
#include <regex>
#include <set>
#include <sstream>

#include "documents.hpp"

namespace farrier::docs {
namespace site_test {

namespace fs = std::filesystem;

std::string read(const fs::path& path) {
  std::ifstream file(path);
  std::ostringstream text;
  text << file.rdbuf();
  return text.str();
}

class Site : public ::testing::Test {
 protected:
  static void SetUpTestSuite() {
    built_ = run("cd '" FARRIER_SOURCE_DIR "' && mkdocs build --strict --quiet --clean --site-dir '" FARRIER_SITE "'");
  }

  template <class Check>
  static void each_page(Check check) {
    for (const auto& entry : fs::recursive_directory_iterator(FARRIER_SITE)) {
      if (entry.path().extension() == ".html") {
        check(entry.path(), read(entry.path()));
      }
    }
  }

  static Ran built_;
};
Ran Site::built_;

TEST_F(Site, IsBuiltWithoutAWarning) { EXPECT_TRUE(built_.status == 0 && built_.output.empty()) << built_.output; }

TEST_F(Site, FetchesNothingFromElsewhere) {
  static const std::regex fetched(R"re(<(script|link|img|iframe|source)\b[^>]*\b(src|href)="?(https?:)?//[^>]*>)re");
  static const std::regex in_style(R"re((url\(|@import)\s*['"]?(https?:)?//[^)'";]*)re");
  int scripts = 0;
  for (const auto& entry : fs::recursive_directory_iterator(FARRIER_SITE)) {
    const bool page = entry.path().extension() == ".html";
    if (!page && entry.path().extension() != ".css") {
      continue;
    }
    const std::string text = read(entry.path());
    scripts += text.find("<script src=") != std::string::npos ? 1 : 0;
    std::smatch match;
    EXPECT_FALSE(std::regex_search(text, match, page ? fetched : in_style)) << entry.path() << ": " << match.str();
  }
  EXPECT_GT(scripts, 20) << "the test must find the theme's own scripts";
}

TEST_F(Site, HasWhatEveryLinkLeadsTo) {
  static const std::regex link(R"re(<(?:a|img|link|script)\b[^>]*\b(?:href|src)="([^"]+)")re");
  static const std::regex name(R"re(\bid="([^"]+)")re");
  std::map<std::string, std::set<std::string>> names;  // of each page
  each_page([&](const fs::path& path, const std::string& text) {
    std::set<std::string>& found = names[path.lexically_normal()];
    for (std::sregex_iterator match(text.begin(), text.end(), name), end; match != end; ++match) {
      found.insert((*match)[1]);
    }
  });
  int checked = 0;
  each_page([&](const fs::path& path, const std::string& text) {
    for (std::sregex_iterator match(text.begin(), text.end(), link), end; match != end; ++match) {
      const std::string target = (*match)[1];
      if (path.filename() == "404.html" || target.find("://") != std::string::npos || target == "#") {
        continue;
      }
      ++checked;
      const std::size_t hash = target.find('#');
      fs::path file = (path.parent_path() / target.substr(0, target.find_first_of("?#"))).lexically_normal();
      file = hash == 0 ? path.lexically_normal() : fs::is_directory(file) ? (file / "index.html").lexically_normal() : file;
      EXPECT_TRUE(fs::exists(file)) << path << ": " << target;
      if (hash != std::string::npos && file.extension() == ".html") {
        EXPECT_EQ(names[file].count(target.substr(hash + 1)), 1u) << path << ": " << target;
      }
    }
  });
  EXPECT_GT(checked, 2000) << "the test must find the links";
}

}  // namespace site_test
}  // namespace farrier::docs
