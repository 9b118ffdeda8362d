#pragma once

#include "diagnosis/judge/diagnosis.hpp"
#include "diagnosis/data/scaled_recording.hpp"
#include "plant/terms/term.hpp"

namespace farrier::diagnosis {

/// One effect beside the linear model, alone, fitted to the first half. An offset of a linear valve is a drift and is
/// not tried.
struct EffectAlone {
  plant::EffectId id;
  std::vector<double> fitted;  ///< numbers of its parameters
  double deviation;            ///< standard deviation of the first
  double fit_percent;          ///< of the second half
  bool accepted;               ///< by the rules, in the first round
};

/// Diagnosis of a valve from a recording in scaled units. Fits are 100 (1 - |y - s| / |y - mean y|) % of positions y
/// and simulations s that run freely over the second half, of models fitted to the first (ScaledSimulator).
struct ScaledDiagnosis {
  Judgement judgement;
  plant::Scales scales;              ///< of the effects' numbers; times in ScaledSimulator::kSample_s
  double gain_before, drift_before;  ///< per sample, of the linear model
  double gain_after, drift_after;    ///< with the effects
  double fit_before_percent, fit_after_percent;
  ErrorRatio error;  ///< held-out NRMSE, each half by the other's fit
  std::vector<EffectAlone> alone;
  std::size_t held_out_begin;                   ///< sample
  std::vector<double> measured, before, after;  ///< of the second half, for pictures
  std::vector<std::string> remarks;
};

/// 100 (1 - |y - s| / |y - mean y|) % of measured y and simulated s, of one size; y not constant.
double fit_percent(std::span<const double> measured, std::span<const double> simulated);

/// Diagnoses a recording by the rules of diagnose(). DiagnosisOptions::fit is adapted to data without a time base.
ScaledDiagnosis diagnose_scaled(const ScaledRecording& recording, const DiagnosisOptions& options = {});

}  // namespace farrier::diagnosis
