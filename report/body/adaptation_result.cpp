#include "report/body/adaptation_result.hpp"

#include <algorithm>
#include <cmath>
#include <map>

#include "core/median.hpp"
#include "core/wilson.hpp"
#include "report/figures/text_format.hpp"

namespace farrier::report {
namespace {

constexpr double kHeightInMm = 1000.0;
constexpr double kPercentOfShare = 100.0;

/// Runs of one design, by the text of their seed.
using BySeed = std::map<std::string, const trials::TrotRow*>;

AdaptationCell cell_of(const std::string& design, const BySeed& runs) {
  AdaptationCell cell{.design = design};
  std::vector<const trials::TrotFigures*> walked;
  for (const auto& [seed, run] : runs) {
    ++cell.runs;
    if (trials::is_lost(*run)) {
      ++cell.falls;
    } else {
      walked.push_back(&run->figures);
    }
  }
  const auto median_of = [&walked](const auto& figure) {
    std::vector<double> values;
    std::ranges::transform(walked, std::back_inserter(values), [&](const auto* figures) { return figure(*figures); });
    return median_or_zero(std::move(values));
  };
  cell.stance_nrmse = median_of([](const auto& f) { return trials::stance_nrmse(f.force_nrmse); });
  cell.height_rms_m = median_of([](const auto& f) { return f.height_rms_m; });
  cell.speed_error = median_of([](const auto& f) { return f.speed_error; });
  cell.energy_J_m = median_of([](const auto& f) { return f.way_m > 0.0 ? f.energy.pump_J / f.way_m : 0.0; });
  return cell;
}

/// Seeds with which one design walks and the other falls.
int lost_seeds(const BySeed& walks, const BySeed& falls) {
  int lost = 0;
  for (const auto& [seed, run] : walks) {
    const auto other = falls.find(seed);
    lost += other != falls.end() && !trials::is_lost(*run) && trials::is_lost(*other->second) ? 1 : 0;
  }
  return lost;
}

const AdaptationCell* cell(const AdaptationRow& row, const char* design) {
  const auto found = std::ranges::find(row.cells, design, &AdaptationCell::design);
  return found == row.cells.end() || found->stance_nrmse == 0.0 ? nullptr : &*found;
}

std::optional<double> ratio_of(const AdaptationRow& row, const char* design) {
  const AdaptationCell* one = cell(row, design);
  const AdaptationCell* perfect = cell(row, trials::kPerfect);
  return one != nullptr && perfect != nullptr ? std::optional(one->stance_nrmse / perfect->stance_nrmse) : std::nullopt;
}

/// The bound on the adaptive design's ratio; none where the fixed designs are worse and nothing moves.
std::optional<double> bound_of(const AdaptationRow& row) {
  const AdaptationCell* tuned = cell(row, trials::kTuned);
  if (tuned != nullptr && tuned->falls == 0 && row.tuned_ratio && *row.tuned_ratio <= kNoCostRatioAtMost) {
    return kNoCostRatioAtMost;
  }
  return row.moves ? std::optional(kAdaptiveRatioAtMost) : std::nullopt;
}

}  // namespace

std::vector<AdaptationRow> adaptation_rows(std::span<const trials::StudyDesign> designs,
                                           std::span<const trials::TrotRow> runs) {
  std::vector<AdaptationRow> rows;
  for (const trials::PlantRow& plant : trials::plant_rows()) {
    for (const trials::StudyCondition& condition : trials::kStudyConditions) {
      const std::string trial = std::string(plant.name) + ", " + condition.name;
      std::map<std::string, BySeed> by_design;
      for (const trials::TrotRow& run : runs) {
        if (run.trial == trial) {
          const std::size_t comma = run.name.find(", ");
          by_design[run.name.substr(0, comma)][run.name.substr(comma)] = &run;
        }
      }
      if (by_design.empty()) {
        continue;
      }
      AdaptationRow row{.row = plant.name, .condition = condition.name, .moves = plant.later.has_value(), .cells = {}};
      for (const trials::StudyDesign& design : designs) {
        if (const auto found = by_design.find(design.name); found != by_design.end()) {
          row.cells.push_back(cell_of(design.name, found->second));
        }
      }
      row.lost = lost_seeds(by_design[trials::kPerfect], by_design[trials::kAdaptive]);
      row.caused = lost_seeds(by_design[trials::kNominal], by_design[trials::kAdaptive]);
      row.ratio = ratio_of(row, trials::kAdaptive);
      row.tuned_ratio = ratio_of(row, trials::kTuned);
      rows.push_back(row);
    }
  }
  return rows;
}

void add_adaptation(Figures& figures, std::span<const AdaptationRow> rows) {
  int lost = 0, caused = 0;
  for (const AdaptationRow& row : rows) {
    const std::string prefix = "compare.adaptation." + row.row + "." + row.condition + ".";
    for (const AdaptationCell& of : row.cells) {
      figures.add(prefix + of.design + ".runs", of.runs);
      figures.add(prefix + of.design + ".falls", of.falls);
      const WilsonInterval share =
          wilson_interval(static_cast<std::size_t>(of.falls), static_cast<std::size_t>(of.runs));
      figures.add(prefix + of.design + ".fall_share_low", share.low);
      figures.add(prefix + of.design + ".fall_share_high", share.high);
      if (of.falls < of.runs) {
        figures.add(prefix + of.design + ".stance_nrmse", of.stance_nrmse);
        figures.add(prefix + of.design + ".height_rms_mm", kHeightInMm * of.height_rms_m);
        figures.add(prefix + of.design + ".speed_error", of.speed_error);
        figures.add(prefix + of.design + ".energy_J_m", of.energy_J_m);
      }
    }
    if (row.ratio) {
      if (const auto bound = bound_of(row)) {
        figures.add(prefix + "ratio_to_perfect", *row.ratio, *bound);
      } else {
        figures.add(prefix + "ratio_to_perfect", *row.ratio);
      }
    }
    lost += row.lost;
    caused += row.caused;
  }
  figures.add("compare.adaptation.lost", lost, 0.0);
  figures.add("compare.adaptation.caused", caused, 0.0);
}

std::string adaptation_text(std::span<const AdaptationRow> rows) {
  std::vector<std::vector<std::string>> lines;
  for (const AdaptationRow& row : rows) {
    if (lines.empty()) {
      lines.push_back({"row", "condition"});
      for (const AdaptationCell& of : row.cells) {
        lines.back().push_back(of.design);
      }
      lines.back().insert(lines.back().end(), {"adaptive/perfect", "lost", "caused"});
    }
    std::vector<std::string> line{row.row, row.condition};
    for (const AdaptationCell& of : row.cells) {
      const WilsonInterval share =
          wilson_interval(static_cast<std::size_t>(of.falls), static_cast<std::size_t>(of.runs));
      const auto percent = [](double value) { return std::to_string(std::lround(kPercentOfShare * value)); };
      line.push_back(std::to_string(of.falls) + "/" + std::to_string(of.runs) + " (" + percent(share.low) + "-" +
                     percent(share.high) + " %) " + (of.falls < of.runs ? short_number(of.stance_nrmse) : "-"));
    }
    line.push_back(row.ratio ? short_number(*row.ratio) : "-");
    line.push_back(std::to_string(row.lost));
    line.push_back(std::to_string(row.caused));
    lines.push_back(line);
  }
  return aligned(lines);
}

std::string search_text(std::span<const trials::FixedSearch::Candidate> candidates) {
  std::vector<std::vector<std::string>> lines{{"candidate", "falls", "stance", "velocity_compensation", "force_1_s",
                                               "integral_1_s2", "velocity_lead_s", "swing_gain", "observer_1_s"}};
  for (const trials::FixedSearch::Candidate& each : candidates) {
    const control::FeedbackLinearisationGains& gains = each.gains;
    lines.push_back({std::to_string(each.number), std::to_string(each.falls) + " of " + std::to_string(each.runs),
                     short_number(each.nrmse()), short_number(gains.velocity_compensation),
                     short_number(gains.force_1_s), short_number(gains.integral_1_s2),
                     short_number(gains.velocity_lead_s), short_number(gains.swing_gain),
                     short_number(gains.observer_1_s)});
  }
  return aligned(lines);
}

}  // namespace farrier::report
