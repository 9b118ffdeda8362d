#include "report/page/html_page.hpp"

#include "core/replace_file.hpp"
#include "report/page/html_tables.hpp"
#include "report/figures/text_format.hpp"

namespace farrier::report {
namespace {

constexpr const char* kStyle = R"(
:root { color-scheme: light; }
body { font: 15px/1.45 system-ui, sans-serif; color: #1c2226; background: #fff; }
body { max-width: 1120px; margin: 2rem auto; padding: 0 1rem; }
h1 { font-size: 1.6rem; margin: 0; } h2 { font-size: 1.2rem; margin: 2.2rem 0 .6rem; border-bottom: 1px solid #d8dde1; }
h3 { font-size: 1.05rem; margin: 1.6rem 0 .4rem; }
p.lead { font-size: 1.1rem; }
p.where { color: #56616a; margin: .2rem 0 1rem; }
table { border-collapse: collapse; font-size: .88rem; font-variant-numeric: tabular-nums; }
th, td { text-align: left; vertical-align: top; padding: .22rem .7rem .22rem 0; border-bottom: 1px solid #eceff1; }
thead th { vertical-align: bottom; color: #56616a; font-weight: 600; }
td.number { white-space: nowrap; } td.meaning { color: #56616a; } td small { color: #7b868e; }
td.fails { color: #a63603; font-weight: 700; }
.verdict { display: inline-block; padding: .05rem .6rem; border-radius: .3rem; color: #fff; }
.pass { background: #00704f; } .fail { background: #b03a00; } .warn { background: #8a5a00; }
td.refuted { color: #7a4b9a; font-weight: 600; } td.needs { color: #8a6100; font-weight: 600; } td.holds { color: #00704f; }
tr.fails td { background: #fdf1ea; } tr.refuted td { background: #f7f2fa; } tr.needs td { background: #fdf7e6; }
.box { border-left: 4px solid #d8dde1; background: #f6f8f9; padding: .4rem .8rem; margin: .4rem 0 .8rem; font-size: .9rem; }
ul.reasons { color: #a63603; }
.beside { display: flex; flex-wrap: wrap; gap: .5rem 1rem; align-items: flex-start; }
figure.poles { width: 420px; }
img { max-width: 100%; height: auto; }
pre { background: #f6f8f9; padding: .8rem; overflow-x: auto; font-size: .82rem; }
a { color: #005a8c; } figure { margin: 0; } figcaption { color: #56616a; font-size: .85rem; }
@media print { details { display: block; } h3, img { break-inside: avoid; } }
)";

}  // namespace

std::string page_head(const std::string& plain_title, const Outcome& outcome) {
  return page_head(plain_title, outcome, {outcome.verdict(), outcome.passes() ? Tone::kGood : Tone::kBad});
}

std::string page_head(const std::string& plain_title, const Outcome& outcome, const Badge& badge) {
  const char* const colour = badge.tone == Tone::kGood ? "pass" : badge.tone == Tone::kWarning ? "warn" : "fail";
  const std::string title = escape_html(plain_title);
  std::string html =
      "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n"
      "<meta name=\"viewport\" content=\"width=device-width\">\n<title>" +
      title + "</title>\n<style>" + kStyle + "</style>\n</head>\n<body>\n";
  html += "<h1>" + title + " <span class=\"verdict " + colour + "\">" + escape_html(badge.text) + "</span></h1>\n";
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
  for (const std::string& warning : outcome.warnings) {
    html += "<p>Warning: " + escape_html(warning) + "</p>\n";
  }
  return html;
}

std::string page_foot(const Outcome& outcome) {
  const bool figures = !outcome.figures.all().empty();
  std::string html = figures ? "<h2>Figures</h2>\n" + figures_table_html(outcome.figures) : std::string();
  if (!outcome.run.processes.empty()) {
    html += "<h2>Processes</h2>\n" + processes_table_html(outcome.run);
  }
  html += "<h2>Run</h2>\n" + run_table_html(outcome.run);
  html += "<details><summary>Effective configuration</summary>\n<pre>" + escape_html(outcome.run.configuration) +
          "</pre>\n</details>\n</body>\n</html>\n";
  return html;
}

Result<std::string> write_page(const std::string& out_dir, const std::string& page) {
  const std::string path = out_dir + "/index.html";
  FARRIER_TRY(replace_file(path, page));
  return path;
}

}  // namespace farrier::report
