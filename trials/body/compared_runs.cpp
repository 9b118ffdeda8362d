#include "trials/body/compared_runs.hpp"

#include <algorithm>
#include <map>

#include "core/median.hpp"

namespace farrier::trials {
namespace {

bool is_compared(const TrotCase& one) { return (one.trial == "lag" && one.lag_ticks == 0) || one.trial == "step"; }

}  // namespace

std::vector<TrotCase> compared_cases(const robot::Robot& robot, int seeds) {
  std::vector<TrotCase> cases = trot_cases(robot);
  std::erase_if(cases, [](const TrotCase& one) { return !is_compared(one); });
  std::ranges::stable_partition(cases, [](const TrotCase& one) { return one.trial != "step"; });
  std::map<std::string, int> kept;
  std::erase_if(cases, [&](const TrotCase& one) { return ++kept[one.trial] > seeds; });
  return cases;
}

std::optional<ComparedRuns> compare_runs(const robot::Robot& robot, int seeds, bool adapts,
                                         const std::function<bool()>& done) {
  ComparedRuns runs;
  std::vector<TrotFigures> walks;
  for (TrotCase& one : compared_cases(robot, seeds)) {
    one.adapts = adapts;
    const auto ran = run_trot_case(robot, one, Joints::kActuators);
    if (!done()) {
      return std::nullopt;
    }
    if (!ran) {
      runs.refusal = ran.error().message;
      continue;
    }
    const TrotFigures& figures = *ran.value();
    const bool step = one.trial == "step";
    ++(step ? runs.steps : runs.walks);
    (step ? runs.step_falls : runs.walk_falls) += figures.fell_s ? 1 : 0;
    if (figures.adaptation) {
      runs.adaptation += *figures.adaptation;
    }
    if (!step && !figures.fell_s) {
      walks.push_back(figures);
    }
  }
  const auto median_of = [&walks](const auto& figure) {
    std::vector<double> values;
    std::ranges::transform(walks, std::back_inserter(values), figure);
    return median_or_zero(std::move(values));
  };
  runs.height_rms_m = median_of([](const TrotFigures& figures) { return figures.height_rms_m; });
  for (std::size_t place = 0; place < runs.force_nrmse.size(); ++place) {
    for (std::size_t phase = 0; phase < kPhaseCount; ++phase) {
      runs.force_nrmse[place][phase] =
          median_of([&](const TrotFigures& figures) { return figures.force_nrmse[place][phase]; });
    }
  }
  return runs;
}

}  // namespace farrier::trials
