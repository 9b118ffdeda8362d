#include "report/diagnosis/diagnosis_summary.hpp"

#include <cctype>
#include <cmath>
#include <filesystem>
#include <vector>

#include "report/diagnosis/diagnosis_html.hpp"
#include "report/diagnosis/diagnosis_text.hpp"
#include "report/diagnosis/remedies.hpp"
#include "report/figures/text_format.hpp"
#include "report/page/html_tables.hpp"
#include "robot/joint_scales.hpp"

namespace farrier::report {
namespace {

using diagnosis::Verdict;

std::string sentence(std::string text) {
  if (!text.empty()) {
    text.front() = static_cast<char>(std::toupper(static_cast<unsigned char>(text.front())));
  }
  return text.empty() || text.ends_with('.') ? text : text + ".";
}

std::string cell(const std::string& html) { return "<td>" + html + "</td>"; }

std::string with_unit(double value, const std::string& unit) {
  return short_number(value) + (unit == "1" ? "" : " " + unit);
}

/// The size of an effect with its interval, and the file's value where the file has one.
std::string size_html(const diagnosis::NamedEffect& effect, const ShownEffect& show, const robot::Joint& joint) {
  const ShownEffect::Number& size = show.numbers.front();
  std::string html = escape_html(with_unit(size.value, size.unit)) + "<br><small>" + escape_html(size.name) +
                     ", 95 %: " + escape_html(short_number(show.low) + " to " + short_number(show.high)) + "</small>";
  const plant::Parameter& parameter = plant::effect_info(effect.id).parameters[0];
  const plant::Scales scales = robot::scales_of(joint);
  if (const double neutral = scales.neutral(parameter); neutral > 0.0) {
    html += "<br><small>the robot file has " + escape_html(with_unit(scales.value(parameter, neutral), size.unit)) +
            "</small>";
  }
  return html;
}

std::string sure_html(double confidence, bool alone) {
  return std::string(alone ? confidence_words(confidence) : "one of several") + "<br><small>confidence " +
         escape_html(short_number(std::floor(1000.0 * confidence) / 1000.0)) + "</small>";
}

/// The verdict for the person at the machine.
std::string lead(const DiagnosisResult& result) {
  const diagnosis::Judgement& judgement = result.diagnosis.judgement;
  if (judgement.verdict != Verdict::kEffects) {
    return words_of(verdict_sentence(judgement).c_str());
  }
  std::string names;
  for (std::size_t i = 0; i < judgement.effects.size(); ++i) {
    names += (i == 0                              ? ""
              : i + 1 == judgement.effects.size() ? " and "
                                                  : ", ") +
             words_of(effect_name(judgement.effects[i].id));
  }
  return "Joint " + result.joint.name + " differs from its model by " + names;
}

/// The causes, a row each.
std::string causes_html(const DiagnosisResult& result) {
  const diagnosis::Judgement& judgement = result.diagnosis.judgement;
  if (judgement.effects.empty()) {
    return "";
  }
  std::string html =
      "<table><thead><tr><th>found</th><th>where</th><th>size</th><th>how sure</th><th>look at</th></tr></thead>\n"
      "<tbody>\n";
  const auto row = [&](plant::EffectId id, const std::string& size, const std::string& sure) {
    const Remedy& remedy = remedy_of(id);
    html += "<tr>" +
            cell("<b>" + escape_html(words_of(effect_name(id))) + "</b><br><small>" +
                 escape_html(plant::effect_info(id).meaning) + "</small>") +
            cell(escape_html(remedy.part)) + cell(size) + cell(sure) + cell(escape_html(remedy.check)) + "</tr>\n";
  };
  for (const diagnosis::NamedEffect& effect : judgement.effects) {
    bool alone = true;
    for (const auto& [one, other] : judgement.alternatives) {
      alone = alone && one != effect.id && other != effect.id;
    }
    row(effect.id, size_html(effect, shown(effect, result.joint), result.joint), sure_html(effect.confidence, alone));
    for (const auto& [one, other] : judgement.alternatives) {
      if (one == effect.id) {
        row(other, "<small>instead of " + escape_html(words_of(effect_name(one))) + "</small>", "one of several");
      }
    }
  }
  return html + "</tbody></table>\n";
}

std::string wiring_html(const DiagnosisResult& result) {
  std::string html =
      "<table><thead><tr><th>column</th><th>fault and remedy</th><th>how sure</th></tr></thead>\n<tbody>\n";
  for (std::size_t i = 0; i < result.wiring.size(); ++i) {
    const diagnosis::WiringAnswer& answer = result.wiring[i];
    const std::string text = i < result.findings.size() ? result.findings[i].text : std::string();
    html += "<tr>" + cell("<b>" + escape_html(answer.columns) + "</b>") +
            cell(escape_html(text.substr(0, text.find(" Confidence ")))) + cell(sure_html(answer.confidence, true)) +
            "</tr>\n";
  }
  return html + "</tbody></table>\n";
}

std::vector<std::string> next_steps(const DiagnosisResult& result) {
  const diagnosis::Judgement& judgement = result.diagnosis.judgement;
  std::vector<std::string> steps;
  switch (judgement.verdict) {
    case Verdict::kEffects:
      steps.emplace_back("Check what the table names, the first row first: it explains most.");
      break;
    case Verdict::kNone:
      steps.emplace_back("Nothing needs to be done.");
      break;
    case Verdict::kCannotSeparate:
      for (const std::string& line : alternatives_text(judgement, result.diagnosis.experiments)) {
        steps.push_back(sentence(words_of(line.c_str())));
      }
      steps.emplace_back("Until then, check both: each row is one possible cause.");
      break;
    case Verdict::kUnknown:
      steps.emplace_back(judgement.effects.empty()
                             ? "Look at the pictures of the error below: at which speed, force or position it grows."
                             : "Treat the table as a part of the truth, and look at the pictures of the error below.");
      steps.emplace_back("Inspect the joint by hand and by ear, and record it again with another excitation.");
      break;
    case Verdict::kNotExcited:
      steps.emplace_back("Record again with the whole stroke, both directions and frequencies up to a few tens of Hz.");
      break;
    case Verdict::kBadData:
      steps.emplace_back("Mend the recording, then diagnose it again.");
      break;
    case Verdict::kWiring:
      steps.emplace_back(
          "Mend the first row, record again, and diagnose the new recording. No physical cause was sought.");
      break;
  }
  if (!judgement.effects.empty()) {
    steps.emplace_back(result.model.error
                           ? "If the machine is to stay as it is, use the extended model: controllers then expect it."
                           : "If the machine is to stay as it is, its controllers cannot expect it: " +
                                 model_text(result.model) + ".");
  }
  if (!judgement.effects.empty()) {
    steps.emplace_back("Record again after the repair: the diagnosis should then find nothing.");
  }
  if (const std::string text = not_judged_text(judgement); !text.empty()) {
    steps.push_back(sentence(words_of(text.c_str())) + " For these, record longer, faster and with all sensors.");
  }
  return steps;
}

std::string model_html(const DiagnosisResult& result) {
  const ModelOfDiagnosis& model = result.model;
  std::string html;
  if (!model.path.empty()) {
    const std::string file = escape_html(std::filesystem::path(model.path).filename().string());
    html += "<p>Extended model: <a href=\"" + file + "\">" + file + "</a>, the robot file with these effects of " +
            escape_html(result.joint.name) + ". It was loaded again.</p>\n";
  }
  if (model.error) {
    html += paragraph("Its error on time that no fit has seen, NRMSE: " + gain_text(*model.error) + ".");
  }
  return html + (model.left_out.empty() ? "" : paragraph("It does not have:") + list(model.left_out));
}

}  // namespace

Badge badge_of(Verdict verdict) {
  switch (verdict) {
    case Verdict::kEffects:
      return {"cause found", Tone::kWarning};
    case Verdict::kNone:
      return {"as its file says", Tone::kGood};
    case Verdict::kCannotSeparate:
      return {"several causes possible", Tone::kWarning};
    case Verdict::kUnknown:
      return {"cause unknown", Tone::kWarning};
    case Verdict::kNotExcited:
      return {"too little motion", Tone::kBad};
    case Verdict::kBadData:
      return {"faulty recording", Tone::kBad};
    case Verdict::kWiring:
      return {"wiring fault", Tone::kBad};
  }
  return {"", Tone::kBad};
}

const char* confidence_words(double confidence) noexcept {
  return confidence >= 0.99  ? "almost certain"
         : confidence >= 0.9 ? "likely"
         : confidence >= 0.5 ? "possible"
                             : "doubtful";
}

std::string summary_html(const DiagnosisResult& result) {
  const diagnosis::Judgement& judgement = result.diagnosis.judgement;
  std::string html =
      "<h2>The result</h2>\n<p class=\"lead\">" + escape_html(sentence(lead(result))) + "</p>\n" + causes_html(result);
  if (!result.wiring.empty()) {
    html += wiring_html(result);
  } else if (is_refused(result)) {
    html += list(findings_text(result.findings));
  }
  if (judgement.verdict == Verdict::kUnknown) {
    std::vector<std::string> details = verdict_details(result);
    std::erase(details, not_judged_text(judgement));
    html += list(details);
  }
  html += "<h3>Next steps</h3>\n" + list(next_steps(result)) + model_html(result);
  if (!judgement.effects.empty()) {
    html += paragraph("Error on time that no fit has seen, NRMSE (0: exact, 1: as bad as a constant): " +
                      gain_text(error_of(result.diagnosis)) + ".");
  }
  const std::string control = control_text(result);
  return html + (control.empty() ? "" : paragraph(sentence(words_of(control.c_str()))));
}

}  // namespace farrier::report
