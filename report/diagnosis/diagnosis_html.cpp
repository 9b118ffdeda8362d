#include "report/diagnosis/diagnosis_html.hpp"

#include "report/diagnosis/effects_table.hpp"
#include "report/page/html_tables.hpp"
#include "report/figures/text_format.hpp"

namespace farrier::report {

std::string paragraph(const std::string& text) { return "<p>" + escape_html(text) + "</p>\n"; }

std::string list(const std::vector<std::string>& items) {
  std::string html;
  for (const std::string& item : items) {
    html += "<li>" + escape_html(item) + "</li>\n";
  }
  return html.empty() ? "" : "<ul>\n" + html + "</ul>\n";
}

std::string number_cell(const std::string& text) { return "<td class=\"number\">" + escape_html(text) + "</td>"; }

std::string effects_html(std::span<const ShownEffect> effects) {
  std::string html;
  for (const ShownEffect& effect : effects) {
    for (const ShownEffect::Number& number : effect.numbers) {
      const bool first = &number == effect.numbers.data();
      const std::string unit = number.unit == "1" ? "" : " " + number.unit;
      html += "<tr><td>" + (first ? escape_html(effect.info->name) : std::string()) + "</td><td>" +
              escape_html(number.name) + "</td>" + number_cell(short_number(number.value) + unit) +
              number_cell(first ? short_number(effect.low) + " to " + short_number(effect.high) : "") +
              number_cell(first ? short_number(effect.confidence) : "") +
              number_cell(first ? short_number(effect.share) : "") + "<td class=\"meaning\">" +
              (first ? escape_html(effect.info->meaning) : std::string()) + "</td></tr>\n";
    }
  }
  return html.empty() ? ""
                      : "<table><thead><tr><th>effect</th><th>parameter</th><th>value</th><th>95 % interval</th>"
                        "<th>confidence</th><th>share of the gain</th><th></th></tr></thead>\n<tbody>\n" +
                            html + "</tbody></table>\n";
}

std::string round_caption(std::size_t round) {
  return "round " + std::to_string(round + 1) +
         ": what each effect would bring beside those found before; dark: accepted";
}

}  // namespace farrier::report
