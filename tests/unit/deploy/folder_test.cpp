#include <algorithm>

#include "files.hpp"
#include "tools/deploy/rendered_folder.hpp"

namespace farrier::deploy {
namespace folder_test {

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
  const ScratchDirectory scratch;
  ASSERT_TRUE(write_folder(scratch.file("etc/front"), kFiles, "").ok());
  EXPECT_EQ(names_in(scratch.file("etc/front")), (std::vector<std::string>{"a.service", "rendered.txt", "robot.yaml"}));
  EXPECT_EQ(read(scratch.file("etc/front/robot.yaml")), "name: a\n");
  EXPECT_EQ(names_in(scratch.file("etc")), std::vector<std::string>{"front"});
  EXPECT_TRUE(differing_files(scratch.file("etc/front"), kFiles).empty());
}

TEST(RenderedFolder, IsReplacedAsAWholeWhenRenderedAgain) {
  const ScratchDirectory scratch;
  ASSERT_TRUE(write_folder(scratch.file("front"), kFiles, "").ok());
  ASSERT_TRUE(write_folder(scratch.file("front") + "/", {{"b.service", "[Unit]\n"}}, "").ok());
  EXPECT_EQ(names_in(scratch.file("front")), (std::vector<std::string>{"b.service", "rendered.txt"}));
  EXPECT_EQ(names_in(scratch.file("")), std::vector<std::string>{"front"});
}

TEST(RenderedFolder, TakesThePlaceOfAnEmptyOne) {
  const ScratchDirectory scratch;
  fs::create_directory(scratch.file("front"));
  EXPECT_TRUE(write_folder(scratch.file("front"), kFiles, "").ok());
}

TEST(RenderedFolder, RefusesToReplaceWhatItDidNotWrite) {
  const ScratchDirectory scratch;
  fs::create_directory(scratch.file("mine"));
  std::ofstream(scratch.file("mine/thesis.tex")) << "years";
  const auto written = write_folder(scratch.file("mine"), kFiles, "");
  ASSERT_FALSE(written.ok());
  EXPECT_EQ(written.error().message, scratch.file("mine") + " has thesis.tex, which farrier deploy render did not write: "
                                     "move it away or give another folder");
  EXPECT_EQ(names_in(scratch.file("mine")), std::vector<std::string>{"thesis.tex"});
}

TEST(RenderedFolder, RefusesToReplaceItsOwnWhenSomethingWasAdded) {
  const ScratchDirectory scratch;
  ASSERT_TRUE(write_folder(scratch.file("front"), kFiles, "").ok());
  std::ofstream(scratch.file("front/notes")) << "mine";
  EXPECT_FALSE(write_folder(scratch.file("front"), kFiles, "").ok());
  EXPECT_EQ(read(scratch.file("front/notes")), "mine");
}

TEST(RenderedFolder, RefusesAFileInItsPlace) {
  const ScratchDirectory scratch;
  std::ofstream(scratch.file("front")) << "a file";
  EXPECT_FALSE(write_folder(scratch.file("front"), kFiles, "").ok());
  EXPECT_EQ(read(scratch.file("front")), "a file");
}

TEST(RenderedFolder, SaysWhichFilesWereChangedByHand) {
  const ScratchDirectory scratch;
  ASSERT_TRUE(write_folder(scratch.file("front"), kFiles, "").ok());
  std::ofstream(scratch.file("front/a.service")) << "[Unit]\nDescription=better\n";
  EXPECT_EQ(differing_files(scratch.file("front"), kFiles), std::vector<std::string>{"a.service"});
}

}  // namespace folder_test
}  // namespace farrier::deploy
