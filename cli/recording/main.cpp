// farrier-recording: the program of convert, export, info, record and replay.

#include "cli/base/command.hpp"
#include "cli/base/command_line.hpp"

int main(int argc, char** argv) {
  using namespace farrier::cli;
  constexpr DeclaredVerb kVerbs[] = {{"convert", declare_convert},
                                     {"export", declare_export},
                                     {"info", declare_info},
                                     {"record", declare_record},
                                     {"replay", declare_replay}};
  return run_program(kVerbs, argc, argv);
}
