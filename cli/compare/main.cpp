// farrier-compare: the program of compare.

#include "cli/base/command.hpp"
#include "cli/base/command_line.hpp"

int main(int argc, char** argv) {
  using namespace farrier::cli;
  constexpr DeclaredVerb kVerbs[] = {{"compare", declare_compare}};
  return run_program(kVerbs, argc, argv);
}
