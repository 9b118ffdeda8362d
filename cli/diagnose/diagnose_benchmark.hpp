#pragma once

#include <cstdint>
#include <string>

namespace farrier::cli {

/// Options of `farrier diagnose --benchmark`.
struct DiagnoseBenchmark {
  std::string json_path;       ///< empty: none
  std::string confusion_path;  ///< Markdown of what was taken for what; empty: none
  std::uint64_t seed = 1;
  int trials = 0;              ///< spread evenly over all; 0: all
  int threads = 2;
  bool go_on = false;          ///< takes the trials over that an earlier run of this build kept beside `json_path`
};

/// Blind trials of the diagnosis on the nominal robots in `robots`, a folder with fc1d.yaml and hyq.yaml. Exit status of
/// the command.
int run_diagnose_benchmark(const DiagnoseBenchmark& options, const std::string& robots);

}  // namespace farrier::cli
