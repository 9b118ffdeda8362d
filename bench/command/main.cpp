// farrier-bench: the program of bench.

#include "cli/base/command.hpp"
#include "cli/base/command_line.hpp"

int main(int argc, char** argv) {
  using namespace farrier::cli;
  constexpr DeclaredVerb kVerbs[] = {{"bench", declare_bench}};
  return run_program(kVerbs, argc, argv);
}
