// "from_idl OUTPUT_DIR FILE.idl..." writes the C++ of idl/ at build time. The structs of the topics go to structs.hpp.
// The lists that codecs are expanded from go to field_lists.hpp.

#include <cstdio>
#include <fstream>
#include <functional>
#include <stdexcept>

#include "signals/from_idl/write_cpp.hpp"

namespace farrier::from_idl {
namespace {

/// Writes a file. Throws std::runtime_error if the disk refuses.
void write(const std::filesystem::path& path, const std::function<void(std::ostream&)>& content) {
  std::ofstream out(path);
  content(out);
  if (!out.flush()) {
    throw std::runtime_error("cannot write " + path.string());
  }
}

void generate(const std::filesystem::path& folder, std::span<char*> paths) {
  const Files files = read_all(paths);
  std::filesystem::create_directories(folder);
  write(folder / "structs.hpp", [&](std::ostream& out) { write_structs(files, out); });
  write(folder / "field_lists.hpp", [&](std::ostream& out) { write_field_lists(files, out); });
  write(folder / "cyclone_types.hpp", [&](std::ostream& out) { write_includes(files, ".h", out); });
  write(folder / "fast_types.hpp", [&](std::ostream& out) { write_includes(files, "PubSubTypes.h", out); });
}

}  // namespace
}  // namespace farrier::from_idl

int main(int count, char** arguments) {
  if (count < 3) {
    std::fputs("usage: from_idl OUTPUT_DIR FILE.idl...\n", stderr);
    return 2;
  }
  try {
    farrier::from_idl::generate(arguments[1], {arguments + 2, arguments + count});
  } catch (const std::runtime_error& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 2;
  }
  return 0;
}
