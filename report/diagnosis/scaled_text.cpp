#include "report/diagnosis/scaled_text.hpp"

#include <cmath>

#include "core/number_as.hpp"
#include "report/diagnosis/diagnosis_text.hpp"
#include "report/diagnosis/effects_table.hpp"
#include "report/figures/text_format.hpp"

namespace farrier::report {
namespace {

using diagnosis::ScaledDiagnosis;
using diagnosis::Verdict;

std::string percent(double value) { return number_as("%.1f %%", value); }

std::string signed_term(double value) { return (value < 0.0 ? " - " : " + ") + short_number(std::abs(value)); }

}  // namespace

std::string equation_text(double gain, double drift, bool linear) {
  return "position+ = position" + signed_term(gain) + (linear ? " valve" : " q(valve)") + signed_term(drift);
}

std::string fit_text(const ScaledDiagnosis& d) {
  return percent(d.fit_before_percent) + " before, " + percent(d.fit_after_percent) + " after";
}

std::vector<std::vector<std::string>> fits_table(const ScaledDiagnosis& d) {
  std::vector<std::vector<std::string>> rows{{"linear", percent(d.fit_before_percent), "", ""}};
  for (const diagnosis::EffectAlone& alone : d.alone) {
    const plant::EffectInfo& info = plant::effect_info(alone.id);
    const ShownEffect::Number number = shown(info.parameters[0], alone.fitted[0], d.scales, Units::kScaled);
    rows.push_back({info.name, percent(alone.fit_percent), number.name + " " + short_number(number.value),
                    alone.accepted ? "accepted" : "rejected"});
  }
  if (d.judgement.effects.size() > 1) {
    rows.push_back({"all that are named", percent(d.fit_after_percent), "", ""});
  }
  return rows;
}

std::vector<std::string> scaled_details(const ScaledResult& result) {
  if (result.diagnosis == nullptr) {
    return findings_text(result.findings);
  }
  const diagnosis::Judgement& judgement = result.diagnosis->judgement;
  std::vector<std::string> lines = alternatives_text(judgement, {});
  if (judgement.verdict == Verdict::kUnknown) {
    const diagnosis::Remainder& left = judgement.left[0];
    lines.push_back("position: " + short_number(left.rms) + " rms are left, where the sensor's noise explains " +
                    short_number(left.expected) + "; NRMSE " + short_number(left.nrmse));
  }
  if (const std::string text = not_judged_text(judgement); !text.empty()) {
    lines.push_back(text);
  }
  return lines;
}

std::string scaled_console(const ScaledResult& result) {
  const ScaledDiagnosis& d = *result.diagnosis;
  std::string text = "recording " + result.recording + " in scaled units\n";
  for (const std::string& remark : d.remarks) {
    text += "note: " + remark + "\n";
  }
  text += "\nlinear model: " + equation_text(d.gain_before, d.drift_before, true) +
          "\n\nfit of the second half, simulated freely, by what was fitted to the first: an effect alone\n" +
          aligned(fits_table(d), "  ") + "\ncause: " + verdict_sentence(d.judgement) + "\n";
  for (const diagnosis::NamedEffect& effect : d.judgement.effects) {
    text += "  " + effect_text(shown(effect, d.scales, Units::kScaled)) + "\n      " +
            plant::effect_info(effect.id).meaning + "\n";
  }
  for (const std::string& line : scaled_details(result)) {
    text += "  " + line + "\n";
  }
  if (!d.judgement.effects.empty()) {
    text += "\nextended model: " + equation_text(d.gain_after, d.drift_after, false) +
            "; no robot file, for nothing here has a unit\nheld-out fit: " + fit_text(d) +
            "\nheld-out NRMSE: " + gain_text(d.error) + "\n";
  }
  return text + "diagnose: " + diagnosis::to_string(result.verdict()) + "\n";
}

}  // namespace farrier::report
