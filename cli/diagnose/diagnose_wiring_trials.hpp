#pragma once

#include <cstdint>
#include <string>

namespace farrier::cli {

/// `farrier diagnose --wiring`: faults of wiring put into recordings of the generator, and every blind trial of the
/// benchmark, in none of which one may be named. `robots` is a folder with fc1d.yaml and hyq.yaml. `trials` blind trials
/// spread evenly, 0: all. Exit status of the command.
int run_wiring_benchmark(const std::string& json_path, std::uint64_t seed, int trials, int threads,
                         const std::string& robots);

}  // namespace farrier::cli
