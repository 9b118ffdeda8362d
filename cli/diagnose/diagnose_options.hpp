#pragma once

#include <CLI/CLI.hpp>
#include <cstdint>
#include <string>
#include <vector>

namespace farrier::cli {

/// In what a recording was written.
enum class Units { kSi, kScaled };

/// Kind of the joints of blind trials.
enum class Actuator { kHydraulic, kElectric };

/// Options of `farrier diagnose`.
struct DiagnoseOptions {
  std::string recording;
  Units units = Units::kSi;
  std::string model_path;
  std::string joint;      ///< empty: the robot's only one
  std::string out;        ///< empty: no files but `json_path`
  std::string json_path;  ///< empty: figures.json in `out`, or none
  int threads = 2;
  bool what_can_be_told = false;  ///< effects that the recording shows and tells apart, in place of a verdict
  std::vector<std::string> set;   ///< of that: effects that are asked about together; empty: each alone
  bool benchmark = false;         ///< run blind trials in place of a recording
  Actuator actuator = Actuator::kHydraulic;  ///< of the benchmark's joints
  bool healthy = false;                      ///< the benchmark is of healthy robots
  std::string calibration_path;              ///< of the map of confidences that the benchmark gives; empty: none
  bool wiring = false;                       ///< likewise trials of faults of wiring
  std::string confusion_path;                ///< of those: what was taken for what; empty: none
  std::uint64_t seed = 1;
  int trials = 0;      ///< 0: all
  bool go_on = false;  ///< the benchmark goes on from the trials that are kept
};

void declare(CLI::App& app, DiagnoseOptions& options);

}  // namespace farrier::cli
