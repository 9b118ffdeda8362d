#include "cli/processes/process_stat.hpp"

#include <unistd.h>

#include <fstream>
#include <iterator>
#include <sstream>
#include <string>

namespace farrier::cli {

std::optional<ProcessStat> process_stat(pid_t process) {
  std::ifstream file("/proc/" + std::to_string(process) + "/stat");
  const std::string text{std::istreambuf_iterator<char>(file), {}};
  const std::size_t name_end = text.rfind(')');  // a name may have brackets and blanks, what follows has none
  if (name_end == std::string::npos) {
    return std::nullopt;
  }
  constexpr int kState = 3, kUserTime = 14;  // the fields' numbers in the manual
  std::istringstream fields(text.substr(name_end + 1));
  ProcessStat stat;
  fields >> stat.state;
  std::string skipped;
  for (int i = kState + 1; i < kUserTime; ++i) {
    fields >> skipped;
  }
  double user = 0.0, system = 0.0;
  fields >> user >> system;
  stat.processor_s = (user + system) / static_cast<double>(::sysconf(_SC_CLK_TCK));
  return stat;
}

bool is_traced(pid_t process) {
  std::ifstream file("/proc/" + std::to_string(process) + "/status");
  for (std::string word; file >> word;) {
    if (word == "TracerPid:") {
      pid_t tracer = 0;
      return file >> tracer && tracer != 0;
    }
  }
  return false;
}

}  // namespace farrier::cli
