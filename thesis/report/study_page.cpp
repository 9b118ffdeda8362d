#include "thesis/report/study_page.hpp"

#include <algorithm>

#include "report/page/html_page.hpp"
#include "report/page/html_tables.hpp"
#include "report/figures/text_format.hpp"
#include "thesis/report/study_pictures.hpp"

namespace farrier::thesis {
namespace {

using report::Claim;
using report::escape_html;

std::string number_html(double value, const std::string& unit) {
  return report::short_number(value) + (unit == "1" ? "" : "&nbsp;" + escape_html(unit));
}

std::string verdict_cell(const Claim& claim) {
  return "<td class=\"number" + std::string(claim.verdict == to_string(thesis::Verdict::kFails) ? " fails" : "") +
         "\">" + claim.verdict + "</td>";
}

std::string claim_rows(const report::Outcome& outcome, const char* number) {
  std::string html;
  for (const Claim& claim : outcome.claims) {
    if (claim.figure != number) {
      continue;
    }
    html += "<tr>" + verdict_cell(claim) + "<td>&ldquo;" + escape_html(claim.sentence) + "&rdquo; <small>" +
            escape_html(claim.section) + "</small></td><td>" + escape_html(claim.claim) +
            (claim.reason.empty() ? "" : "<br><small>" + escape_html(claim.reason) + "</small>") +
            "</td><td class=\"number\">" + number_html(claim.value, claim.unit) + "</td><td class=\"number\">" +
            escape_html(to_string(claim.relation)) + " " + number_html(claim.bound, claim.unit) + "</td></tr>\n";
  }
  return html;
}

std::string figures_html(const StudyRun& run) {
  const StudyResult* result = shown(run);
  if (result == nullptr || result->figures.empty()) {
    return "";
  }
  std::string html =
      "<table><thead><tr><th>figure</th><th>what was measured besides</th><th>value</th></tr></thead>\n<tbody>\n";
  for (const thesis::StudyFigure& figure : result->figures) {
    html += "<tr><td>" + escape_html(figure.id) + "</td><td>" + escape_html(figure.meaning) +
            "</td><td class=\"number\">" + number_html(figure.value, figure.unit) + "</td></tr>\n";
  }
  return html + "</tbody></table>\n";
}

std::string study_html(const report::Outcome& outcome, const StudyRun& run) {
  const std::string number = escape_html(run.study.number);
  std::string html = "<h2 id=\"s" + number + "\">" + number + " " + escape_html(run.study.title) + "</h2>\n";
  if (const StudyResult* result = shown(run)) {
    const auto& pictures = result->pictures;
    for (std::size_t i = 0; i < pictures.size(); ++i) {
      html += report::captioned_image_html(picture_path(run.study, i), pictures[i].caption);
    }
  }
  return html +
         "<table><thead><tr><th>verdict</th><th>the text</th><th>what was measured</th><th>value</th><th>claimed</th>"
         "</tr></thead>\n<tbody>\n" +
         claim_rows(outcome, run.study.number) + "</tbody></table>\n" + figures_html(run);
}

std::string summary_html(const report::Outcome& outcome, std::span<const StudyRun> runs) {
  std::string html =
      "<table><thead><tr><th>figure</th><th></th><th>holds</th><th>refuted</th><th>fails</th></tr></thead>\n"
      "<tbody>\n";
  for (const StudyRun& run : runs) {
    const auto count = [&](thesis::Verdict verdict) {
      return std::to_string(std::ranges::count_if(outcome.claims, [&](const Claim& claim) {
        return claim.figure == run.study.number && claim.verdict == to_string(verdict);
      }));
    };
    const std::string number = escape_html(run.study.number);
    html += "<tr><td><a href=\"#s" + number + "\">" + number + "</a></td><td>" + escape_html(run.study.title) +
            "</td><td class=\"number\">" + count(thesis::Verdict::kHolds) + "</td><td class=\"number\">" +
            count(thesis::Verdict::kRefuted) + "</td><td class=\"number\">" + count(thesis::Verdict::kFails) +
            "</td></tr>\n";
  }
  return html + "</tbody></table>\n";
}

}  // namespace

Result<std::string> write_study_page(const std::string& out_dir, const report::Outcome& outcome,
                                     std::span<const StudyRun> runs) {
  std::string html = report::page_head("Hubacher (2014), reproduced", outcome) + summary_html(outcome, runs);
  for (const StudyRun& run : runs) {
    html += study_html(outcome, run);
  }
  return report::write_page(out_dir, html + report::page_foot(outcome));
}

}  // namespace farrier::thesis
