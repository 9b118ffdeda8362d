#pragma once

#include <string>

#include "core/result.hpp"
#include "report/diagnosis/diagnosis_result.hpp"
#include "report/figures/outcome.hpp"

namespace farrier::report {

/// Writes out_dir/index.html with its pictures beside it and returns the page's path: where the simulation is wrong,
/// the cause, the extended model, the gain. The page needs nothing from elsewhere. Refuses for the reasons
/// draw_diagnosis does.
Result<std::string> write_diagnosis_page(const std::string& out_dir, const DiagnosisResult& result,
                                         const Outcome& outcome);

}  // namespace farrier::report
