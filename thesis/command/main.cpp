// farrier-thesis: the program of reproduce.

#include "cli/base/command.hpp"
#include "cli/base/command_line.hpp"

int main(int argc, char** argv) {
  using namespace farrier::cli;
  constexpr DeclaredVerb kVerbs[] = {{"reproduce", declare_reproduce}};
  return run_program(kVerbs, argc, argv);
}
