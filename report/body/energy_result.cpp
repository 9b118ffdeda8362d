#include "report/body/energy_result.hpp"

#include <algorithm>
#include <cmath>

#include "core/median.hpp"
#include "core/number_as.hpp"
#include "core/units.hpp"
#include "report/figures/text_format.hpp"

namespace farrier::report {
namespace energy_result_parts {
namespace {

constexpr double kInPercent = 100.0;
constexpr double kResidual_percent = 1.0;
constexpr double kHalfStep_percent = 5.0;
constexpr std::size_t kKfe = 2;

struct Change {
  const char* name;
  const char* sentence;
  double StepMedians::*median;
};
constexpr std::array kChanges{
    Change{"height_rms", "height rms, mm", &StepMedians::height_rms_mm},
    Change{"tilt_rms", "tilt rms, deg", &StepMedians::tilt_rms_deg},
    Change{"kfe_stance_nrmse", "force NRMSE of kfe in stance", &StepMedians::kfe_stance_nrmse}};

StepMedians medians_of(const std::vector<const trials::TrotFigures*>& runs) {
  const auto median = [&runs](auto of) {
    std::vector<double> values;
    for (const trials::TrotFigures* run : runs) {
      values.push_back(of(*run));
    }
    return farrier::median(values);
  };
  using Run = trials::TrotFigures;
  return {.height_rms_mm = median([](const Run& run) { return 1e3 * run.height_rms_m; }),
          .tilt_rms_deg = median([](const Run& run) { return kDegrees * run.tilt_rms_rad; }),
          .kfe_stance_nrmse =
              median([](const Run& run) { return run.force_nrmse[kKfe][static_cast<std::size_t>(Phase::kStance)]; })};
}

double change_percent(const EnergyResult& result, const Change& change) {
  return kInPercent * std::abs((*result.halved).*change.median / result.nominal.*change.median - 1.0);
}

}  // namespace
}  // namespace energy_result_parts

std::optional<EnergyResult> energy_result(std::span<const trials::TrotRow> rows) {
  using namespace energy_result_parts;
  std::vector<const trials::TrotFigures*> nominal, halved;
  for (const trials::TrotRow& row : rows) {
    if (row.trial == "energy" && row.failure.empty() && row.figures.energy.pump_J > 0.0) {
      (row.figures.finer > 1 ? halved : nominal).push_back(&row.figures);
    }
  }
  if (nominal.empty()) {
    return std::nullopt;
  }
  EnergyResult result;
  result.runs = nominal.size();
  for (const trials::TrotFigures* run : nominal) {
    for (const world::EnergyTerm& term : world::kEnergyTerms) {
      result.mean.*term.energy_J += run->energy.*term.energy_J / static_cast<double>(nominal.size());
    }
    result.residual_percent =
        std::max(result.residual_percent, kInPercent * std::abs(run->energy.residual_J()) / run->energy.pump_J);
  }
  result.nominal = medians_of(nominal);
  if (!halved.empty()) {
    result.halved = medians_of(halved);
  }
  return result;
}

void add_energy(Figures& figures, const EnergyResult& result) {
  using namespace energy_result_parts;
  for (const world::EnergyTerm& term : world::kEnergyTerms) {
    figures.add(std::string("body.energy.") + term.name, result.mean.*term.energy_J);
  }
  figures.add("body.energy.residual_percent", result.residual_percent, kResidual_percent);
  for (const Change& change : kChanges) {
    if (result.halved) {
      figures.add(std::string("body.energy.half_step.") + change.name + "_percent", change_percent(result, change),
                  kHalfStep_percent);
    }
  }
}

std::string energy_text(const EnergyResult& result) {
  using namespace energy_result_parts;
  std::vector<std::vector<std::string>> lines{{"energy, mean of " + std::to_string(result.runs) + " runs", "J", "%"}};
  const auto add = [&](const std::string& name, double energy_J) {
    lines.push_back({name, number_as("%.1f", energy_J), number_as("%.2f", kInPercent * energy_J / result.mean.pump_J)});
  };
  for (const world::EnergyTerm& term : world::kEnergyTerms) {
    add(term.sentence, result.mean.*term.energy_J);
  }
  add("residual", result.mean.residual_J());
  std::string text =
      aligned(lines) + "largest residual of a run: " + number_as("%.3f", result.residual_percent) + " %\n";
  if (result.halved) {
    std::vector<std::vector<std::string>> changes{{"medians", "step", "half the step", "change, %"}};
    for (const Change& change : kChanges) {
      changes.push_back({change.sentence, number_as("%.4f", result.nominal.*change.median),
                         number_as("%.4f", (*result.halved).*change.median),
                         number_as("%.2f", change_percent(result, change))});
    }
    text += aligned(changes);
  }
  return text;
}

}  // namespace farrier::report
