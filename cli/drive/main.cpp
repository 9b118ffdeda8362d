// farrier-drive: the program of drive.

#include "cli/base/command.hpp"
#include "cli/base/command_line.hpp"

int main(int argc, char** argv) {
  using namespace farrier::cli;
  constexpr DeclaredVerb kVerbs[] = {{"drive", declare_drive}};
  return run_program(kVerbs, argc, argv);
}
