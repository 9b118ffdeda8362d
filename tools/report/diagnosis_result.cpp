#include "tools/report/diagnosis_result.hpp"

#include <algorithm>

#include "plant/terms/active_effect.hpp"

namespace farrier::report {
namespace {

constexpr double kDeviationsOf95 = 1.96;

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

ShownEffect shown(const diagnosis::NamedEffect& effect, const robot::Joint& joint) {
  const plant::Scales scales(joint.actuator, joint.swing_load);
  const plant::ActiveEffect values = plant::active_effect(effect.id, effect.fitted, scales);
  ShownEffect show{.info = &values.info(),
                   .numbers = {},
                   .low = 0.0,
                   .high = 0.0,
                   .share = effect.share,
                   .confidence = effect.confidence};
  for (std::size_t i = 0; i < show.info->parameters.size(); ++i) {
    const plant::Parameter& p = show.info->parameters[i];
    show.numbers.push_back(
        {joint.rotary ? p.rotary_name : p.name, joint.rotary ? p.rotary_unit : p.unit, values.values[i]});
  }
  const plant::Parameter& first = show.info->parameters[0];
  const auto end = [&](double deviations) {
    return scales.value(first, std::clamp(effect.fitted[0] + deviations * effect.deviation, first.low, first.high));
  };
  const auto [low, high] = std::minmax({end(-kDeviationsOf95), end(kDeviationsOf95)});
  show.low = low;
  show.high = high;
  return show;
}

void add_diagnosis(Figures& figures, const diagnosis::Diagnosis& diagnosis) {
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
}

}  // namespace farrier::report
