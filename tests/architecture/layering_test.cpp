// Dependencies point one way, and every edge is one target_link_libraries line.

#include <gtest/gtest.h>

#include <regex>

#include "tests/architecture/target_graph.hpp"

namespace farrier::architecture {
namespace {

bool in_product(const Source& source) { return source.is_cpp() && !source.in("tests"); }

/// Where a quoted include leads: from the root ("joint_node/ports.hpp"), from lib/ ("core/time.hpp"), in tests also to
/// a file beside it. Null when no such file is ours.
const Source* resolve(const Source& source, const Include& include) {
  if (const Source* from_root = find_source(include.target)) {
    return from_root;
  }
  if (const Source* from_lib = find_source("lib/" + include.target)) {
    return from_lib;
  }
  const std::string folder = source.path.substr(0, source.path.rfind('/') + 1);
  return source.in("tests") ? find_source(folder + include.target) : nullptr;
}

TEST(Layering, EverySourceBelongsToATarget) {
  for (const Source& source : source_tree()) {
    if (in_product(source) && source.path.ends_with(".cpp")) {
      const Target* owner = TargetGraph::of_product().owner(source.path);
      EXPECT_TRUE(owner != nullptr && owner->sources.count(source.path) > 0) << source.path << " is built by nobody";
    }
  }
}

TEST(Layering, EverySourceATargetListsIsThere) {
  for (const auto& [name, target] : TargetGraph::of_product().targets()) {
    for (const std::string& path : target.sources) {
      if (path.ends_with(".cpp") && path.find('$') == std::string::npos) {
        EXPECT_NE(find_source(path), nullptr) << name << " lists " << path;
      }
    }
  }
}

TEST(Layering, EveryIncludeLeadsToALinkedLibrary) {
  const TargetGraph& graph = TargetGraph::of_product();
  Exceptions exceptions(kIncludes);
  int checked = 0;
  for (const Source& source : source_tree()) {
    if (!in_product(source)) {
      continue;
    }
    const Target* from = graph.owner(source.path);
    ASSERT_NE(from, nullptr) << source.path;
    const std::set<std::string> visible = graph.visible(from->name);
    for (const Include& include : includes_of(source)) {
      const Source* header = include.quoted ? resolve(source, include) : nullptr;
      if (header == nullptr) {
        continue;
      }
      const Target* to = graph.owner(header->path);
      ASSERT_NE(to, nullptr) << header->path;
      ++checked;
      EXPECT_TRUE(visible.count(to->name) > 0 || exceptions.cover(source.path))
          << at(source, include.line) << ": \"" << include.target << "\" is of " << to->name << ", which " << from->name
          << " does not link";
    }
  }
  EXPECT_GT(checked, 300) << "the test must find the includes";
  EXPECT_EQ(exceptions.unused(), "");
}

TEST(Layering, NoLibraryReachesItself) {
  const TargetGraph& graph = TargetGraph::of_product();
  for (const auto& [name, target] : graph.targets()) {
    for (const std::string& link : target.links) {
      EXPECT_EQ(graph.reachable(link).count(name), 0u) << name << " and " << link << " need each other";
    }
  }
}

TEST(Layering, OnlyNamedPlacesIncludeVendorOrGeneratedHeaders) {
  constexpr const char* kVendorFolders[] = {"dds/", "ddsc/", "fastdds/", "fastrtps/", "fastcdr/", "mujoco/"};
  Exceptions exceptions(kVendorHeaders);
  for (const Source& source : source_tree()) {
    if (!source.is_cpp()) {
      continue;
    }
    for (const Include& include : includes_of(source)) {
      const bool example = include.target.starts_with("docs/how-to/");  // of a page, which tests build as well
      bool foreign = include.quoted && resolve(source, include) == nullptr && !example;
      for (const char* folder : kVendorFolders) {
        foreign = foreign || include.target.rfind(folder, 0) == 0;
      }
      EXPECT_TRUE(!foreign || exceptions.cover(source.path))
          << at(source, include.line) << ": \"" << include.target << "\" is a vendor's or generated";
    }
  }
  EXPECT_EQ(exceptions.unused(), "");
}

// A node's logic links and is tested without any transport.
TEST(Layering, NoProcessCoreReachesABusOrARuntime) {
  const TargetGraph& graph = TargetGraph::of_product();
  int cores = 0;
  for (const std::string& process : processes()) {
    const std::string core = "farrier_" + process + "_core";
    if (graph.targets().count(core) == 0) {
      continue;  // its application is all there is
    }
    ++cores;
    for (const char* forbidden : {"farrier_bus", "farrier_bus_cyclone", "farrier_bus_fastdds", "farrier_bus_factory",
                                  "farrier_participant", "farrier_process", "farrier_runtime"}) {
      EXPECT_EQ(graph.reachable(core).count(forbidden), 0u) << core << " reaches " << forbidden;
    }
  }
  EXPECT_EQ(cores, 4);
}

// A controller that read the true state would look better than it is: sim_bridge alone says it, and nobody whom a
// process links reads it. Those who hand every topic on do not name it.
TEST(Layering, NoProcessOfTheRobotReadsTheTruthAboutItsBodyOrActuators) {
  static const std::regex named(R"re(\bk?(Body|Supply)Truth\b)re");
  static const std::regex heard(R"re((subscribe|Subscription|In)<(signals::)?(Body|Supply)Truth>)re");
  const TargetGraph& graph = TargetGraph::of_product();
  int sayers = 0;
  for (const std::string& process : processes()) {
    EXPECT_EQ(graph.reachable(process).count("farrier_monitor"), 0u) << process;
    for (const Source& source : source_tree()) {
      const Target* owner = graph.owner(source.path);
      if (owner == nullptr || !(owner->name == process || graph.reachable(process).contains(owner->name))) {
        continue;
      }
      // The contract and the trace's format are data.
      const bool may_name = process == "sim_bridge" || source.in("lib/signals") || source.in("lib/bus") ||
                            source.in("lib/trace") || source.in("lib/participant");
      for (const std::string& line : code_of(source)) {
        EXPECT_FALSE(std::regex_search(line, heard)) << source.path << ": " << line;
        const bool names = std::regex_search(line, named);
        EXPECT_FALSE(names && !may_name) << source.path << ", which " << process << " links: " << line;
        sayers += names && process == "sim_bridge" && source.in("sim_bridge") ? 1 : 0;
      }
    }
  }
  EXPECT_GT(sayers, 0) << "nobody says the truth any more: this test looks for the wrong word";
}

// The numerics serve any transport, any process and any file format.
TEST(Layering, NoNumericalLibraryReachesSignalsConfigurationOrTransport) {
  const TargetGraph& graph = TargetGraph::of_product();
  for (const char* library : {"farrier_core", "farrier_plant", "farrier_control", "farrier_estimation", "farrier_gait",
                              "farrier_body", "farrier_locomotion"}) {
    ASSERT_EQ(graph.targets().count(library), 1u) << library;
    for (const char* forbidden : {"farrier_signals", "farrier_config", "farrier_robot", "farrier_bus",
                                  "farrier_runtime", "farrier_trace", "farrier_participant", "yaml-cpp"}) {
      EXPECT_EQ(graph.reachable(library).count(forbidden), 0u) << library << " reaches " << forbidden;
    }
  }
}

// Folders from the bottom up: a target links only targets of its own layer and of those below. Where a folder is part of
// another one, the longer name counts. docs/architecture.md draws this.
const std::vector<std::vector<std::string>>& layers() {
  static const std::vector<std::vector<std::string>> all{
      {"lib"},
      processes(),
      {"lib/run"},
      {"trials", "tools", "report", "bench/bare_exchange"},
      {"bench", "thesis", "cli"},
      {"cli/manual"},  // reads every verb's options
  };
  return all;
}

int layer_of(const std::string& folder) {
  int layer = -1;
  std::size_t longest = 0;
  for (std::size_t i = 0; i < layers().size(); ++i) {
    for (const std::string& room : layers()[i]) {
      const bool inside = folder == room || (folder.starts_with(room) && folder[room.size()] == '/');
      if (inside && room.size() > longest) {
        longest = room.size();
        layer = static_cast<int>(i);
      }
    }
  }
  return layer;
}

TEST(Layering, NoArrowRunsBackUp) {
  const TargetGraph& graph = TargetGraph::of_product();
  for (const auto& [name, target] : graph.targets()) {
    if (target.folder.empty() || target.folder.rfind("cmake", 0) == 0) {
      continue;
    }
    EXPECT_GE(layer_of(target.folder), 0) << target.folder << " has no layer";
    for (const std::string& link : target.links) {
      const auto linked = graph.targets().find(link);
      if (linked != graph.targets().end() && !linked->second.folder.empty()) {
        EXPECT_LE(layer_of(linked->second.folder), layer_of(target.folder)) << name << " links " << link << " above it";
      }
    }
  }
}

TEST(Layering, NothingLinksAProcess) {
  const TargetGraph& graph = TargetGraph::of_product();
  const std::vector<std::string> all = processes();
  ASSERT_GE(all.size(), 5u);
  for (const std::string& process : all) {
    EXPECT_EQ(graph.targets().count(process), 1u) << process;
    for (const auto& [name, target] : graph.targets()) {
      EXPECT_EQ(target.links.count(process), 0u) << name << " links " << process;
    }
  }
}

}  // namespace
}  // namespace farrier::architecture
