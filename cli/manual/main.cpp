// farrier-manual: the program of completion, man and tables.

#include "cli/base/command.hpp"
#include "cli/base/command_line.hpp"

int main(int argc, char** argv) {
  using namespace farrier::cli;
  constexpr DeclaredVerb kVerbs[] = {
      {"completion", declare_completion},
      {"man", declare_man},
      {"tables", declare_tables}};
  return run_program(kVerbs, argc, argv);
}
