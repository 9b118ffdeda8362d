#include "report/diagnosis/round_pictures.hpp"

#include <algorithm>
#include <utility>

namespace farrier::report {
namespace {

Picture round_picture(std::vector<diagnosis::Candidate> candidates) {
  std::ranges::sort(candidates, {}, [](const diagnosis::Candidate& one) { return one.gain.log_ratio; });
  Panel panel{.x_label = "ln of held-out error before over after, with its 95 % interval"};
  Series accepted{.style = Style::kBars, .colour = 1}, others{.style = Style::kBars, .colour = 5};
  for (const diagnosis::Candidate& one : candidates) {
    Series& bars = one.accepted ? accepted : others;
    bars.add(one.gain.log_ratio, static_cast<double>(panel.rows.size()));
    bars.low.push_back(one.gain.low);
    bars.high.push_back(one.gain.high);
    panel.rows.emplace_back(plant::effect_info(one.id).name);
  }
  panel.series = {std::move(accepted), std::move(others)};
  return {.panels = {std::move(panel)},
          .width_px = 720.0,
          .height_px = 100.0 + 22.0 * static_cast<double>(candidates.size())};
}

}  // namespace

std::vector<std::string> add_round_pictures(Drawing& drawing, const diagnosis::Judgement& judgement) {
  std::vector<std::string> paths;
  for (const auto& round : judgement.rounds) {
    if (!round.empty()) {
      paths.push_back(drawing.add("round_" + std::to_string(paths.size() + 1), round_picture(round)));
    }
  }
  return paths;
}

}  // namespace farrier::report
