#pragma once

#include <optional>
#include <string>
#include <vector>

#include "diagnosis/judge/diagnosis.hpp"
#include "diagnosis/wiring/wiring_evidence.hpp"
#include "robot/robot.hpp"
#include "report/figures/figures.hpp"

namespace farrier::report {

/// Gain of force control from knowing the effects found.
struct ControlGain {
  std::string effect;           ///< those it can use, separated by commas
  double old_nrmse, new_nrmse;  ///< of the force, with controllers for the model as given and for the extended one
};

/// The robot file with the effects that a diagnosis found.
struct ModelOfDiagnosis {
  std::string path = {};                   ///< of the file; empty: none was written
  std::vector<std::string> left_out = {};  ///< effects without a place in it, a sentence each
  std::optional<diagnosis::ErrorRatio> error =
      {};  ///< of the file as given and of this one; none: there is no such file
};

/// A diagnosis and what it is about. Refers to what it is made of; lives no longer than a call.
struct DiagnosisResult {
  const diagnosis::Diagnosis& diagnosis;
  const robot::Robot& robot;
  const robot::Joint& joint;
  std::string recording;                                   ///< the file's path, for people
  double period_s = 0.0;                                   ///< of the recording; 0 for data that could not be read
  std::vector<diagnosis::Finding> findings = {};           ///< what is wrong with bad data, or with the wiring
  std::vector<diagnosis::WiringAnswer> wiring = {};        ///< of the verdict `wiring`, in the order of `findings`
  std::optional<diagnosis::WiringEvidence> evidence = {};  ///< for the first of them
  ModelOfDiagnosis model = {};
  std::optional<ControlGain> control = {};
};

/// True for a verdict about the recording, not about the joint: `bad_data` and `wiring`.
bool is_refused(const DiagnosisResult& result) noexcept;

/// Units in which the numbers of an effect are shown: of a cylinder's file, of a rotary motor's, or of a recording
/// without units, in which times are counted in samples.
enum class Units { kLinear, kRotary, kScaled };

/// An effect for people.
struct ShownEffect {
  const plant::EffectInfo* info;
  struct Number {
    std::string name;
    std::string unit;  ///< "1" for ratios
    double value;
  };
  std::vector<Number> numbers;  ///< its parameters; the first gives its size
  double low, high;             ///< 95 % interval of the first, within what the parameter may be
  double share, confidence;     ///< as in diagnosis::NamedEffect
};
ShownEffect shown(const diagnosis::NamedEffect& effect, const robot::Joint& joint);
ShownEffect shown(const diagnosis::NamedEffect& effect, const plant::Scales& scales, Units units);

/// One of its parameters, for a fitted number.
ShownEffect::Number shown(const plant::Parameter& parameter, double fitted, const plant::Scales& scales, Units units);

/// Held-out errors of a diagnosis.
diagnosis::ErrorRatio error_of(const diagnosis::Diagnosis& diagnosis) noexcept;

/// Unit of a channel's residual: "N", "m/s" or those of a rotary joint.
const char* unit_of(diagnosis::Channel channel, const robot::Joint& joint) noexcept;

/// Adds diagnose.*; nothing for data that could not be judged.
void add_diagnosis(Figures& figures, const DiagnosisResult& result);

}  // namespace farrier::report
