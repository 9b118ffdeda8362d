// That the search finds what it looks for.

#include <gtest/gtest.h>

#include "tests/architecture/target_graph.hpp"

namespace farrier::architecture {
namespace {

const Source kCore{"lib/core/CMakeLists.txt", {"farrier_library(core time.cpp)"}};
const Source kPlant{"lib/plant/CMakeLists.txt",
                    {"farrier_library(plant valve.cpp", "  cylinder.cpp)  # two lines",
                     "target_link_libraries(farrier_plant PUBLIC farrier_core PRIVATE Eigen3::Eigen)"}};
const Source kNode{"node/CMakeLists.txt",
                   {"farrier_library(node_core node.cpp)", "target_link_libraries(farrier_node_core PRIVATE farrier_plant)",
                    "add_executable(node main.cpp)", "target_link_libraries(node farrier_node_core)"}};

TargetGraph graph() { return TargetGraph({&kCore, &kPlant, &kNode}); }

TEST(TargetGraph, FindsTheTargetOfASource) {
  EXPECT_EQ(graph().owner("lib/plant/cylinder.cpp")->name, "farrier_plant");
  EXPECT_EQ(graph().owner("node/main.cpp")->name, "node");
}

TEST(TargetGraph, FindsTheTargetOfAHeaderByItsSourceOrItsFolder) {
  EXPECT_EQ(graph().owner("node/node.hpp")->name, "farrier_node_core");
  EXPECT_EQ(graph().owner("node/alone.hpp")->name, "farrier_node_core");
  EXPECT_EQ(graph().owner("lib/plant/detail/deep.hpp")->name, "farrier_plant");
  EXPECT_EQ(graph().owner("elsewhere/alone.hpp"), nullptr);
}

TEST(TargetGraph, SeesWhatIsLinkedAndWhatThatPassesOn) {
  EXPECT_EQ(graph().visible("farrier_plant"),
            (std::set<std::string>{"farrier_plant", "farrier_core", "Eigen3::Eigen"}));
  EXPECT_EQ(graph().visible("farrier_node_core"),
            (std::set<std::string>{"farrier_node_core", "farrier_plant", "farrier_core"}))
      << "Eigen is the plant's own";
  EXPECT_EQ(graph().visible("node"), (std::set<std::string>{"node", "farrier_node_core"}));
}

TEST(TargetGraph, ReachesAlsoWhatIsPrivate) {
  EXPECT_EQ(graph().reachable("node"), (std::set<std::string>{"node", "farrier_node_core", "farrier_plant",
                                                              "farrier_core", "Eigen3::Eigen"}));
}

TEST(Sources, ListTheirIncludes) {
  const Source source{"a.cpp", {"#include \"core/time.hpp\"", "  # include <vector>", "// #include \"no.hpp\""}};
  const auto includes = includes_of(source);
  ASSERT_EQ(includes.size(), 2u);
  EXPECT_EQ(includes[0].target, "core/time.hpp");
  EXPECT_TRUE(includes[0].quoted);
  EXPECT_EQ(includes[1].target, "vector");
  EXPECT_FALSE(includes[1].quoted);
  EXPECT_EQ(includes[1].line, 2);
}

TEST(Sources, AreSearchedWithoutCommentsAndTexts) {
  const Source source{"a.cpp", {"f(\"rand() // no\"); // rand()", "rand();"}};
  EXPECT_EQ(code_of(source), (std::vector<std::string>{"f(\"\"); ", "rand();"}));
}

TEST(Exceptions, TellWhichOfThemAreNotNeeded) {
  constexpr Exception kList[] = {{"lib/a", "needed"}, {"lib/b.cpp", "not needed"}};
  Exceptions exceptions(kList);
  EXPECT_TRUE(exceptions.cover("lib/a/deep/file.cpp"));
  EXPECT_FALSE(exceptions.cover("lib/ab.cpp"));
  EXPECT_EQ(exceptions.unused(), "lib/b.cpp\n");
}

}  // namespace
}  // namespace farrier::architecture
