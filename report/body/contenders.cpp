#include "report/body/contenders.hpp"

#include <algorithm>

#include "report/body/body_result.hpp"
#include "report/figures/text_format.hpp"

namespace farrier::report {
namespace {

constexpr double kPerMetre_mm = 1000.0;

const trials::ContenderResult* find(std::span<const trials::ContenderResult> results, const char* name) {
  const auto found = std::ranges::find(results, name, &trials::ContenderResult::name);
  return found == results.end() || found->runs.height_rms_m == 0.0 ? nullptr : &*found;
}

}  // namespace

void add_contenders(Figures& figures, std::span<const trials::ContenderResult> results) {
  for (const trials::ContenderResult& result : results) {
    const std::string prefix = "compare.body." + result.name + ".";
    figures.add(prefix + "walk_falls", result.runs.walk_falls);
    figures.add(prefix + "step_falls", result.runs.step_falls);
    if (result.runs.height_rms_m > 0.0) {
      figures.add(prefix + "height_rms_mm", kPerMetre_mm * result.runs.height_rms_m);
      for_each_force_error([&](std::size_t place, std::size_t phase, const std::string& name) {
        figures.add(prefix + "force_nrmse." + name, result.runs.force_nrmse[place][phase]);
      });
    }
  }
  const trials::ContenderResult* file = find(results, trials::kFileDesign);
  const trials::ContenderResult* perfect = find(results, trials::kPerfectKnowledge);
  if (file != nullptr && perfect != nullptr) {
    for_each_force_error([&](std::size_t place, std::size_t phase, const std::string& name) {
      figures.add("compare.body.knowledge_ratio." + name,
                  file->runs.force_nrmse[place][phase] / perfect->runs.force_nrmse[place][phase],
                  kKnowledgeRatioAtMost);
    });
  }
}

std::string contenders_text(std::span<const trials::ContenderResult> results) {
  std::vector<std::vector<std::string>> cells{{"controller", "walks fell", "steps fell", "height mm", "haa swing",
                                               "stance", "hfe swing", "stance", "kfe swing", "stance", "robot"}};
  for (const trials::ContenderResult& result : results) {
    std::vector<std::string> line{result.name,
                                  std::to_string(result.runs.walk_falls) + " of " + std::to_string(result.runs.walks),
                                  std::to_string(result.runs.step_falls) + " of " + std::to_string(result.runs.steps)};
    const bool walked = result.runs.height_rms_m > 0.0;
    line.push_back(walked ? short_number(kPerMetre_mm * result.runs.height_rms_m) : "-");
    for_each_force_error([&](std::size_t place, std::size_t phase, const std::string&) {
      line.push_back(walked ? short_number(result.runs.force_nrmse[place][phase]) : "-");
    });
    line.push_back(result.runs.refusal.empty() ? result.description : "refused: " + result.runs.refusal);
    cells.push_back(line);
  }
  return aligned(cells);
}

}  // namespace farrier::report
