#include <algorithm>

#include "deploy_files.hpp"
#include "tools/deploy/rendered_folder.hpp"

namespace farrier::deploy {
namespace {

namespace fs = std::filesystem;

const std::vector<RenderedFile> kFiles{{"a.service", "[Unit]\n"}, {"robot.yaml", "name: a\n"}};

std::vector<std::string> names_in(const std::string& folder) {
  std::vector<std::string> names;
  for (const auto& entry : fs::directory_iterator(folder)) {
    names.push_back(entry.path().filename());
  }
  std::sort(names.begin(), names.end());
  return names;
}

TEST(RenderedFolder, AppearsWithAllItsFilesAndNothingBesideIt) {
  const Scratch scratch;
  ASSERT_TRUE(write_folder(scratch / "etc/front", kFiles, "").ok());
  EXPECT_EQ(names_in(scratch / "etc/front"), (std::vector<std::string>{"a.service", "rendered.txt", "robot.yaml"}));
  EXPECT_EQ(read(scratch / "etc/front/robot.yaml"), "name: a\n");
  EXPECT_EQ(names_in(scratch / "etc"), std::vector<std::string>{"front"});
  EXPECT_TRUE(differing_files(scratch / "etc/front", kFiles).empty());
}

TEST(RenderedFolder, IsReplacedAsAWholeWhenRenderedAgain) {
  const Scratch scratch;
  ASSERT_TRUE(write_folder(scratch / "front", kFiles, "").ok());
  ASSERT_TRUE(write_folder((scratch / "front") + "/", {{"b.service", "[Unit]\n"}}, "").ok());
  EXPECT_EQ(names_in(scratch / "front"), (std::vector<std::string>{"b.service", "rendered.txt"}));
  EXPECT_EQ(names_in(scratch / ""), std::vector<std::string>{"front"});
}

TEST(RenderedFolder, TakesThePlaceOfAnEmptyOne) {
  const Scratch scratch;
  fs::create_directory(scratch / "front");
  EXPECT_TRUE(write_folder(scratch / "front", kFiles, "").ok());
}

TEST(RenderedFolder, RefusesToReplaceWhatItDidNotWrite) {
  const Scratch scratch;
  fs::create_directory(scratch / "mine");
  std::ofstream(scratch / "mine/thesis.tex") << "years";
  const auto written = write_folder(scratch / "mine", kFiles, "");
  ASSERT_FALSE(written.ok());
  EXPECT_EQ(written.error().message, (scratch / "mine") + " has thesis.tex, which farrier deploy render did not write: "
                                     "move it away or give another folder");
  EXPECT_EQ(names_in(scratch / "mine"), std::vector<std::string>{"thesis.tex"});
}

TEST(RenderedFolder, RefusesToReplaceItsOwnWhenSomethingWasAdded) {
  const Scratch scratch;
  ASSERT_TRUE(write_folder(scratch / "front", kFiles, "").ok());
  std::ofstream(scratch / "front/notes") << "mine";
  EXPECT_FALSE(write_folder(scratch / "front", kFiles, "").ok());
  EXPECT_EQ(read(scratch / "front/notes"), "mine");
}

TEST(RenderedFolder, RefusesAFileInItsPlace) {
  const Scratch scratch;
  std::ofstream(scratch / "front") << "a file";
  EXPECT_FALSE(write_folder(scratch / "front", kFiles, "").ok());
  EXPECT_EQ(read(scratch / "front"), "a file");
}

TEST(RenderedFolder, SaysWhichFilesWereChangedByHand) {
  const Scratch scratch;
  ASSERT_TRUE(write_folder(scratch / "front", kFiles, "").ok());
  std::ofstream(scratch / "front/a.service") << "[Unit]\nDescription=better\n";
  EXPECT_EQ(differing_files(scratch / "front", kFiles), std::vector<std::string>{"a.service"});
}

}  // namespace
}  // namespace farrier::deploy
