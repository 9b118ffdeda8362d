#pragma once

#include <span>
#include <string>
#include <vector>

#include "report/diagnosis/diagnosis_result.hpp"

namespace farrier::report {

const char* effect_name(plant::EffectId id) noexcept;

/// Autocorrelation below which a residual counts as white, ChannelReport::whiteness.
inline constexpr double kWhite = 4.0;

/// Describes the simple curve that a residual follows over bins of a driver: "grows straight with speed", "jumps with
/// the sign of speed". Empty if the bins explain less than a tenth of the residual.
std::string shape_of(const diagnosis::Dependence& dependence);

/// Middle of a bin of Dependence::from; the last is as wide as the one before.
double bin_centre(const std::vector<double>& from, std::size_t bin);

/// The dependence that explains most; null for none.
const diagnosis::Dependence* strongest(const diagnosis::ChannelReport& channel);

/// The experiment that tells two candidates apart, for the person who makes it.
std::string experiment_text(const diagnosis::Experiment& experiment);

/// Said where no experiment that was tried tells two candidates apart.
std::string no_experiment_text();

/// "valve and oil" for "valve_and_oil".
std::string words_of(const char* name);

/// The verdict in one sentence.
std::string verdict_sentence(const diagnosis::Judgement& judgement);

/// Effects that cannot be separated, a sentence each, with the experiment that would separate that pair if there is
/// one.
std::vector<std::string> alternatives_text(const diagnosis::Judgement& judgement,
                                           std::span<const diagnosis::Experiment> experiments);

/// Problems of bad data, a sentence each, with its row.
std::vector<std::string> findings_text(std::span<const diagnosis::Finding> findings);

/// "this recording could not show: ..."; empty where it could show everything.
std::string not_judged_text(const diagnosis::Judgement& judgement);

/// Details of the verdict, a sentence each. Effects have none. Candidates that are alike have the experiment, and an
/// unknown cause has the shape of the residual. Too little excitation has what was not judged, bad data has its rows.
std::vector<std::string> verdict_details(const DiagnosisResult& result);

/// "load_friction: coulomb_N 143.2 N (95 %: 138 to 148), confidence 0.99, 87 % of the gain".
std::string effect_text(const ShownEffect& effect);

/// "0.12 before, 0.03 after: 4.1 times less (95 %: 3.6 to 4.5)".
std::string gain_text(const diagnosis::ErrorRatio& error);

/// Path of the extended model, or why there is none.
std::string model_text(const ModelOfDiagnosis& model);

/// "force control that knows load_friction: NRMSE 0.1 before, 0.05 after"; empty where it was not measured.
std::string control_text(const DiagnosisResult& result);

/// Diagnosis for a terminal: where the simulation is wrong, the cause, the extended model, the gain, the verdict.
std::string diagnosis_console(const DiagnosisResult& result);

}  // namespace farrier::report
