#pragma once

#include <span>
#include <string>
#include <vector>

#include "gait/schedule.hpp"
#include "lab/vary.hpp"
#include "record/trace.hpp"
#include "robot/robot.hpp"
#include "tools/cli/progress.hpp"
#include "tools/cli/trot_options.hpp"
#include "tools/report/vary_result.hpp"

namespace farrier::cli {

/// The gait of `o.seeds` varied robots, from `o.seed` on, under every one of some contenders, in process.
class VaryStudy {
 public:
  /// `nominal` (lab::with_varied_body) outlives the study; `title` is its bar's.
  VaryStudy(const robot::Robot& nominal, std::span<const report::Contender> contenders, const TrotOptions& o,
            const std::string& title);

  /// Refuses what lab::run_inproc does, with contender and seed, and when the user interrupts.
  Result<Done> run();

  const std::vector<report::VaryRow>& rows() const noexcept { return rows_; }
  bool long_enough() const noexcept { return long_enough_; }

 private:
  struct Entrant {
    report::Contender contender;
    robot::Robot believed;
  };

  Result<Done> run(const Entrant& entrant, std::uint64_t seed, const lab::Draw& draw, const robot::Robot& world);
  void judge(report::Contender contender, std::uint64_t seed, const lab::Draw& draw, const robot::Robot& world,
             const gait::Schedule& schedule);
  std::vector<double> peak_demands(const robot::Robot& world, const gait::Schedule& schedule) const;

  const robot::Robot& nominal_;
  std::uint64_t seeds_;
  std::uint64_t first_seed_;
  Tick ticks_;
  std::vector<Entrant> entrants_;
  Progress progress_;
  std::vector<record::TraceRow> trace_;
  std::vector<report::VaryRow> rows_;
  Tick ticks_done_ = 0;
  bool long_enough_ = true;
};

}  // namespace farrier::cli
