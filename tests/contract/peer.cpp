#include "peer.hpp"

#include <fcntl.h>
#include <csignal>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include "core/ensure.hpp"

namespace farrier::contract {
namespace {

[[noreturn]] void become(const std::vector<std::string>& arguments, int input, int output) {
  prctl(PR_SET_PDEATHSIG, SIGKILL);
  dup2(input, STDIN_FILENO);
  dup2(output, STDOUT_FILENO);
  std::vector<char*> argv;
  std::string self = "/proc/self/exe";
  argv.push_back(self.data());
  for (const std::string& argument : arguments) {
    argv.push_back(const_cast<char*>(argument.c_str()));
  }
  argv.push_back(nullptr);
  execv(self.c_str(), argv.data());
  _exit(127);
}

}  // namespace

Peer::Peer(const std::vector<std::string>& arguments) {
  int to_peer[2];
  int from_peer[2];
  FARRIER_ENSURE(pipe2(to_peer, O_CLOEXEC) == 0 && pipe2(from_peer, O_CLOEXEC) == 0, "pipes for a peer");
  pid_ = fork();
  FARRIER_ENSURE(pid_ >= 0, "fork of a peer");
  if (pid_ == 0) {
    become(arguments, to_peer[0], from_peer[1]);
  }
  close(to_peer[0]);
  close(from_peer[1]);
  input_ = to_peer[1];
  output_ = fdopen(from_peer[0], "r");
}

Peer::~Peer() {
  kill();
  if (input_ >= 0) {
    close(input_);
  }
  fclose(output_);
}

void Peer::kill() {
  if (pid_ > 0) {
    ::kill(pid_, SIGKILL);
    waitpid(pid_, nullptr, 0);
    pid_ = -1;
  }
}

void Peer::stop() { ::kill(pid_, SIGSTOP); }

std::string Peer::read_line() {
  std::string line;
  for (int c = std::fgetc(output_); c != EOF && c != '\n'; c = std::fgetc(output_)) {
    line += static_cast<char>(c);
  }
  return line;
}

int Peer::finish() {
  close(input_);
  input_ = -1;
  int status = 0;
  waitpid(pid_, &status, 0);
  pid_ = -1;
  return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
}

}  // namespace farrier::contract
