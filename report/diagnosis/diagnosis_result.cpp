#include "report/diagnosis/diagnosis_result.hpp"

#include <algorithm>
#include <string_view>

#include "diagnosis/model/scaled_simulator.hpp"
#include "robot/joint_scales.hpp"

namespace farrier::report {
namespace {

constexpr double kDeviationsOf95 = 1.96;

std::string without_unit(std::string_view name, std::string_view unit) {
  return std::string(name.ends_with(unit) ? name.substr(0, name.size() - unit.size()) : name);
}

}  // namespace

const char* unit_of(diagnosis::Channel channel, const robot::Joint& joint) noexcept {
  switch (channel) {
    case diagnosis::Channel::kForce:
      return joint.rotary ? "Nm" : "N";
    case diagnosis::Channel::kMotion:
    case diagnosis::Channel::kVelocitySensor:
      return joint.rotary ? "rad/s" : "m/s";
  }
  return "";
}

diagnosis::ErrorRatio error_of(const diagnosis::Diagnosis& d) noexcept {
  return {d.nrmse_before, d.nrmse_after, d.ratio_low, d.ratio_high};
}

ShownEffect::Number shown(const plant::Parameter& parameter, double fitted, const plant::Scales& scales, Units units) {
  const double value = scales.value(parameter, fitted);
  if (units == Units::kScaled) {
    switch (parameter.scale) {
      case plant::Scale::kOne:
        return {parameter.name, "1", value};
      case plant::Scale::kSecond:
        return {without_unit(parameter.name, "_s"), "samples", value / diagnosis::ScaledSimulator::kSample_s};
      case plant::Scale::kRate:
        return {without_unit(parameter.name, "_rad_s"), "rad/sample", value * diagnosis::ScaledSimulator::kSample_s};
      default:  // of the valve: no other scale is judged without units
        return {without_unit(parameter.name, "_A"), "of the valve's unit", value};
    }
  }
  const bool rotary = units == Units::kRotary;
  return {rotary ? parameter.rotary_name : parameter.name, rotary ? parameter.rotary_unit : parameter.unit, value};
}

ShownEffect shown(const diagnosis::NamedEffect& effect, const plant::Scales& scales, Units units) {
  ShownEffect show{.info = &plant::effect_info(effect.id),
                   .numbers = {},
                   .low = 0.0,
                   .high = 0.0,
                   .share = effect.share,
                   .confidence = effect.confidence};
  for (std::size_t i = 0; i < show.info->parameters.size(); ++i) {
    if (!show.info->parameters[i].held) {
      show.numbers.push_back(shown(show.info->parameters[i], effect.fitted[i], scales, units));
    }
  }
  const plant::Parameter& first = show.info->parameters[0];
  const auto end = [&](double deviations) {
    const double fitted = std::clamp(effect.fitted[0] + deviations * effect.deviation, first.low, first.high);
    return shown(first, fitted, scales, units).value;
  };
  const auto [low, high] = std::minmax({end(-kDeviationsOf95), end(kDeviationsOf95)});
  show.low = low;
  show.high = high;
  return show;
}

ShownEffect shown(const diagnosis::NamedEffect& effect, const robot::Joint& joint) {
  return shown(effect, robot::scales_of(joint), joint.rotary ? Units::kRotary : Units::kLinear);
}

bool is_refused(const DiagnosisResult& result) noexcept {
  const diagnosis::Verdict verdict = result.diagnosis.judgement.verdict;
  return verdict == diagnosis::Verdict::kBadData || verdict == diagnosis::Verdict::kWiring;
}

void add_diagnosis(Figures& figures, const DiagnosisResult& result) {
  const diagnosis::Diagnosis& diagnosis = result.diagnosis;
  if (diagnosis.channels.empty()) {
    return;
  }
  for (const diagnosis::ChannelReport& channel : diagnosis.channels) {
    const std::string name = std::string("diagnose.") + channel.name + ".";
    for (const auto& [when, horizons] : {std::pair{"before", &channel.before}, std::pair{"after", &channel.after}}) {
      figures.add(name + "one_step_nrmse_" + when, horizons->one_step);
      figures.add(name + "ahead_50ms_nrmse_" + when, horizons->ahead_50ms);
      figures.add(name + "free_running_nrmse_" + when, horizons->free_running);
    }
    figures.add(name + "whiteness_before", channel.whiteness);
    figures.add(name + "whiteness_after", channel.whiteness_after);
    figures.add(name + "cross_correlation_before", channel.cross_correlation);
    figures.add(name + "cross_correlation_after", channel.cross_correlation_after);
  }
  figures.add("diagnose.held_out_nrmse_before", diagnosis.nrmse_before);
  figures.add("diagnose.held_out_nrmse_after", diagnosis.nrmse_after);
  figures.add("diagnose.held_out_ratio", diagnosis.nrmse_before / diagnosis.nrmse_after);
  figures.add("diagnose.effects", static_cast<double>(diagnosis.judgement.effects.size()));
  if (result.control) {
    figures.add("diagnose.control.old_nrmse", result.control->old_nrmse);
    figures.add("diagnose.control.new_nrmse", result.control->new_nrmse);
    figures.add("diagnose.control.ratio", result.control->old_nrmse / result.control->new_nrmse);
  }
}

}  // namespace farrier::report
