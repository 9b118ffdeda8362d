#include "report/diagnosis/effects_table.hpp"

#include <string_view>

#include "plant/terms/term_text.hpp"
#include "report/figures/text_format.hpp"

namespace farrier::report {
namespace {

std::string both(std::string_view linear, std::string_view rotary, std::string_view quote) {
  const std::string one = std::string(quote) + std::string(linear) + std::string(quote);
  return linear == rotary ? one : one + ", " + std::string(quote) + std::string(rotary) + std::string(quote);
}

std::string range_text(const plant::Parameter& p) {
  const plant::ParameterRange ends = p.multiples();
  const std::string_view scale = plant::text_of(p.scale).name;
  return short_number(ends.low) + " to " + short_number(ends.high) +
         (scale.empty() ? "" : " times " + std::string(scale));
}

}  // namespace

std::string effects_table_markdown() {
  std::string table = "| effect | place | parameter | unit | range | meaning |\n|---|---|---|---|---|---|\n";
  for (plant::EffectId id = 0; id < plant::kNameableCount; ++id) {
    const plant::EffectInfo& info = plant::effect_info(id);
    for (const plant::Parameter& p : info.parameters) {
      const bool first = &p == info.parameters.data();
      table += "| " + (first ? "`" + std::string(info.name) + "`" : std::string()) + " | " +
               (first ? plant::text_of(info.side).name : "") + " | " + both(p.name, p.rotary_name, "`") + " | " +
               both(p.unit, p.rotary_unit, "") + " | " + range_text(p) + " | " +
               (first ? std::string(info.meaning) + " " : std::string()) + p.meaning + " |\n";
    }
  }
  return table;
}

}  // namespace farrier::report
