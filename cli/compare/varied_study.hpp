#pragma once

#include <span>
#include <string>
#include <vector>

#include "gait/schedule.hpp"
#include "trials/vary.hpp"
#include "trace/trace.hpp"
#include "robot/robot.hpp"
#include "cli/base/progress.hpp"
#include "cli/compare/compare_options.hpp"
#include "report/compare/vary_result.hpp"

namespace farrier::cli {

/// The gait of `o.seeds` varied robots, from `o.seed` on, under every one of some contenders, in process.
class VariedStudy {
 public:
  /// `nominal` (trials::with_varied_body) outlives the study; `title` is its bar's.
  VariedStudy(const robot::Robot& nominal, std::span<const report::Contender> contenders, const CompareOptions& o,
              const std::string& title);

  /// Refuses what run::run_inproc does, with contender and seed, and when the user interrupts.
  Result<Done> run();

  const std::vector<report::VaryRow>& rows() const noexcept { return rows_; }
  bool long_enough() const noexcept { return long_enough_; }

 private:
  struct Entrant {
    report::Contender contender;
    robot::Robot believed;
  };

  Result<Done> run(const Entrant& entrant, std::uint64_t seed, const trials::Draw& draw, const robot::Robot& world);
  void judge(report::Contender contender, std::uint64_t seed, const trials::Draw& draw, const robot::Robot& world,
             const gait::Schedule& schedule);
  std::vector<double> peak_demands(const robot::Robot& world, const gait::Schedule& schedule) const;

  const robot::Robot& nominal_;
  std::uint64_t seeds_;
  std::uint64_t first_seed_;
  Tick ticks_;
  std::vector<Entrant> entrants_;
  Progress progress_;
  std::vector<trace::TraceRow> trace_;
  std::vector<report::VaryRow> rows_;
  Tick ticks_done_ = 0;
  bool long_enough_ = true;
};

}  // namespace farrier::cli
