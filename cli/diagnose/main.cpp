// farrier-diagnose: the program of diagnose, identify and trial.

#include "cli/base/command.hpp"
#include "cli/base/command_line.hpp"

int main(int argc, char** argv) {
  using namespace farrier::cli;
  constexpr DeclaredVerb kVerbs[] = {
      {"diagnose", declare_diagnose},
      {"identify", declare_identify},
      {"trial", declare_trial}};
  return run_program(kVerbs, argc, argv);
}
