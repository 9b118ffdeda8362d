// The first page shows what the commands print, and its picture names what there is.

#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <regex>
#include <sstream>

#include "bus/topics.hpp"
#include "core/processes.hpp"
#include "documents.hpp"
#include "tests/support/scratch_directory.hpp"

namespace farrier::docs {
namespace readme_test {

const std::regex kSpaces("[ \t]+");

/// The words of a line with one space between them, so that columns may be narrower than the command prints them.
std::string words(const std::string& line) {
  const std::string text = std::regex_replace(line, kSpaces, " ");
  return text.ends_with(' ') ? text.substr(0, text.size() - 1) : text;
}

/// True if the output has this line, or for a line that ends with "..." one that begins so. A line that the page
/// abbreviates in the middle is the beginning, too.
bool printed(const std::string& output, const std::string& line) {
  const bool cut = line.ends_with(" ...");
  const std::string expected = words(cut ? line.substr(0, line.size() - 4) : line);
  std::istringstream lines(output);
  for (std::string text; std::getline(lines, text);) {
    if (words(text).starts_with(expected)) {
      return true;
    }
  }
  return false;
}

TEST(ReadMe, ShowsWhatItsCommandsPrint) {
  const auto page = std::ranges::find(documents(), "README.md", &Document::path);
  ASSERT_NE(page, documents().end());
  const test::ScratchDirectory scratch;
  int commands = 0;
  for (std::size_t i = 0; i + 1 < page->blocks.size(); ++i) {
    const Block& block = page->blocks[i];
    const std::string kCommand = "./farrier ";
    if (block.language != "sh" || !block.lines.front().text.starts_with(kCommand)) {
      continue;
    }
    ++commands;
    const std::string arguments = block.lines.front().text.substr(kCommand.size());
    // Lock-step leaves the same traces in process as over DDS, which system/walk_test and trace_identity_test check, in a
    // tenth of the time.
    const Ran ran = run("cd '" + scratch.file(".") + "' && FARRIER_DDS=inproc '" FARRIER_COMMAND "' " + arguments);
    EXPECT_EQ(ran.status, 0) << arguments << "\n" << ran.output;
    for (const Line& line : page->blocks[i + 1].lines) {
      const bool report = line.text.starts_with("report: ");  // its folder is another one here
      EXPECT_TRUE(line.text == "..." || report || printed(ran.output, line.text))
          << at(*page, line) << ": farrier " << arguments << " does not print '" << line.text << "'";
    }
  }
  EXPECT_EQ(commands, 4);
}

TEST(LoopPicture, NamesTopicsAndProcessesThatExist) {
  std::ifstream file(FARRIER_SOURCE_DIR "/docs/pictures/loop.svg");
  const std::string picture(std::istreambuf_iterator<char>(file), {});
  static const std::regex kText(R"re(<text([^>]*)>(.*)</text>)re");
  static const std::regex kTag("<[^>]*>");
  static const std::regex kTopic(R"re([a-z]+/[a-z_]+)re");
  int topics = 0;
  int processes = 0;
  for (std::sregex_iterator text(picture.begin(), picture.end(), kText), end; text != end; ++text) {
    const std::string label = std::regex_replace((*text)[2].str(), kTag, "");
    for (std::sregex_iterator topic(label.begin(), label.end(), kTopic); topic != end; ++topic) {
      ++topics;
      EXPECT_TRUE(std::ranges::count(bus::topics(), topic->str(), &bus::TopicSpec::name)) << topic->str();
    }
    if ((*text)[1].str().find("bold") != std::string::npos) {
      ++processes;
      EXPECT_TRUE(std::ranges::count(kPrograms, label, &ProgramInfo::name)) << label;
    }
  }
  EXPECT_GE(topics, 10);
  EXPECT_EQ(processes, 5);
}

}  // namespace readme_test
}  // namespace farrier::docs
