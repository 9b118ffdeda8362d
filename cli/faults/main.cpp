// farrier-faults: the program of faults.

#include "cli/base/command.hpp"
#include "cli/base/command_line.hpp"

int main(int argc, char** argv) {
  using namespace farrier::cli;
  constexpr DeclaredVerb kVerbs[] = {{"faults", declare_faults}};
  return run_program(kVerbs, argc, argv);
}
