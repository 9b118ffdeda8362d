#pragma once

#include <map>
#include <set>
#include <string>
#include <vector>

#include "tests/architecture/source_tree.hpp"

namespace farrier::architecture {

/// A target one of our CMakeLists.txt declares.
struct Target {
  std::string name;
  std::string folder;              ///< of its CMakeLists.txt
  std::set<std::string> sources;   ///< from the repository's root
  std::set<std::string> links;     ///< every edge
  std::set<std::string> passed_on; ///< PUBLIC and INTERFACE edges
};

/// The declared graph: what farrier_library, add_library, add_executable, target_sources and target_link_libraries
/// lines say. Targets of other projects appear as names only.
class TargetGraph {
 public:
  /// Reads the given CMake files.
  explicit TargetGraph(const std::vector<const Source*>& cmake_files);

  /// The graph of the product: lib/, process folders, lab, tools.
  static const TargetGraph& of_product();

  const std::map<std::string, Target>& targets() const { return targets_; }

  /// The target a file belongs to: the one that lists it, or its .cpp for a header. A header without a .cpp belongs to
  /// the first target of its folder with a source that includes it, else to the first target of its folder. Null
  /// when no CMakeLists.txt above the file declares a target.
  const Target* owner(const std::string& path) const;

  /// Everything whose headers `target` may include: itself, what it links, and what that passes on.
  std::set<std::string> visible(const std::string& target) const;

  /// Everything `target` drags in, by any edge.
  std::set<std::string> reachable(const std::string& target) const;

 private:
  void run(const std::string& command, const std::vector<std::string>& arguments, const std::string& folder);

  std::map<std::string, Target> targets_;
  std::map<std::string, std::vector<std::string>> of_folder_;  ///< ours, in order of declaration
};

}  // namespace farrier::architecture
