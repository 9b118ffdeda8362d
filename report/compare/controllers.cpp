#include "report/compare/controllers.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>
#include <vector>

#include "core/median.hpp"
#include "report/figures/text_format.hpp"

namespace farrier::report {
namespace {

struct ControllerSummary {
  double stance_median, stance_worst, swing_median, swing_worst;
  std::size_t diverged;  ///< rows
  std::size_t seeds_failed;
};

ControllerSummary summarise(std::span<const VaryRow> rows, Contender contender) {
  std::vector<double> stance, swing;
  std::set<std::uint64_t> failed;
  std::size_t diverged = 0;
  for (const VaryRow& row : rows) {
    if (row.contender != contender) {
      continue;
    }
    stance.push_back(infinite_if_lost(row.stance_nrmse));
    swing.push_back(infinite_if_lost(row.swing_nrmse));
    diverged += row.diverged() ? 1 : 0;
    if (row.failed()) {
      failed.insert(row.seed);
    }
  }
  const auto worst = [](const std::vector<double>& values) {
    return values.empty() ? std::numeric_limits<double>::quiet_NaN() : *std::ranges::max_element(values);
  };
  return {median(stance), worst(stance), median(swing), worst(swing), diverged, failed.size()};
}

double best_median(std::span<const VaryRow> rows) {
  double best = std::numeric_limits<double>::infinity();
  for (const Contender contender : kControllers) {
    best = std::min(best, summarise(rows, contender).stance_median);
  }
  return best;
}

}  // namespace

void add_controllers(Figures& figures, std::string_view test, std::span<const VaryRow> rows) {
  const double best = best_median(rows);
  for (const Contender contender : kControllers) {
    const bool judged = contender == Contender::kGreyBox;
    const auto bound = [&](double value) { return judged ? std::optional(value) : std::nullopt; };
    const ControllerSummary s = summarise(rows, contender);
    const std::string prefix = std::string("trot.controllers.") + to_string(contender) + "." + std::string(test) + ".";
    figures.add(prefix + "stance_nrmse_median", s.stance_median);
    figures.add(prefix + "stance_nrmse_worst", s.stance_worst);
    figures.add(prefix + "swing_nrmse_median", s.swing_median);
    figures.add(prefix + "swing_nrmse_worst", s.swing_worst);
    figures.add(prefix + "ratio_to_best", s.stance_median / best, bound(kGreyBoxRatioAtMost));
    figures.add(prefix + "diverged", static_cast<double>(s.diverged), bound(0.0));
    figures.add(prefix + "seeds_failed", static_cast<double>(s.seeds_failed), bound(0.0));
  }
}

std::string controllers_text(std::string_view test, std::span<const VaryRow> rows) {
  static constexpr std::size_t kName = 24, kNumber = 11;
  const auto left = [](std::string text) { return text + std::string(kName - std::min(kName, text.size()), ' '); };
  const auto right = [](const std::string& text) {
    return std::string(kNumber - std::min(kNumber, text.size()), ' ') + text;
  };
  std::string text = left(std::string(test));
  for (const char* head : {"stance", "worst", "swing", "worst", "to best", "diverged", "failed"}) {
    text += right(head);
  }
  const double best = best_median(rows);
  for (const Contender contender : kControllers) {
    const ControllerSummary s = summarise(rows, contender);
    text += "\n" + left(to_string(contender));
    for (const double value :
         {s.stance_median, s.stance_worst, s.swing_median, s.swing_worst, s.stance_median / best}) {
      text += right(short_number(value));
    }
    text += right(std::to_string(s.diverged)) + right(std::to_string(s.seeds_failed));
  }
  return text + "\n";
}

}  // namespace farrier::report
