// farrier-robot: the program of deploy, doctor, echo, request, robot, security and topics.

#include "cli/base/command.hpp"
#include "cli/base/command_line.hpp"

int main(int argc, char** argv) {
  using namespace farrier::cli;
  constexpr DeclaredVerb kVerbs[] = {{"deploy", declare_deploy}, {"doctor", declare_doctor},
                                     {"echo", declare_echo},     {"request", declare_request},
                                     {"robot", declare_robot},   {"security", declare_security},
                                     {"topics", declare_topics}};
  return run_program(kVerbs, argc, argv);
}
