// "ros_from_idl FILE.idl OUTPUT.hpp" writes the C++ structs of ros.idl at build time.

#include <cstdio>
#include <fstream>
#include <iterator>
#include <stdexcept>
#include <string>

#include "ros_messages/from_idl/write_structs.hpp"

int main(int count, char** arguments) {
  if (count != 3) {
    std::fputs("usage: ros_from_idl FILE.idl OUTPUT.hpp\n", stderr);
    return 2;
  }
  std::ifstream in(arguments[1]);
  const std::string text{std::istreambuf_iterator<char>(in), {}};
  std::ofstream out(arguments[2]);
  try {
    farrier::ros_from_idl::write_structs(text, out);
  } catch (const std::runtime_error& error) {
    std::fprintf(stderr, "%s: %s\n", arguments[1], error.what());
    return 2;
  }
  return out.flush() ? 0 : 2;
}
