#include "report/compare/noise.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/median.hpp"
#include "report/compare/vary_result.hpp"
#include "report/figures/text_format.hpp"

namespace farrier::report {
namespace {

using OfSeed = double (*)(const RigSeed&);

std::vector<double> values(const NoiseLevel& level, OfSeed of) {
  std::vector<double> all;
  for (const RigSeed& seed : level.rig) {
    all.push_back(infinite_if_lost(of(seed)));
  }
  return all;
}

double worst(const NoiseLevel& level, OfSeed of) { return std::ranges::max(values(level, of)); }

double heavy(const RigSeed& seed) { return seed.linear.heavy; }
double light_ratio(const RigSeed& seed) { return seed.linear.light / seed.true_gains.light; }
double grey_box_heavy(const RigSeed& seed) { return seed.grey_box.heavy; }
double grey_box_light(const RigSeed& seed) { return seed.grey_box.light; }

/// Largest factor by which a number grows from a level to the next better one, among levels up to the robot file's.
template <class Number>
double largest_rise(std::span<const NoiseLevel> levels, Number number) {
  double rise = 0.0;
  for (std::size_t i = 0; i + 1 < levels.size(); ++i) {
    rise = std::max(rise, infinite_if_lost(number(levels[i]) / number(levels[i + 1])));
  }
  return rise;
}

}  // namespace

void add_noise(Figures& figures, std::span<const NoiseLevel> levels) {
  for (const NoiseLevel& level : levels) {
    const auto bound = [&](double value) { return level.factor.value <= 1.0 ? std::optional(value) : std::nullopt; };
    const std::string prefix = "compare.noise." + std::string(level.factor.name) + ".";
    figures.add(prefix + "rig_heavy_worst", worst(level, heavy), bound(kHeavyAtMost));
    figures.add(prefix + "rig_light_ratio_worst", worst(level, light_ratio), bound(kLightRatioAtMost));
    figures.add(prefix + "rig_grey_box_heavy_worst", worst(level, grey_box_heavy));
    figures.add(prefix + "rig_grey_box_light_worst", worst(level, grey_box_light));
    figures.add(prefix + "trot_ratio_perfect", level.trot.linear / level.trot.perfect, bound(kTrotRatioAtMost));
    figures.add(prefix + "trot_grey_box_ratio_perfect", level.trot.grey_box / level.trot.perfect,
                bound(kTrotRatioAtMost));
  }
  const auto rise = [&](const char* name, auto number) {
    figures.add(std::string("compare.noise.rise.") + name, largest_rise(levels, number), kRiseAtMost);
  };
  rise("rig_heavy", [](const NoiseLevel& level) { return median(values(level, heavy)); });
  rise("rig_grey_box_heavy", [](const NoiseLevel& level) { return median(values(level, grey_box_heavy)); });
  rise("trot", [](const NoiseLevel& level) { return level.trot.linear; });
  rise("trot_grey_box", [](const NoiseLevel& level) { return level.trot.grey_box; });
}

std::string noise_text(std::span<const NoiseLevel> levels) {
  std::vector<std::vector<std::string>> rows{{"noise", "rig heavy", "worst", "light", "true", "worst ratio",
                                              "grey box heavy", "light", "trot", "perfect", "grey box"}};
  for (const NoiseLevel& level : levels) {
    const auto middle = [&](OfSeed of) { return short_number(median(values(level, of))); };
    rows.push_back({level.factor.name, middle(heavy), short_number(worst(level, heavy)),
                    middle([](const RigSeed& seed) { return seed.linear.light; }),
                    middle([](const RigSeed& seed) { return seed.true_gains.light; }),
                    short_number(worst(level, light_ratio)), middle(grey_box_heavy), middle(grey_box_light),
                    short_number(level.trot.linear), short_number(level.trot.perfect),
                    short_number(level.trot.grey_box)});
  }
  return aligned(rows);
}

}  // namespace farrier::report
