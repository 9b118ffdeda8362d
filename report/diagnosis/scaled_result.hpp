#pragma once

#include <string>
#include <vector>

#include "diagnosis/judge/scaled_diagnosis.hpp"
#include "report/diagnosis/diagnosis_result.hpp"
#include "report/figures/figures.hpp"

namespace farrier::report {

/// A diagnosis of a recording in scaled units and what it is about. Refers to what it is made of; lives no longer than
/// a call.
struct ScaledResult {
  const diagnosis::ScaledDiagnosis* diagnosis;    ///< null for data that cannot be judged
  std::string recording;                          ///< the file's path, for people
  std::vector<diagnosis::Finding> findings = {};  ///< what is wrong with bad data

  diagnosis::Verdict verdict() const noexcept {
    return diagnosis == nullptr ? diagnosis::Verdict::kBadData : diagnosis->judgement.verdict;
  }
};

/// The effects that were named.
std::vector<ShownEffect> shown_effects(const diagnosis::ScaledDiagnosis& diagnosis);

/// Adds diagnose.*.
void add_diagnosis(Figures& figures, const diagnosis::ScaledDiagnosis& diagnosis);

}  // namespace farrier::report
