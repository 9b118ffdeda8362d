#include "report/diagnosis/diagnosis_page.hpp"

#include "report/diagnosis/diagnosis_html.hpp"
#include "report/diagnosis/diagnosis_pictures.hpp"
#include "report/diagnosis/diagnosis_summary.hpp"
#include "report/diagnosis/diagnosis_text.hpp"
#include "report/diagnosis/wiring_picture.hpp"
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

std::string meaning_of(diagnosis::Channel channel, bool rotary) {
  const std::string force = rotary ? "torque" : "force";
  switch (channel) {
    case diagnosis::Channel::kForce:
      return "The " + force + " that the actuator makes of the measured current and motion.";
    case diagnosis::Channel::kMotion:
      return "The speed that the load has under the measured " + force + ".";
    case diagnosis::Channel::kVelocitySensor:
      return "The reading of the velocity sensor by the measured position.";
  }
  return "";
}

/// Pictures of a channel. The first of them is enough to see the error.
std::string channel_html(const ChannelReport& channel, const ChannelPictures& pictures, bool rotary) {
  const std::string name = words_of(channel.name);
  return "<h3>" + escape_html(name) + "</h3>\n" + paragraph(meaning_of(channel.channel, rotary)) +
         captioned_image_html(pictures.time, name +
                                                 ": the second in which the model as given is furthest off. The error "
                                                 "should be noise about 0.") +
         captioned_image_html(pictures.dependence,
                              name +
                                  ": error of the model as given over what may drive it, mean and standard deviation. "
                                  "A line that is not flat shows a cause.") +
         captioned_image_html(pictures.spectrum, name + ": the error by frequency");
}

/// True for a channel in which the extended model is better, or in which more than noise is left.
bool shows_something(const Diagnosis& d, const ChannelReport& channel) {
  constexpr double kBetter = 0.95;
  const diagnosis::Remainder& left = d.judgement.left[static_cast<std::size_t>(channel.channel)];
  return channel.after.free_running < kBetter * channel.before.free_running ||
         left.rms > diagnosis::Rules{}.open_ratio * left.expected;
}

std::string evidence_html(const Diagnosis& d, const DiagnosisPictures& pictures, bool rotary) {
  std::string shown, others;
  for (std::size_t i = 0; i < d.channels.size(); ++i) {
    (shows_something(d, d.channels[i]) ? shown : others) += channel_html(d.channels[i], pictures.channels[i], rotary);
  }
  std::string html = "<h2>The evidence</h2>\n";
  html += shown.empty() ? paragraph("The model follows every channel of the recording.") : shown;
  if (!others.empty()) {
    html += "<details><summary>Channels in which nothing is wrong</summary>\n" + others + "</details>\n";
  }
  return html;
}

std::string wiring_evidence_html(const DiagnosisResult& result, const std::string& picture) {
  return "<h2>The evidence</h2>\n" +
         (picture.empty() ? paragraph("No picture: the level of " + result.wiring.front().columns +
                                      " shows this fault, and no law over time does.")
                          : captioned_image_html(picture, wiring_caption(*result.evidence, result.joint)));
}

std::string details_html(const DiagnosisResult& result, const DiagnosisPictures& pictures) {
  std::vector<ShownEffect> effects;
  for (const diagnosis::NamedEffect& effect : result.diagnosis.judgement.effects) {
    effects.push_back(shown(effect, result.joint));
  }
  std::string html = "<h2>Details for the one who made the model</h2>\n" + effects_html(effects) +
                     paragraph(
                         "NRMSE on time that no fit has seen: the model as given → the extended model. "
                         "Whiteness below 4 is that of noise.") +
                     channels_table(result.diagnosis);
  for (std::size_t i = 0; i < pictures.rounds.size(); ++i) {
    html += captioned_image_html(pictures.rounds[i], round_caption(i));
  }
  return html;
}

}  // namespace

Result<std::string> write_diagnosis_page(const std::string& out_dir, const DiagnosisResult& result,
                                         const Outcome& outcome) {
  const auto pictures = FARRIER_TRY(draw_diagnosis(out_dir, result));
  std::string html = page_head(result.robot.name + ", joint " + result.joint.name + ": diagnosis", outcome,
                               badge_of(result.diagnosis.judgement.verdict)) +
                     paragraph("Recording: " + result.recording) + list(result.diagnosis.remarks) +
                     summary_html(result);
  if (!result.diagnosis.channels.empty()) {
    html += evidence_html(result.diagnosis, pictures, result.joint.rotary) + details_html(result, pictures);
  }
  if (!result.wiring.empty()) {
    html += wiring_evidence_html(result, pictures.wiring);
  }
  html += page_foot(outcome);
  return write_page(out_dir, html);
}

}  // namespace farrier::report
