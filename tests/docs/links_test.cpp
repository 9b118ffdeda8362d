// A link in a document leads somewhere: to a file or folder of the repository, and to a heading that is there.

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>

#include "documents.hpp"

namespace farrier::docs {
namespace links_test {

namespace fs = std::filesystem;

const Document* find(const std::string& path) {
  const auto place = std::ranges::find(documents(), path, &Document::path);
  return place == documents().end() ? nullptr : &*place;
}

/// Returns the reason why a link is wrong, empty if it is right.
std::string fault_of(const Document& from, const std::string& link) {
  if (link.find("://") != std::string::npos || link.starts_with("mailto:")) {
    return "";  // the network is not asked
  }
  const std::size_t hash = link.find('#');
  const std::string path = link.substr(0, hash);
  const fs::path target =
      path.empty() ? fs::path(from.path) : (fs::path(from.path).parent_path() / path).lexically_normal();
  if (path.starts_with("/") || target.generic_string().starts_with("..") ||
      !fs::exists(fs::path(FARRIER_SOURCE_DIR) / target)) {
    return "there is no " + target.generic_string();
  }
  if (hash == std::string::npos) {
    return "";
  }
  const Document* to = find(target.generic_string());
  const std::string name = link.substr(hash + 1);
  return to != nullptr && anchors(*to).count(name) > 0 ? "" : "no heading there is called " + name;
}

TEST(Links, OfEveryDocumentLeadSomewhere) {
  int checked = 0;
  for (const Document& document : documents()) {
    for (const Line& line : document.prose) {
      for (const std::string& link : links(line.text)) {
        ++checked;
        EXPECT_EQ(fault_of(document, link), "") << at(document, line) << ": " << link;
      }
    }
  }
  EXPECT_GT(checked, 500) << "the test must find the links";
}

TEST(Links, ToWhatIsNotThereAreFound) {
  const Document* tour = find("docs/tour.md");
  ASSERT_NE(tour, nullptr);
  EXPECT_EQ(fault_of(*tour, "architecture.md#two-clocks"), "");
  EXPECT_EQ(fault_of(*tour, "../lib/core/time.hpp"), "");
  EXPECT_NE(fault_of(*tour, "architecture.md#three-clocks"), "");
  EXPECT_NE(fault_of(*tour, "../lib/core/space.hpp"), "");
  EXPECT_NE(fault_of(*tour, "../../elsewhere.md"), "");
}

TEST(Links, AreReadAsPeopleWriteThem) {
  EXPECT_EQ(links("see [`a`](b.md#c) and [d](e), not `[f](g)`"), (std::vector<std::string>{"b.md#c", "e"}));
  const Document page{"a.md", {{1, "# The `word` (again)"}, {2, "## Two"}, {3, "## Two"}, {4, "## Größe"}}, {}};
  EXPECT_EQ(anchors(page), (std::set<std::string>{"the-word-again", "two", "two-1"}));
}

}  // namespace links_test
}  // namespace farrier::docs
