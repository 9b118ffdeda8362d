// farrier: the command. It runs `trot` and `record` itself and starts the programs of the other verbs (cli/verbs.def).

#include "cli/base/command.hpp"
#include "cli/base/command_line.hpp"

int main(int argc, char** argv) {
  using namespace farrier::cli;
  constexpr DeclaredVerb kVerbs[] = {{"trot", declare_trot}, {"record", declare_record}};
  return run_program(kVerbs, argc, argv);
}
