#pragma once

#include <cstdint>
#include <string>

namespace farrier::cli {

/// `farrier diagnose --wiring`: puts faults of wiring into recordings of the generator. Then it judges the blind trials of
/// the benchmark, which have none, `trials` of them in a mixed order, 0: all. `robots` is a folder with the robots of
/// load_trial_robots(). Exit status of the command.
int run_wiring_benchmark(const std::string& json_path, std::uint64_t seed, int trials, int threads,
                         const std::string& robots, bool electric);

}  // namespace farrier::cli
