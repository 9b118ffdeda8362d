#pragma once

#include <string>

#include "core/result.hpp"
#include "report/diagnosis/diagnosis_result.hpp"
#include "report/figures/outcome.hpp"

namespace farrier::report {

/// The form of every command, to_json(outcome). "verdict" is "effects" | "none" | "cannot_separate" | "unknown" |
/// "not_excited" | "bad_data" | "wiring". Values that are not finite are null. Further keys:
///
/// "robot", "joint", "recording" are texts, and "extended_model" is a path or null. "effects": [{"name", "parameter",
/// "value", "unit", "low", "high" (95 %), "confidence", "share", "parameters": [{"name", "value", "unit"}]}], by their
/// share of the gain. "alternatives" are pairs: [[name, name]]. "experiment": {"one", "other", "excitation",
/// "amplitude_A", "frequency_Hz", "duration_s", "amplitude_Nm", "hold_stiffness_Nm_rad", "hold_damping_Nms_rad" (null of
/// a hydraulic joint), "difference", "text"} or null, of the first alternatives. "experiments"
/// are all of them, and "not_judged" is [name]. "held_out": {"nrmse_before", "nrmse_after", "low", "high" (95 % of the
/// one over the other)} or null. "control": {"effect", "old_nrmse", "new_nrmse"} or null.
/// "extended_model_held_out" is as "held_out", of the extended model as its file loads, and "extended_model_lacks" is [text],
/// the effects that a robot file has no place for. "channels": [{"name", "unit",
/// "dependences": [{"driver", "explained", "shape", "from", "mean", "deviation"}], "left": {"rms", "expected",
/// "nrmse"}}]. "remarks" is [text]. With bad data and wrong wiring "findings" are [{"what", "row", "text"}]. "wiring", with
/// that verdict alone and in the order of "findings", is [{"what", "columns", "amount" (factor or samples), "joint" (whose
/// sensor it is) or null, "confidence", "left" (share of the deviation once undone)}].
std::string diagnosis_json(const DiagnosisResult& result, const Outcome& outcome);

/// Writes it to `path`; refuses what the disk does not take.
Result<Done> write_diagnosis_json(const std::string& path, const DiagnosisResult& result, const Outcome& outcome);

}  // namespace farrier::report
