#include "report/figures/growth.hpp"

#include <cmath>

#include "report/figures/run_info.hpp"

namespace farrier::report {

std::vector<std::string> add_growth(Figures& figures, const std::vector<ProcessInfo>& processes) {
  struct Kind {
    const char* figure;
    const char* what;
    double Growth::*of;
    double bound;
  };
  constexpr Kind kKinds[] = {{"trot.memory_growth_KiB", "KiB of memory", &Growth::memory_KiB, kMemoryGrowth_KiB},
                             {"trot.threads_growth", "threads", &Growth::threads, 0.0},
                             {"trot.descriptors_growth", "descriptors", &Growth::descriptors, 0.0}};
  std::vector<std::string> failures;
  for (const Kind& kind : kKinds) {
    const ProcessInfo* largest = nullptr;
    for (const ProcessInfo& process : processes) {
      if (process.growth && (largest == nullptr || *process.growth.*kind.of > *largest->growth.*kind.of)) {
        largest = &process;
      }
    }
    const double growth = largest == nullptr ? NAN : *largest->growth.*kind.of;
    figures.add(kind.figure, growth, kind.bound);
    if (growth > kind.bound) {
      failures.push_back(largest->name + " grew by " + std::to_string(std::lround(growth)) + " " + kind.what +
                         " after the first tenth of the run");
    }
  }
  return failures;
}

}  // namespace farrier::report
