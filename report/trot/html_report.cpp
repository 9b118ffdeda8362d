#include "report/trot/html_report.hpp"

#include "report/page/html_page.hpp"
#include "report/page/html_tables.hpp"
#include "report/trot/pictures.hpp"

namespace farrier::report {
namespace {

std::string joint_section(const robot::Joint& joint, const JointPictures& pictures) {
  const std::string name = escape_html(joint.name);
  std::string html = "<h3 id=\"" + name + "\">" + name + "</h3>\n";
  if (pictures.tracking.empty()) {
    html += "<p>The run ended before its judged part began: nothing to show here.</p>\n";
  }
  html += image_html(pictures.tracking, "force reference, force and error of " + joint.name);
  if (!pictures.gains.empty()) {
    html += "<div class=\"beside\">\n<figure>" + image_html(pictures.gains, "gains of " + joint.name + " over time") +
            "</figure>\n<figure class=\"poles\">" +
            image_html(pictures.estimates, "poles of the estimates of " + joint.name) + "</figure>\n</div>\n";
  }
  const bool compliant = joint.form == control::Form::kCompliant;
  html += "<div class=\"beside\">\n<figure>" +
          image_html(pictures.overview, "reference and error of " + joint.name + " over the whole run") +
          "</figure>\n<figure class=\"poles\">" + image_html(pictures.poles, "closed-loop poles of " + joint.name) +
          "<figcaption>" +
          (compliant ? "The joint is free to move: without a load spring its position is the pole at 1." : "") +
          "</figcaption></figure>\n</div>\n";
  return html;
}

std::string page(const ReportInput& input, const std::vector<JointPictures>& pictures) {
  const Outcome& outcome = input.outcome;
  std::string html = page_head(input.robot.name + ": " + outcome.command, outcome);
  html += "<h2>Joints</h2>\n" + joint_table_html(outcome.figures);
  html += "<h2>Tracking</h2>\n";
  for (const robot::Joint& joint : input.robot.joints) {
    html += joint_section(joint, pictures[joint.number]);
  }
  html += decisions_html(outcome.run);
  html += page_foot(outcome);
  return html;
}

}  // namespace

Result<std::string> write_report(const std::string& out_dir, const ReportInput& input) {
  const auto pictures = FARRIER_TRY(draw_pictures(out_dir, input));
  return write_page(out_dir, page(input, pictures));
}

}  // namespace farrier::report
