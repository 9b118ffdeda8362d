#include "report/compare/models.hpp"

#include <algorithm>

#include "report/figures/text_format.hpp"

namespace farrier::report {

void add_models(Figures& figures, std::span<const ModelRow> rows) {
  for (const ModelRow& row : rows) {
    std::string load = row.load_kg;
    std::ranges::replace(load, '.', '_');
    const std::string prefix = "compare.models.load_" + load + "_kg." + row.form + ".";
    figures.add(prefix + "resonance_Hz", row.resonance_Hz);
    figures.add(prefix + "position_gain", row.position_gain);
    figures.add(prefix + "velocity_gain", row.velocity_gain);
    figures.add(prefix + "force_gain", row.force_gain);
    figures.add(prefix + "disk_margin", row.disk_margin);
  }
}

std::string models_text(std::span<const ModelRow> rows) {
  std::vector<std::vector<std::string>> cells{
      {"load (kg)", "model", "resonance (Hz)", "position gain", "velocity gain", "force gain", "disk margin"}};
  for (const ModelRow& row : rows) {
    cells.push_back({row.load_kg, row.form, short_number(row.resonance_Hz), short_number(row.position_gain),
                     short_number(row.velocity_gain), short_number(row.force_gain), short_number(row.disk_margin)});
  }
  return aligned(cells);
}

}  // namespace farrier::report
