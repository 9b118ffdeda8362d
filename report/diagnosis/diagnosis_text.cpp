#include "report/diagnosis/diagnosis_text.hpp"

#include <algorithm>
#include <cmath>
#include <filesystem>

#include "report/diagnosis/effects_table.hpp"
#include "report/figures/text_format.hpp"

namespace farrier::report {
namespace {

using diagnosis::ChannelReport;
using diagnosis::Diagnosis;
using diagnosis::Verdict;

std::string joined(const std::vector<std::string>& words) {
  std::string text;
  for (std::size_t i = 0; i < words.size(); ++i) {
    text += (i == 0 ? "" : i + 1 == words.size() ? " and " : ", ") + words[i];
  }
  return text;
}

template <class Items, class Name>
std::string listed(const Items& items, Name name) {
  std::vector<std::string> words;
  for (const auto& item : items) {
    words.emplace_back(name(item));
  }
  return joined(words);
}

/// Where the residual's power beyond 0 Hz is largest.
double peak_Hz(const ChannelReport& channel) {
  double best = 0.0;
  double at = 0.0;
  for (std::size_t i = 0; i < std::min(channel.frequency_Hz.size(), channel.spectrum_after.size()); ++i) {
    if (channel.frequency_Hz[i] > 0.0 && channel.spectrum_after[i] > best) {
      best = channel.spectrum_after[i];
      at = channel.frequency_Hz[i];
    }
  }
  return at;
}

std::vector<std::string> remainders(const DiagnosisResult& result) {
  const Diagnosis& diagnosis = result.diagnosis;
  std::vector<std::string> lines;
  for (const ChannelReport& channel : diagnosis.channels) {
    const diagnosis::Remainder& left = diagnosis.judgement.left[static_cast<std::size_t>(channel.channel)];
    if (!(left.rms > diagnosis::Rules{}.open_ratio * left.expected)) {
      continue;
    }
    std::string line = words_of(channel.name) + ": " + short_number(left.rms) + " " +
                       unit_of(channel.channel, result.joint) + " rms are left, where the sensors' noise explains " +
                       short_number(left.expected) + "; NRMSE " + short_number(left.nrmse);
    if (const double at = peak_Hz(channel); at > 0.0) {
      line += "; strongest at " + short_number(at) + " Hz";
    }
    const diagnosis::Dependence* dependence = strongest(channel);
    const std::string shape = dependence == nullptr ? "" : shape_of(*dependence);
    if (!shape.empty()) {
      line += "; before any effect the residual " + shape + ", which explains " +
              short_number(std::round(100.0 * dependence->explained)) + " % of it";
    }
    lines.push_back(line);
  }
  return lines;
}

}  // namespace

const char* effect_name(plant::EffectId id) noexcept { return plant::effect_info(id).name; }

std::string experiment_text(const diagnosis::Experiment& experiment) {
  const bool electric = experiment.amplitude_Nm > 0.0;
  if (!experiment.tells()) {
    return no_experiment_text() +
           (experiment.difference > 0.0
                ? ": they differ by " + short_number(experiment.difference) + " times a sensor's noise at most"
                : "");
  }
  const std::string size =
      electric ? short_number(experiment.amplitude_Nm) + " Nm (" + short_number(experiment.amplitude_A) + " A)"
               : short_number(1e3 * experiment.amplitude_A) + " mA";
  const std::string start = electric ? "beside a hold amid the travel of " + short_number(experiment.hold.stiffness) +
                                           " Nm/rad and " + short_number(experiment.hold.damping) + " Nms/rad"
                                     : "from mid-stroke";
  return (experiment.excitation == "sine" ? "a sine of the " : "steps of the ") +
         std::string(electric ? "commanded torque" : "current") +
         (experiment.excitation == "sine" ? " of " : " of plus and minus ") + size + " at " +
         short_number(experiment.frequency_Hz) + " Hz for " + short_number(experiment.duration_s) + " s, " + start +
         ": they differ by " + short_number(experiment.difference) + " times a sensor's noise";
}

std::string no_experiment_text() { return "no sine and no steps of the current that were tried would"; }

std::string words_of(const char* name) {
  std::string words = name;
  std::ranges::replace(words, '_', ' ');
  return words;
}

std::string verdict_sentence(const diagnosis::Judgement& judgement) {
  const std::string found =
      listed(judgement.effects, [](const diagnosis::NamedEffect& effect) { return effect_name(effect.id); });
  switch (judgement.verdict) {
    case Verdict::kEffects:
      return "the model lacks " + found;
    case Verdict::kNone:
      return "the model explains this recording: nothing is missing that its sensors could show";
    case Verdict::kCannotSeparate: {
      std::vector<std::string> pairs;
      for (const auto& [one, other] : judgement.alternatives) {
        pairs.push_back(std::string(effect_name(one)) + " or " + effect_name(other));
      }
      return "something is missing, but this recording cannot separate its causes: " + joined(pairs);
    }
    case Verdict::kUnknown:
      return "the model is wrong in a way that no known effect explains" +
             (found.empty() ? "" : "; " + found + " explains a part");
    case Verdict::kNotExcited:
      return "the recording moves too little to judge the model by";
    case Verdict::kBadData:
      return "the data cannot be judged: mend the recording first";
    case Verdict::kWiring:
      return "the channels contradict each other as no joint can: mend the wiring first";
  }
  return "";
}

std::vector<std::string> alternatives_text(const diagnosis::Judgement& judgement,
                                           std::span<const diagnosis::Experiment> experiments) {
  std::vector<std::string> lines;
  for (const auto& [one, other] : judgement.alternatives) {
    const auto found = std::ranges::find_if(experiments, [&one = one, &other = other](const auto& experiment) {
      return (experiment.one == one && experiment.other == other) ||
             (experiment.one == other && experiment.other == one);
    });
    lines.push_back(std::string("this recording does not tell ") + effect_name(one) + " from " + effect_name(other) +
                    (found == experiments.end() ? ""
                     : found->tells()           ? "; what would: " + experiment_text(*found)
                                                : "; " + experiment_text(*found)));
  }
  return lines;
}

std::vector<std::string> findings_text(std::span<const diagnosis::Finding> findings) {
  std::vector<std::string> lines;
  for (const diagnosis::Finding& finding : findings) {
    lines.push_back((finding.row == 0 ? "" : "row " + std::to_string(finding.row) + ": ") + finding.text + " (" +
                    finding.what + ")");
  }
  return lines;
}

std::string not_judged_text(const diagnosis::Judgement& judgement) {
  return judgement.not_judged.empty() ? ""
                                      : "this recording could not show: " + listed(judgement.not_judged, effect_name);
}

std::vector<std::string> verdict_details(const DiagnosisResult& result) {
  const Diagnosis& d = result.diagnosis;
  std::vector<std::string> lines;
  switch (d.judgement.verdict) {
    case Verdict::kEffects:
      lines = d.judgement.unexplained ? remainders(result) : lines;
      break;
    case Verdict::kNone:
      break;
    case Verdict::kNotExcited:
      lines.emplace_back("record again with the whole stroke, both directions and frequencies up to a few tens of Hz");
      break;
    case Verdict::kCannotSeparate:
      lines = alternatives_text(d.judgement, d.experiments);
      break;
    case Verdict::kUnknown:
      lines = remainders(result);
      break;
    case Verdict::kBadData:
    case Verdict::kWiring:
      lines = findings_text(result.findings);
      break;
  }
  if (const std::string text = not_judged_text(d.judgement); !text.empty()) {
    lines.push_back(text);
  }
  return lines;
}

std::string effect_text(const ShownEffect& effect) {
  const auto with_unit = [](const ShownEffect::Number& number) {
    return number.name + " " + short_number(number.value) + (number.unit == "1" ? "" : " " + number.unit);
  };
  std::string text = std::string(effect.info->name) + ": " + with_unit(effect.numbers[0]) +
                     " (95 %: " + short_number(effect.low) + " to " + short_number(effect.high) + ")";
  for (std::size_t i = 1; i < effect.numbers.size(); ++i) {
    text += ", " + with_unit(effect.numbers[i]);
  }
  return text + ", confidence " + short_number(effect.confidence) + ", " +
         short_number(std::round(100.0 * effect.share)) + " % of the gain";
}

std::string gain_text(const diagnosis::ErrorRatio& error) {
  return short_number(error.before) + " before, " + short_number(error.after) + " after: the error is divided by " +
         short_number(error.before / error.after) + " (95 %: " + short_number(error.low) + " to " +
         short_number(error.high) + ")";
}

std::string model_text(const ModelOfDiagnosis& model) {
  return !model.path.empty() ? model.path + ", which loads"
         : model.error       ? "not written: give --out"
                             : "none: a robot file has no place for the effects found";
}

std::string control_text(const DiagnosisResult& result) {
  return result.control ? "force control that knows " + result.control->effect + ": NRMSE " +
                              short_number(result.control->old_nrmse) + " before, " +
                              short_number(result.control->new_nrmse) + " after"
                        : "";
}

std::string diagnosis_console(const DiagnosisResult& result) {
  const Diagnosis& d = result.diagnosis;
  std::string text =
      "joint " + result.joint.name + " of " + result.robot.name + ", recording " + result.recording + "\n";
  for (const std::string& remark : d.remarks) {
    text += "note: " + remark + "\n";
  }
  if (!d.channels.empty()) {
    std::vector<std::vector<std::string>> rows{
        {"", "one step", "50 ms ahead", "free running", "whiteness", "correlation", "the residual before"}};
    const auto change = [](double before, double after) { return short_number(before) + " -> " + short_number(after); };
    for (const ChannelReport& c : d.channels) {
      const diagnosis::Dependence* dependence = strongest(c);
      rows.push_back({words_of(c.name), change(c.before.one_step, c.after.one_step),
                      change(c.before.ahead_50ms, c.after.ahead_50ms),
                      change(c.before.free_running, c.after.free_running), change(c.whiteness, c.whiteness_after),
                      change(c.cross_correlation, c.cross_correlation_after),
                      dependence == nullptr ? "" : shape_of(*dependence)});
    }
    text += "\nwhere the simulation is wrong: NRMSE, the model as given -> the extended one\n" + aligned(rows, "  ") +
            "  whiteness below " + short_number(kWhite) + " is that of noise\n";
  }
  text += "\ncause: " + verdict_sentence(d.judgement) + "\n";
  for (const diagnosis::NamedEffect& effect : d.judgement.effects) {
    text += "  " + effect_text(shown(effect, result.joint)) + "\n      " + plant::effect_info(effect.id).meaning + "\n";
  }
  for (const std::string& line : verdict_details(result)) {
    text += "  " + line + "\n";
  }
  if (!d.judgement.effects.empty()) {
    text += "\nextended model: " + model_text(result.model) + "\n";
    for (const std::string& line : result.model.left_out) {
      text += "  without " + line + "\n";
    }
    text += "held-out NRMSE: " + gain_text(error_of(d)) + "\n";
    if (result.model.error) {
      text += "held-out NRMSE of the extended model: " + gain_text(*result.model.error) + "\n";
    }
  }
  if (const std::string control = control_text(result); !control.empty()) {
    text += control + "\n";
  }
  return text + "diagnose: " + diagnosis::to_string(d.judgement.verdict) + "\n";
}

}  // namespace farrier::report
