#include "report/trot/picture_data.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <limits>
#include <memory>

#include "core/ensure.hpp"
#include "report/trot/tracking.hpp"

namespace farrier::report {
namespace {

constexpr int kWindowStrides = 3;
constexpr double kStandingWindow_s = 2.0;
constexpr Tick kRunIntervals = 400;

struct Close {
  void operator()(std::FILE* file) const noexcept { std::fclose(file); }
};
using File = std::unique_ptr<std::FILE, Close>;

struct Span {
  double low = std::numeric_limits<double>::infinity();
  double high = -std::numeric_limits<double>::infinity();

  void add(double value) noexcept {
    low = std::min(low, value);
    high = std::max(high, value);
  }
};

Tick window_ticks(const robot::Robot& robot, const gait::Schedule& schedule) {
  return robot.plan.gait.pattern == gait::Pattern::kStand ? std::llround(kStandingWindow_s / robot.period_s)
                                                          : kWindowStrides * schedule.stride_ticks();
}

double error_of(const trace::TraceRow& row) { return row.force_reference_N_or_Nm - row.force_N_or_Nm; }

void extend_stances(std::vector<std::pair<double, double>>& stances, bool follows, double from, double to) {
  if (follows) {
    stances.back().second = to;
  } else {
    stances.emplace_back(from, to);
  }
}

void write_window(std::FILE* file, const std::vector<const trace::TraceRow*>& rows, Tick first, Tick last,
                  const gait::Schedule& schedule, int leg, double period_s, JointPictureData& data) {
  bool in_stance = false;
  for (const trace::TraceRow* row : rows) {
    if (row->tick < first || row->tick >= last) {
      continue;
    }
    const double time_s = static_cast<double>(row->tick) * period_s;
    std::fprintf(file, "%.4f %.6g %.6g %.6g\n", time_s, row->force_reference_N_or_Nm, row->force_N_or_Nm,
                 error_of(*row));
    const bool stance = schedule.phase(leg, row->tick) == gait::Phase::kStance;
    if (stance) {
      extend_stances(data.stance_s, in_stance, time_s, time_s + period_s);
    }
    in_stance = stance;
    data.empty = false;
  }
}

void write_run(std::FILE* file, const std::vector<const trace::TraceRow*>& rows, Tick ticks, double period_s) {
  const Tick per_interval = std::max<Tick>(1, (ticks + kRunIntervals - 1) / kRunIntervals);
  for (std::size_t i = 0; i < rows.size();) {
    const Tick interval = rows[i]->tick / per_interval;
    Span reference;
    Span error;
    for (; i < rows.size() && rows[i]->tick / per_interval == interval; ++i) {
      reference.add(rows[i]->force_reference_N_or_Nm);
      error.add(error_of(*rows[i]));
    }
    std::fprintf(file, "%.4f %.6g %.6g %.6g %.6g\n", static_cast<double>(interval * per_interval) * period_s,
                 reference.low, reference.high, error.low, error.high);
  }
}

}  // namespace

std::vector<std::vector<const trace::TraceRow*>> rows_by_joint(const robot::Robot& robot,
                                                                std::span<const trace::TraceRow> rows) {
  std::vector<std::vector<const trace::TraceRow*>> by_joint(robot.joints.size());
  for (const trace::TraceRow& row : rows) {
    FARRIER_ENSURE(row.joint < by_joint.size(), "a trace row of a joint the robot does not have");
    by_joint[row.joint].push_back(&row);
  }
  return by_joint;
}

Result<JointPictureData> write_picture_data(const std::string& stem, const robot::Robot& robot,
                                            const gait::Schedule& schedule, const robot::Joint& joint,
                                            const std::vector<const trace::TraceRow*>& rows) {
  const File window(std::fopen((stem + "_window.dat").c_str(), "w"));
  const File run(std::fopen((stem + "_run.dat").c_str(), "w"));
  if (!window || !run) {
    return Error{"cannot write the data of the report's pictures to " + stem + "_*.dat: " + std::strerror(errno)};
  }
  const Tick ticks = rows.empty() ? 0 : rows.back()->tick + 1;
  const Tick first = first_judged_tick(robot, schedule, joint.leg);
  const Tick last = std::min(ticks, first + window_ticks(robot, schedule));
  JointPictureData data;
  data.window_start_s = static_cast<double>(first) * robot.period_s;
  data.window_end_s = static_cast<double>(last) * robot.period_s;
  data.run_end_s = static_cast<double>(ticks) * robot.period_s;
  write_window(window.get(), rows, first, last, schedule, joint.leg, robot.period_s, data);
  write_run(run.get(), rows, ticks, robot.period_s);
  if (std::fflush(window.get()) != 0 || std::fflush(run.get()) != 0) {
    return Error{"cannot write the data of the report's pictures to " + stem + "_*.dat: " + std::strerror(errno)};
  }
  return data;
}

}  // namespace farrier::report
