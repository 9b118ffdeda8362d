#include "cli/compare/comparison.hpp"

#include <unistd.h>

#include <cstdio>

#include "trials/vary.hpp"
#include "participant/loop.hpp"
#include "cli/base/command.hpp"
#include "cli/compare/varied_study.hpp"
#include "report/figures/console.hpp"
#include "report/figures/outcome.hpp"

namespace farrier::cli {
namespace {

constexpr std::size_t kLongestTable = 40;

/// Runs the study with its progress bar, which is gone when this returns.
Result<std::vector<report::VaryRow>> rows_of_study(const robot::Robot& robot, const CompareOptions& o,
                                                   bool& long_enough) {
  const robot::Robot nominal = trials::with_varied_body(robot);
  VariedStudy study(nominal, report::kContenders, o, "compare varied");
  FARRIER_TRY(study.run());
  long_enough = study.long_enough();
  return study.rows();
}

}  // namespace

int run_varied(const robot::Robot& robot, const CompareOptions& o) {
  const std::string rows_path = o.out + "/vary.csv";
  participant::install_signal_handlers();
  bool long_enough = false;
  const auto rows = rows_of_study(robot, o, long_enough);
  if (!rows) {
    return fail("compare", rows.error().message);
  }
  report::Outcome outcome;
  outcome.command = "compare";
  outcome.run = report::run_info(robot, o.seed);
  report::add_vary(outcome.figures, rows.value());
  if (!long_enough) {
    outcome.failures.emplace_back(kTooShort);
  }
  if (auto written = report::write_vary_csv(rows_path, rows.value()); !written) {
    return fail("compare", written.error().message);
  }
  if (auto written = report::write_json(o.json_path, outcome); !written) {
    return fail("compare", written.error().message);
  }
  std::printf("%s\n%s", report::vary_text(rows.value(), kLongestTable).c_str(),
              report::console_text(outcome, report::wants_colour(STDOUT_FILENO)).c_str());
  std::printf("figures: %s\nevery joint and seed: %s\n", o.json_path.c_str(), rows_path.c_str());
  return outcome.passes() ? kPassed : kFailed;
}

}  // namespace farrier::cli
