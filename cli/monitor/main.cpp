// farrier-monitor: the program of monitor.

#include "cli/base/command.hpp"
#include "cli/base/command_line.hpp"

int main(int argc, char** argv) {
  using namespace farrier::cli;
  constexpr DeclaredVerb kVerbs[] = {{"monitor", declare_monitor}};
  return run_program(kVerbs, argc, argv);
}
