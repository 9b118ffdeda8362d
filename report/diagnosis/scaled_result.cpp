#include "report/diagnosis/scaled_result.hpp"

namespace farrier::report {

std::vector<ShownEffect> shown_effects(const diagnosis::ScaledDiagnosis& diagnosis) {
  std::vector<ShownEffect> effects;
  for (const diagnosis::NamedEffect& effect : diagnosis.judgement.effects) {
    effects.push_back(shown(effect, diagnosis.scales, Units::kScaled));
  }
  return effects;
}

void add_diagnosis(Figures& figures, const diagnosis::ScaledDiagnosis& d) {
  figures.add("diagnose.fit_before_percent", d.fit_before_percent);
  figures.add("diagnose.fit_after_percent", d.fit_after_percent);
  for (const diagnosis::EffectAlone& alone : d.alone) {
    figures.add(std::string("diagnose.") + plant::effect_info(alone.id).name + ".fit_percent", alone.fit_percent);
  }
  figures.add("diagnose.held_out_nrmse_before", d.error.before);
  figures.add("diagnose.held_out_nrmse_after", d.error.after);
  figures.add("diagnose.held_out_ratio", d.error.before / d.error.after);
  figures.add("diagnose.effects", static_cast<double>(d.judgement.effects.size()));
}

}  // namespace farrier::report
