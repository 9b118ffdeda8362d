// farrier-ros: the program of ros.

#include "cli/base/command.hpp"
#include "cli/base/command_line.hpp"

int main(int argc, char** argv) {
  using namespace farrier::cli;
  constexpr DeclaredVerb kVerbs[] = {{"ros", declare_ros}};
  return run_program(kVerbs, argc, argv);
}
