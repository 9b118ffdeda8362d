#include "thesis/report/study_page.hpp"

#include <algorithm>

#include "report/figures/text_format.hpp"
#include "report/page/html_page.hpp"
#include "report/page/html_tables.hpp"
#include "thesis/report/study_pictures.hpp"

namespace farrier::thesis {
namespace {

using report::Claim;
using report::escape_html;

struct VerdictText {
  Verdict verdict;
  const char* meaning;
};

constexpr VerdictText kVerdicts[] = {
    {Verdict::kFails, "Measured otherwise, and we know no proof. Each says what was tried."},
    {Verdict::kNeeds, "Holds only under a condition that the text does not state. Both values are shown."},
    {Verdict::kRefuted,
     "False as printed, by a proof or a counter-example that rests on no choice of ours. The value is where the "
     "proof says."},
    {Verdict::kHolds, "Measured as the text says."}};

struct KindText {
  ClaimKind kind;
  const char* name;
  const char* meaning;
};

constexpr KindText kKinds[] = {
    {ClaimKind::kText, "claims of the text", "A number or a relation that the thesis states."},
    {ClaimKind::kProof, "proofs of ours", "Measurements that show why a claim of the text is as it is."},
    {ClaimKind::kAim, "aims of ours", "Properties that the text wishes for and its own method lacks."}};

std::string number_html(double value, const std::string& unit) {
  return report::short_number(value) + (unit == "1" ? "" : "&nbsp;" + escape_html(unit));
}

/// The median, and the worst of several seeds.
std::string values_html(const Claim& claim) {
  std::string html = number_html(claim.value, claim.unit);
  if (claim.values.size() > 1) {
    html += "<br><small>worst of " + std::to_string(claim.values.size()) + ": " + number_html(claim.worst, claim.unit) +
            "</small>";
  }
  if (claim.condition) {
    html += "<br><small>" + escape_html(claim.condition->name) + ": " +
            number_html(claim.condition->value, claim.unit) + ", worst " +
            number_html(claim.condition->worst, claim.unit) + "</small>";
  }
  return html;
}

std::string small_line(const char* name, const std::string& text) {
  return text.empty() ? "" : "<br><small>" + std::string(name) + escape_html(text) + "</small>";
}

/// The heading of a claim's reason, by its verdict.
const char* name_of_reason(const Claim& claim) {
  if (claim.verdict == to_string(Verdict::kRefuted)) {
    return "Proof: ";
  }
  return claim.verdict == to_string(Verdict::kNeeds) ? "Condition: " : "";
}

std::string claim_row(const Claim& claim) {
  return "<tr class=\"" + claim.verdict + "\"><td class=\"number " + claim.verdict + "\">" + claim.verdict +
         (claim.kind == to_string(ClaimKind::kText) ? "" : "<br><small>" + claim.kind + " of ours</small>") +
         "</td><td>&ldquo;" + escape_html(claim.sentence) + "&rdquo; <small>" + escape_html(claim.section) +
         "</small></td><td>" + escape_html(claim.claim) + small_line(name_of_reason(claim), claim.reason) +
         small_line("Tried: ", claim.tried) + "<br><small>" + escape_html(claim.id) +
         "</small></td><td class=\"number\">" + values_html(claim) + "</td><td class=\"number\">" +
         escape_html(to_string(claim.relation)) + " " + number_html(claim.bound, claim.unit) + "</td></tr>\n";
}

std::string claims_table(const std::vector<const Claim*>& claims) {
  std::string rows;
  for (const Claim* claim : claims) {
    rows += claim_row(*claim);
  }
  return rows.empty() ? ""
                      : "<table><thead><tr><th>verdict</th><th>the text</th><th>what was "
                        "measured</th><th>median</th><th>claimed</th>"
                        "</tr></thead>\n<tbody>\n" +
                            rows + "</tbody></table>\n";
}

/// Claims of a study in the order in which it makes them.
std::vector<const Claim*> in_order_of(const StudyRun& run, const report::Outcome& outcome) {
  std::vector<const Claim*> claims;
  for (const ClaimSpec& spec : run.study.claims) {
    const auto found = std::ranges::find(outcome.claims, spec.id, &Claim::id);
    if (found != outcome.claims.end()) {
      claims.push_back(&*found);
    }
  }
  return claims;
}

std::string figures_html(const StudyRun& run) {
  const StudyResult* result = shown(run);
  if (result == nullptr || result->figures.empty()) {
    return "";
  }
  std::string html =
      "<table><thead><tr><th>figure</th><th>what was measured besides, with the first "
      "seed</th><th>value</th></tr></thead>\n<tbody>\n";
  for (const StudyFigure& figure : result->figures) {
    html += "<tr><td>" + escape_html(figure.id) + "</td><td>" + escape_html(figure.meaning) +
            "</td><td class=\"number\">" + number_html(figure.value, figure.unit) + "</td></tr>\n";
  }
  return html + "</tbody></table>\n";
}

std::string seeds_text(const StudyRun& run) {
  return run.seeds.size() == 1
             ? "One run with seed " + std::to_string(run.seeds.front().seed) + "."
             : std::to_string(run.seeds.size()) + " runs with the seeds " + std::to_string(run.seeds.front().seed) +
                   " to " + std::to_string(run.seeds.back().seed) + "; pictures are of the first.";
}

std::string study_html(const report::Outcome& outcome, const StudyRun& run) {
  const std::string number = escape_html(run.study.number);
  std::string html = "<h2 id=\"s" + number + "\">" + number + " " + escape_html(run.study.title) +
                     "</h2>\n<p class=\"box\">" + escape_html(run.study.conditions) + " " + seeds_text(run) + "</p>\n";
  if (const StudyResult* result = shown(run)) {
    const auto& pictures = result->pictures;
    for (std::size_t i = 0; i < pictures.size(); ++i) {
      html += report::captioned_image_html(picture_path(run.study, i), pictures[i].caption);
    }
  }
  return html + claims_table(in_order_of(run, outcome)) + figures_html(run);
}

template <class Counted>
std::string count_cell(const report::Outcome& outcome, const char* verdict, const Counted& counted) {
  const auto count = std::ranges::count_if(
      outcome.claims, [&](const Claim& claim) { return claim.verdict == verdict && counted(claim); });
  return "<td class=\"number" + (count == 0 ? std::string() : " " + std::string(verdict)) + "\">" +
         std::to_string(count) + "</td>";
}

template <class Counted>
std::string count_cells(const report::Outcome& outcome, const Counted& counted) {
  std::string html;
  for (const VerdictText& one : kVerdicts) {
    html += count_cell(outcome, to_string(one.verdict), counted);
  }
  return html;
}

std::string verdict_heads() {
  std::string html;
  for (const VerdictText& one : kVerdicts) {
    html += "<th>" + std::string(to_string(one.verdict)) + "</th>";
  }
  return html;
}

/// A run is judged by the pinned list, which knows claims that fail.
report::Badge badge_of(const report::Outcome& outcome) {
  return outcome.passes() ? report::Badge{"verdicts as expected", report::Tone::kGood}
                          : report::Badge{"verdicts differ from the list", report::Tone::kBad};
}

/// Claims by kind and verdict, and the meaning of both.
std::string totals_html(const report::Outcome& outcome) {
  std::string html = "<table><thead><tr><th></th>" + verdict_heads() + "<th></th></tr></thead>\n<tbody>\n";
  for (const KindText& kind : kKinds) {
    html += "<tr><td>" + std::string(kind.name) + "</td>" +
            count_cells(outcome, [&](const Claim& claim) { return claim.kind == to_string(kind.kind); }) +
            "<td class=\"meaning\">" + kind.meaning + "</td></tr>\n";
  }
  html += "</tbody></table>\n<p class=\"box\">";
  for (const VerdictText& one : kVerdicts) {
    html += "<b>" + std::string(to_string(one.verdict)) + "</b>: " + one.meaning + "<br>\n";
  }
  return html +
         "A claim is judged by its median over the seeds; the worst value stands below it. Bounds of words without a "
         "number "
         "(&ldquo;slight&rdquo;) are ours and were chosen before measuring.</p>\n";
}

/// The conditions that claims need, with those claims.
std::string conditions_html(const report::Outcome& outcome) {
  std::string rows;
  for (const ConditionSpec& condition : conditions()) {
    std::string claims;
    for (const Claim& claim : outcome.claims) {
      const bool needed =
          claim.condition && claim.condition->name == condition.name && claim.verdict == to_string(Verdict::kNeeds);
      claims += needed ? (claims.empty() ? "" : ", ") + escape_html(claim.id) : "";
    }
    rows += claims.empty()
                ? ""
                : "<tr><td>" + escape_html(condition.name) + "</td><td>" + escape_html(condition.meaning) +
                      "<br><small>" + escape_html(condition.source) + "</small></td><td>" + claims + "</td></tr>\n";
  }
  return rows.empty() ? ""
                      : "<h2>Conditions that the text does not "
                        "state</h2>\n<table><thead><tr><th>condition</th><th></th><th>needed by</th>"
                        "</tr></thead>\n<tbody>\n" +
                            rows + "</tbody></table>\n";
}

std::string failing_html(const report::Outcome& outcome) {
  std::vector<const Claim*> failing;
  for (const Claim& claim : outcome.claims) {
    if (claim.verdict == to_string(Verdict::kFails)) {
      failing.push_back(&claim);
    }
  }
  const std::string table = claims_table(failing);
  return table.empty() ? "" : "<h2>Claims that fail</h2>\n" + table;
}

std::string summary_html(const report::Outcome& outcome, std::span<const StudyRun> runs) {
  std::string html =
      "<h2>Studies</h2>\n<table><thead><tr><th>figure</th><th></th>" + verdict_heads() + "</tr></thead>\n<tbody>\n";
  for (const StudyRun& run : runs) {
    const std::string number = escape_html(run.study.number);
    html += "<tr><td><a href=\"#s" + number + "\">" + number + "</a></td><td>" + escape_html(run.study.title) +
            "</td>" + count_cells(outcome, [&](const Claim& claim) { return claim.figure == run.study.number; }) +
            "</tr>\n";
  }
  return html + "</tbody></table>\n";
}

}  // namespace

Result<std::string> write_study_page(const std::string& out_dir, const report::Outcome& outcome,
                                     std::span<const StudyRun> runs) {
  std::string html = report::page_head("Hubacher (2014), reproduced", outcome, badge_of(outcome)) +
                     totals_html(outcome) + failing_html(outcome) + conditions_html(outcome) +
                     summary_html(outcome, runs);
  for (const StudyRun& run : runs) {
    html += study_html(outcome, run);
  }
  return report::write_page(out_dir, html + report::page_foot(outcome));
}

}  // namespace farrier::thesis
