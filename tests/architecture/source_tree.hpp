#pragma once

#include <span>
#include <string>
#include <vector>

#include "tests/architecture/exceptions.hpp"

namespace farrier::architecture {

/// One text file of the repository.
struct Source {
  std::string path;  ///< from the repository's root, "lib/core/time.hpp"
  std::vector<std::string> lines;

  bool in(const std::string& folder) const { return path.rfind(folder + "/", 0) == 0; }
  bool is_cpp() const { return path.ends_with(".cpp") || path.ends_with(".hpp"); }
};

/// Every C++, CMake and IDL file of the product (its tests too), in order of path. Generated files are not in it.
const std::vector<Source>& source_tree();

/// The file, null when there is none.
const Source* find_source(const std::string& path);

/// The programs of a robot's processes, as lib/core/processes.def lists them.
std::vector<std::string> processes();

struct Include {
  std::string target;  ///< as written between the quotes or brackets
  bool quoted;
  int line;  ///< 1-based
};
std::vector<Include> includes_of(const Source& source);

/// The lines without comments and string literals, so that only code is searched.
std::vector<std::string> code_of(const Source& source);

/// "path:line".
std::string at(const Source& source, int line);

/// `cover` is true if the path is excepted. It notes which exceptions are used.
class Exceptions {
 public:
  explicit Exceptions(std::span<const Exception> list) : list_(list), used_(list.size(), false) {}

  bool cover(const std::string& path);
  /// Paths of exceptions that covered nothing.
  std::string unused() const;

 private:
  std::span<const Exception> list_;
  std::vector<bool> used_;
};

}  // namespace farrier::architecture
