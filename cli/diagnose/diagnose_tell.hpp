#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "cli/base/with_bar.hpp"
#include "cli/diagnose/diagnose_options.hpp"
#include "core/result.hpp"
#include "diagnosis/judge/diagnosis.hpp"

namespace farrier::cli {

/// Result of `work` with `threads` and a bar of its progress.
template <class Work>
auto with_options(int threads, const Work& work) {
  std::optional<decltype(work(diagnosis::DiagnosisOptions()))> made;
  with_bar("diagnose", [&](const auto& progress) {
    diagnosis::DiagnosisOptions options;
    options.threads = threads;
    options.progress = progress;
    made = work(options);
  });
  return std::move(*made);
}

/// The effects of --set. Refuses names of no effect, those that the joint cannot have or has in its file, and a name that stands
/// twice.
Result<std::vector<plant::EffectId>> asked_set(const std::vector<std::string>& names, const robot::Joint& joint);

/// Prints what a recording can tell, of the effects of `set` or, without any, of each effect alone. Writes it to `json_path`
/// unless that is empty. Exit status of the command.
int tell(const diagnosis::Recording& recording, const robot::Robot& robot, const robot::Joint& joint,
         const std::vector<plant::EffectId>& set, const DiagnoseOptions& options, const std::string& json_path);

}  // namespace farrier::cli
