#include "report/diagnosis/diagnosis_page.hpp"

#include <filesystem>

#include "report/diagnosis/diagnosis_html.hpp"
#include "report/diagnosis/diagnosis_pictures.hpp"
#include "report/diagnosis/diagnosis_text.hpp"
#include "report/page/html_page.hpp"
#include "report/page/html_tables.hpp"
#include "report/figures/text_format.hpp"

namespace farrier::report {
namespace {

using diagnosis::ChannelReport;
using diagnosis::Diagnosis;

std::string channels_table(const Diagnosis& d) {
  std::string html =
      "<table><thead><tr><th>channel</th><th>one step</th><th>50 ms ahead</th><th>free running</th>"
      "<th>whiteness</th><th>correlation with the input</th><th>the residual before</th></tr></thead>\n"
      "<tbody>\n";
  const auto change = [](double before, double after) {
    return number_cell(short_number(before) + " → " + short_number(after));
  };
  for (const ChannelReport& c : d.channels) {
    const diagnosis::Dependence* dependence = strongest(c);
    html += "<tr><td>" + escape_html(words_of(c.name)) + "</td>" + change(c.before.one_step, c.after.one_step) +
            change(c.before.ahead_50ms, c.after.ahead_50ms) + change(c.before.free_running, c.after.free_running) +
            change(c.whiteness, c.whiteness_after) + change(c.cross_correlation, c.cross_correlation_after) +
            "<td class=\"meaning\">" + escape_html(dependence == nullptr ? "" : shape_of(*dependence)) + "</td></tr>\n";
  }
  return html + "</tbody></table>\n";
}

std::string where_html(const Diagnosis& d, const DiagnosisPictures& pictures) {
  if (d.channels.empty()) {
    return "";
  }
  std::string html = "<h2>Where the simulation is wrong</h2>\n" +
                     paragraph(
                         "NRMSE on time that no fit has seen: the model as given → the extended model. "
                         "Whiteness below 4 is that of noise.") +
                     channels_table(d);
  for (std::size_t i = 0; i < d.channels.size(); ++i) {
    const std::string name = words_of(d.channels[i].name);
    html +=
        "<h3>" + escape_html(name) + "</h3>\n" +
        captioned_image_html(pictures.channels[i].time,
                             name + ": the second in which the model as given is furthest off") +
        captioned_image_html(pictures.channels[i].dependence,
                             name + ": mean and standard deviation of the residual before, by bins of equal counts") +
        captioned_image_html(pictures.channels[i].spectrum, name + ": spectrum of the residual");
  }
  return html;
}

std::string cause_html(const DiagnosisResult& result, const DiagnosisPictures& pictures) {
  std::vector<ShownEffect> effects;
  for (const diagnosis::NamedEffect& effect : result.diagnosis.judgement.effects) {
    effects.push_back(shown(effect, result.joint));
  }
  std::string html = "<h2>The cause</h2>\n" + paragraph(verdict_sentence(result.diagnosis.judgement)) +
                     effects_html(effects) + list(verdict_details(result));
  for (std::size_t i = 0; i < pictures.rounds.size(); ++i) {
    html += captioned_image_html(pictures.rounds[i], round_caption(i));
  }
  return html;
}

std::string gain_html(const DiagnosisResult& result) {
  const Diagnosis& d = result.diagnosis;
  std::string html;
  if (!result.extended_model.empty()) {
    const std::string file = std::filesystem::path(result.extended_model).filename().string();
    html += "<h2>The extended model</h2>\n<p><a href=\"" + escape_html(file) + "\">" + escape_html(file) +
            "</a>: the robot file with these effects of " + escape_html(result.joint.name) +
            " in its section <code>effects</code>. It was loaded again.</p>\n";
  }
  if (!d.judgement.effects.empty()) {
    html += "<h2>The gain</h2>\n" + paragraph("Held-out NRMSE: " + gain_text(error_of(d)));
  }
  const std::string control = control_text(result);
  return html + (control.empty() ? "" : paragraph(control));
}

}  // namespace

Result<std::string> write_diagnosis_page(const std::string& out_dir, const DiagnosisResult& result,
                                         const Outcome& outcome) {
  const auto pictures = FARRIER_TRY(draw_diagnosis(out_dir, result));
  const std::string html = page_head(result.robot.name + ", joint " + result.joint.name + ": diagnosis", outcome) +
                           paragraph("Recording: " + result.recording) + list(result.diagnosis.remarks) +
                           where_html(result.diagnosis, pictures) + cause_html(result, pictures) + gain_html(result) +
                           page_foot(outcome);
  return write_page(out_dir, html);
}

}  // namespace farrier::report
