#pragma once

#include <string>
#include <vector>

#include "report/diagnosis/scaled_result.hpp"

namespace farrier::report {

/// "position+ = position - 0.063 q(valve) - 0.0042": the model with this gain and drift, per sample.
std::string equation_text(double gain, double drift, bool linear);

/// A row for each model: name, fit on the half that it was not fitted to, findings, accepted or not.
std::vector<std::vector<std::string>> fits_table(const diagnosis::ScaledDiagnosis& diagnosis);

/// Details of the verdict, a sentence each, as verdict_details() has them for a joint.
std::vector<std::string> scaled_details(const ScaledResult& result);

/// "-16.6 % before, 85.3 % after"
std::string fit_text(const diagnosis::ScaledDiagnosis& diagnosis);

/// Diagnosis for a terminal: the linear model, the gain of each effect, the cause, the gain, the verdict.
std::string scaled_console(const ScaledResult& result);

}  // namespace farrier::report
