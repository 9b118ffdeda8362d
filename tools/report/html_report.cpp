#include "tools/report/html_report.hpp"

#include <cerrno>
#include <cstring>
#include <fstream>

#include "tools/report/html_tables.hpp"
#include "tools/report/pictures.hpp"
#include "tools/report/text_format.hpp"

namespace farrier::report {
namespace {

constexpr const char* kStyle = R"(
:root { color-scheme: light; }
body { font: 15px/1.45 system-ui, sans-serif; color: #1c2226; background: #fff; }
body { max-width: 1120px; margin: 2rem auto; padding: 0 1rem; }
h1 { font-size: 1.6rem; margin: 0; } h2 { font-size: 1.2rem; margin: 2.2rem 0 .6rem; border-bottom: 1px solid #d8dde1; }
h3 { font-size: 1.05rem; margin: 1.6rem 0 .4rem; }
p.where { color: #56616a; margin: .2rem 0 1rem; }
table { border-collapse: collapse; font-size: .88rem; font-variant-numeric: tabular-nums; }
th, td { text-align: left; vertical-align: top; padding: .22rem .7rem .22rem 0; border-bottom: 1px solid #eceff1; }
thead th { vertical-align: bottom; color: #56616a; font-weight: 600; }
td.number { white-space: nowrap; } td.meaning { color: #56616a; } td small { color: #7b868e; }
td.fails { color: #a63603; font-weight: 700; }
.verdict { display: inline-block; padding: .05rem .6rem; border-radius: .3rem; color: #fff; }
.pass { background: #00704f; } .fail { background: #b03a00; }
ul.reasons { color: #a63603; }
.beside { display: flex; flex-wrap: wrap; gap: .5rem 1rem; align-items: flex-start; }
figure.poles { width: 420px; }
img { max-width: 100%; height: auto; }
pre { background: #f6f8f9; padding: .8rem; overflow-x: auto; font-size: .82rem; }
a { color: #005a8c; } figure { margin: 0; } figcaption { color: #56616a; font-size: .85rem; }
@media print { details { display: block; } h3, img { break-inside: avoid; } }
)";

std::string picture(const std::string& path, const std::string& what) {
  return path.empty() ? ""
                      : "<img src=\"" + escape_html(path) + "\" alt=\"" + escape_html(what) + "\">\n";
}

std::string joint_section(const robot::Joint& joint, const JointPictures& pictures) {
  const std::string name = escape_html(joint.name);
  std::string html = "<h3 id=\"" + name + "\">" + name + "</h3>\n";
  if (pictures.tracking.empty()) {
    html += "<p>The run ended before its judged part began: nothing to show here.</p>\n";
  }
  html += picture(pictures.tracking, "force reference, force and error of " + joint.name);
  const bool compliant = joint.form == control::Form::kCompliant;
  html += "<div class=\"beside\">\n<figure>" +
          picture(pictures.overview, "reference and error of " + joint.name + " over the whole run") +
          "</figure>\n<figure class=\"poles\">" + picture(pictures.poles, "closed-loop poles of " + joint.name) +
          "<figcaption>" +
          (compliant ? "The joint is free to move: without a load spring its position is the pole at 1." : "") +
          "</figcaption></figure>\n</div>\n";
  return html;
}

std::string page(const ReportInput& input, const std::vector<JointPictures>& pictures) {
  const Outcome& outcome = input.outcome;
  const char* verdict = outcome.passes() ? "pass" : "fail";
  const std::string title = escape_html(input.robot.name) + ": " + escape_html(outcome.command);
  std::string html = "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n"
                     "<meta name=\"viewport\" content=\"width=device-width\">\n<title>" +
                     title + "</title>\n<style>" + kStyle + "</style>\n</head>\n<body>\n";
  html += "<h1>" + title + " <span class=\"verdict " + verdict + "\">" + verdict + "</span></h1>\n";
  html += "<p class=\"where\">Farrier " + escape_html(outcome.run.version) + ", revision " +
          escape_html(outcome.run.git_revision) + ", seed " + std::to_string(outcome.run.seed) + "</p>\n";
  const std::vector<std::string> reasons = reasons_to_fail(outcome.figures, outcome.failures);
  if (!reasons.empty()) {
    html += "<ul class=\"reasons\">\n";
    for (const std::string& reason : reasons) {
      html += "<li>" + escape_html(reason) + "</li>\n";
    }
    html += "</ul>\n";
  }
  html += "<h2>Joints</h2>\n" + joint_table_html(outcome.figures);
  html += "<h2>Tracking</h2>\n";
  for (const robot::Joint& joint : input.robot.joints) {
    html += joint_section(joint, pictures[joint.number]);
  }
  html += "<h2>Figures</h2>\n" + figures_table_html(outcome.figures);
  html += "<h2>Processes</h2>\n" + processes_table_html(outcome.run);
  html += "<h2>Run</h2>\n" + run_table_html(outcome.run);
  html += "<details><summary>Effective configuration</summary>\n<pre>" + escape_html(outcome.run.configuration) +
          "</pre>\n</details>\n</body>\n</html>\n";
  return html;
}

}  // namespace

Result<std::string> write_report(const std::string& out_dir, const ReportInput& input) {
  const auto pictures =
      draw_pictures(out_dir, input.robot, input.schedule, input.rows, input.loop_delay_ticks);
  if (!pictures) {
    return pictures.error();
  }
  const std::string path = out_dir + "/index.html";
  std::ofstream file(path);
  file << page(input, pictures.value()) << std::flush;
  if (!file) {
    return Error{"cannot write the report " + path + ": " + std::strerror(errno)};
  }
  return path;
}

}  // namespace farrier::report
