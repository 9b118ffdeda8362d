#include "report/diagnosis/scaled_page.hpp"

#include <utility>

#include "report/diagnosis/diagnosis_html.hpp"
#include "report/diagnosis/diagnosis_text.hpp"
#include "report/diagnosis/round_pictures.hpp"
#include "report/page/html_page.hpp"
#include "report/page/html_tables.hpp"
#include "report/diagnosis/scaled_text.hpp"

namespace farrier::report {
namespace {

using diagnosis::ScaledDiagnosis;

Picture position_picture(const ScaledDiagnosis& d) {
  constexpr std::size_t kMostPoints = 4000;
  const std::size_t stride = 1 + d.measured.size() / kMostPoints;
  Series measured{.label = "measured"}, before{.label = "linear model", .colour = 2};
  Series after{.label = "with the effects found", .colour = 1};
  const std::pair<Series*, const std::vector<double>*> sources[] = {
      {&measured, &d.measured}, {&before, &d.before}, {&after, &d.after}};
  for (const auto& [series, values] : sources) {
    for (std::size_t i = 0; i < d.measured.size(); i += stride) {
      series->add(static_cast<double>(d.held_out_begin + i), (*values)[i]);
    }
  }
  return {.panels = {{.x_label = "sample",
                      .y_label = "position",
                      .series = {std::move(measured), std::move(before), std::move(after)}}},
          .key = Key::kAbove,
          .height_px = 360.0};
}

struct Pictures {
  std::string position;
  std::vector<std::string> rounds;
};

Result<Pictures> draw_scaled(const std::string& out_dir, const ScaledDiagnosis& d) {
  Drawing drawing(out_dir);
  Pictures pictures{.position = drawing.add("position", position_picture(d)),
                    .rounds = add_round_pictures(drawing, d.judgement)};
  FARRIER_TRY(drawing.draw());
  return pictures;
}

std::string fits_html(const ScaledDiagnosis& d) {
  std::string html =
      "<table><thead><tr><th>model</th><th>fit of the second half</th><th>found</th><th></th></tr>"
      "</thead>\n<tbody>\n";
  for (const auto& row : fits_table(d)) {
    html += "<tr><td>" + escape_html(row[0]) + "</td>" + number_cell(row[1]) + number_cell(row[2]) + "<td>" +
            escape_html(row[3]) + "</td></tr>\n";
  }
  return html + "</tbody></table>\n";
}

std::string body(const ScaledResult& result, const Pictures& pictures) {
  const ScaledDiagnosis& d = *result.diagnosis;
  std::string html = list(d.remarks) + "<h2>What each effect brings</h2>\n" +
                     paragraph("Linear model: " + equation_text(d.gain_before, d.drift_before, true) +
                               ". Fits of the second half, simulated freely, by what was fitted to the first.") +
                     fits_html(d) + captioned_image_html(pictures.position, "the second half, which no fit has seen") +
                     "<h2>The cause</h2>\n" + paragraph(verdict_sentence(d.judgement)) +
                     effects_html(shown_effects(d)) + list(scaled_details(result));
  for (std::size_t i = 0; i < pictures.rounds.size(); ++i) {
    html += captioned_image_html(pictures.rounds[i], round_caption(i));
  }
  if (!d.judgement.effects.empty()) {
    html += "<h2>The gain</h2>\n" +
            paragraph("Extended model: " + equation_text(d.gain_after, d.drift_after, false) + ".") +
            paragraph("Held-out fit: " + fit_text(d) + ".") + paragraph("Held-out NRMSE: " + gain_text(d.error));
  }
  return html;
}

}  // namespace

Result<std::string> write_scaled_page(const std::string& out_dir, const ScaledResult& result, const Outcome& outcome) {
  std::string html =
      page_head("Recording in scaled units: diagnosis", outcome) + paragraph("Recording: " + result.recording);
  if (result.diagnosis == nullptr) {
    html += "<h2>The cause</h2>\n" + list(scaled_details(result));
  } else {
    const auto pictures = FARRIER_TRY(draw_scaled(out_dir, *result.diagnosis));
    html += body(result, pictures);
  }
  return write_page(out_dir, html + page_foot(outcome));
}

}  // namespace farrier::report
