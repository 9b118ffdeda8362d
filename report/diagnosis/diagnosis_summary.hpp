#pragma once

#include <string>

#include "report/diagnosis/diagnosis_result.hpp"
#include "report/page/html_page.hpp"

namespace farrier::report {

/// The first part of a report, for the person at the machine: what was found, where, how sure that is, and what to do
/// next. HTML.
std::string summary_html(const DiagnosisResult& result);

/// The verdict in two words.
Badge badge_of(diagnosis::Verdict verdict);

/// "almost certain" from 0.99 on, "likely" from 0.9, "possible" from 0.5, else "doubtful".
const char* confidence_words(double confidence) noexcept;

}  // namespace farrier::report
