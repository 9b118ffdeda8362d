#include "cli/processes/onlookers.hpp"

#include <csignal>

#include "cli/processes/dds_run.hpp"
#include "cli/base/installation.hpp"
#include "cli/processes/process_stat.hpp"

namespace farrier::cli {
namespace {

using namespace std::chrono_literals;

constexpr Tick kParts = 4;  // of the run, of which the first is left out: readers and writers find each other
constexpr auto kBetweenLooks = 100ms;
constexpr auto kStart = 30s;

}  // namespace

Result<Onlookers> Onlookers::start(const DdsRun& run, int domain) {
  Onlookers onlookers(run.common.ticks);
  for (const Onlooker& onlooker : run.onlookers) {
    std::vector<std::string> arguments = onlooker.arguments;
    arguments.insert(arguments.end(), {"--robot", run.common.robot_path, "--domain", std::to_string(domain), "--dds",
                                       to_string(run.dds == DdsChoice::kFast ? Vendor::kFast : Vendor::kCyclone)});
    onlookers.processes_.push_back(FARRIER_TRY(ChildProcess::start(onlooker.name, farrier_command(), arguments,
                                                                   run.log_directory + "/" + onlooker.name + ".log")));
    onlookers.stands_still_.push_back(onlooker.stands_still);
  }
  for (std::size_t i = 0; i < onlookers.processes_.size(); ++i) {
    FARRIER_TRY(onlookers.processes_[i].wait_for_words(run.onlookers[i].listens, kStart));
  }
  onlookers.uses_.resize(onlookers.processes_.size());
  return onlookers;
}

void Onlookers::look(Tick tick, SteadyTime now) {
  if (processes_.empty() || tick < ticks_ / kParts || now - end_ < kBetweenLooks) {
    return;
  }
  const bool first = begin_ == SteadyTime{};
  for (std::size_t i = 0; i < processes_.size(); ++i) {
    if (const auto stat = process_stat(processes_[i].pid())) {
      uses_[i].end_s = stat->processor_s;
    }
    if (first) {
      uses_[i].begin_s = uses_[i].end_s;
      if (stands_still_[i]) {
        ::kill(processes_[i].pid(), SIGSTOP);
      }
    }
  }
  begin_ = first ? now : begin_;
  end_ = now;
}

Result<std::vector<OnlookerUse>> Onlookers::finish() {
  for (std::size_t i = 0; i < processes_.size(); ++i) {
    if (stands_still_[i]) {
      ::kill(processes_[i].pid(), SIGCONT);  // or it could not end when asked to
    }
  }
  // A monitor that a signal ends says so in its status.
  if (const std::string hard_ends = end_all(processes_, {0, 128 + SIGTERM}); !hard_ends.empty()) {
    return Error{hard_ends};
  }
  const double lasted_s = std::chrono::duration<double>(end_ - begin_).count();
  std::vector<OnlookerUse> uses;
  for (const Use& use : uses_) {
    uses.push_back({lasted_s > 0.0 ? (use.end_s - use.begin_s) / lasted_s : 0.0});
  }
  return uses;
}

}  // namespace farrier::cli
