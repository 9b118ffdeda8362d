#include "report/compare/update_logic.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <vector>

#include "core/median.hpp"

namespace farrier::report {
namespace {

constexpr const char* kDefault = "distinct_poles";

struct UpdateLogicSummary {
  double stance_median, stance_worst, swing_median;
  int diverged;      // joints of the trot
  int rig_diverged;  // quarters
};

UpdateLogicSummary summary_of(const UpdateLogicResult& result) {
  std::vector<double> stance, swing;
  UpdateLogicSummary summary{};
  for (const JointTracking& joint : result.tracking.joints) {
    stance.push_back(joint.stance.nrmse);
    swing.push_back(joint.swing.nrmse);
    summary.diverged +=
        joint.tripped || joint.not_tracking_ticks > 0 || !(joint.stance.nrmse <= kDivergedAbove) ? 1 : 0;
  }
  summary.stance_median = median(stance);
  summary.stance_worst = *std::ranges::max_element(stance);
  summary.swing_median = median(swing);
  summary.rig_diverged = static_cast<int>(
      std::ranges::count_if(result.quarter_nrmse, [](double nrmse) { return !(nrmse <= kDivergedAbove); }));
  return summary;
}

}  // namespace

void add_update_logic(Figures& figures, std::span<const UpdateLogicResult> results) {
  for (const UpdateLogicResult& result : results) {
    const UpdateLogicSummary summary = summary_of(result);
    const std::string prefix = "trot.update_logic." + result.method + ".";
    const auto bound = result.method == kDefault ? std::optional(0.0) : std::nullopt;
    for (std::size_t quarter = 0; quarter < result.quarter_nrmse.size(); ++quarter) {
      figures.add(prefix + "quarter" + std::to_string(quarter + 1) + "_nrmse", result.quarter_nrmse[quarter]);
    }
    figures.add(prefix + "rig_updates", static_cast<double>(result.rig.accepted));
    figures.add(prefix + "rig_designs", static_cast<double>(result.rig.designs));
    figures.add(prefix + "rig_diverged", summary.rig_diverged, bound);
    figures.add(prefix + "stance_nrmse_median", summary.stance_median);
    figures.add(prefix + "stance_nrmse_worst", summary.stance_worst);
    figures.add(prefix + "swing_nrmse_median", summary.swing_median);
    figures.add(prefix + "diverged", summary.diverged, bound);
    figures.add(prefix + "updates", static_cast<double>(result.trot.accepted));
    figures.add(prefix + "designs", static_cast<double>(result.trot.designs));
    figures.add(prefix + "looks", static_cast<double>(result.trot.looks));
    figures.add(prefix + "look_us", result.trot.look_us);
  }
}

std::string update_logic_table(std::span<const UpdateLogicResult> results) {
  std::string table =
      "                 rig: NRMSE by quarter               updates designs | trot: stance          swing    joints\n"
      "method           1       2       3       4                             median  worst   median  diverged updates "
      "designs us/look\n";
  for (const UpdateLogicResult& result : results) {
    const UpdateLogicSummary summary = summary_of(result);
    const auto& nrmse = result.quarter_nrmse;
    char line[256];
    std::snprintf(line, sizeof line,
                  "%-16s %-7.3g %-7.3g %-7.3g %-7.3g     %7llu %7llu | %-7.3g %-7.3g %-8.3g %-8d %7llu %7llu %7.2f\n",
                  result.method.c_str(), nrmse[0], nrmse[1], nrmse[2], nrmse[3],
                  static_cast<unsigned long long>(result.rig.accepted),
                  static_cast<unsigned long long>(result.rig.designs), summary.stance_median, summary.stance_worst,
                  summary.swing_median, summary.diverged, static_cast<unsigned long long>(result.trot.accepted),
                  static_cast<unsigned long long>(result.trot.designs), result.trot.look_us);
    table += line;
  }
  return table;
}

}  // namespace farrier::report
