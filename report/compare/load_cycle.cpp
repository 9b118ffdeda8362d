#include "report/compare/load_cycle.hpp"

#include <algorithm>
#include <cmath>
#include <set>

#include "trace/force_error.hpp"
#include "report/page/html_page.hpp"
#include "report/page/html_tables.hpp"
#include "report/compare/load_cycle_pictures.hpp"
#include "report/figures/text_format.hpp"

namespace farrier::report {
namespace {

constexpr std::size_t kQuarterCount = 4;

bool heavy(std::size_t quarter) { return quarter % 2 == 1; }

/// Of the runs that must hold something.
std::optional<double> bound_of(std::string_view run, std::size_t quarter) {
  if (run == "greybox") {
    return kGreyBoxAtMost;
  }
  if (run == "greybox_noiseless") {
    return kNoiselessAtMost;
  }
  if (heavy(quarter) && (run == "fixed" || run == "adaptive")) {
    return run == "fixed" ? kFixedAtLeast : kAdaptiveAtMost;
  }
  return std::nullopt;
}

std::string quarter_name(std::size_t quarter) { return "quarter" + std::to_string(quarter + 1); }

const LoadCycleRun* find(std::span<const LoadCycleRun> runs, std::string_view name) {
  const auto found = std::ranges::find(runs, name, &LoadCycleRun::name);
  return found == runs.end() ? nullptr : &*found;
}

/// Ticks at which gains changed after the first did.
std::size_t updates_of(const LoadCycleRun& run) {
  std::set<Tick> ticks;
  for (const signals::JointControllerGains& gains : run.gains) {
    ticks.insert(gains.effective_tick);
  }
  return ticks.empty() ? 0 : ticks.size() - 1;
}

std::string load_table(const LoadCyclePlan& plan) {
  std::string html = "<table><thead><tr><th>quarter</th><th>from</th><th>mass</th><th>friction</th></tr></thead>\n";
  for (std::size_t i = 0; i < kQuarterCount; ++i) {
    html += "<tr><td>" + std::to_string(i + 1) + "</td><td>" +
            short_number(static_cast<double>(plan.begin[i]) * plan.robot.period_s) + " s</td><td>" +
            short_number(plan.loads[i].mass) + " kg</td><td>" + short_number(plan.loads[i].damping) +
            " Ns/m</td></tr>\n";
  }
  return html + "</table>\n";
}

}  // namespace

double quarter_error(const LoadCyclePlan& plan, std::span<const trace::TraceRow> rows, std::size_t quarter) noexcept {
  const Tick transient = std::llround(trace::kJudgedAfter_s / plan.robot.period_s);
  return trace::relative_error(rows, plan.begin[quarter] + transient, plan.begin[quarter + 1]);
}

void add_load_cycle(Figures& figures, const LoadCyclePlan& plan, std::span<const LoadCycleRun> runs) {
  for (const LoadCycleRun& run : runs) {
    for (std::size_t i = 0; i < kQuarterCount; ++i) {
      figures.add("trot.fig7_8." + run.name + "." + quarter_name(i) + "_nrmse", quarter_error(plan, run.rows, i),
                  bound_of(run.name, i));
    }
  }
  const LoadCycleRun* adaptive = find(runs, "adaptive");
  const LoadCycleRun* true_load = find(runs, "true_load");
  const LoadCycleRun* dithered = find(runs, "true_load_dithered");
  if (adaptive == nullptr || true_load == nullptr || dithered == nullptr) {
    return;
  }
  const robot::Joint& joint = plan.robot.joints[0];
  // The ratio's bound is about what adapting an LQR by least squares costs.
  const bool as_shipped =
      joint.kind == control::Kind::kLqr && joint.estimator.method == estimation::EstimationMethod::kRls;
  for (std::size_t i = 0; i < kQuarterCount; ++i) {
    if (!heavy(i)) {
      const double error = quarter_error(plan, adaptive->rows, i);
      figures.add("trot.fig7_8.light_ratio_" + quarter_name(i), error / quarter_error(plan, true_load->rows, i),
                  as_shipped ? std::optional(kLightRatioAtMost) : std::nullopt);
      figures.add("trot.fig7_8.dithered_light_ratio_" + quarter_name(i),
                  error / quarter_error(plan, dithered->rows, i));
    }
  }
  figures.add("trot.fig7_8.gain_updates", static_cast<double>(updates_of(*adaptive)));
}

Result<std::string> write_load_cycle_report(const std::string& out_dir, const Outcome& outcome,
                                            const LoadCyclePlan& plan, std::span<const LoadCycleRun> runs) {
  if (auto drawn = draw_load_cycle(out_dir, plan, runs); !drawn) {
    return drawn.error();
  }
  std::string html = page_head(plan.robot.name + ": load changes as in Fig. 7.8", outcome);
  html += "<h2>Load</h2>\n" + load_table(plan);
  html += "<p>Heavy quarters are shaded. Poles are those of the model the acting gains were designed for (colour: "
          "time within the run) and of the true load (crosses).</p>\n";
  for (const LoadCycleRun& run : runs) {
    const std::string name = escape_html(run.name);
    html += "<h2 id=\"" + name + "\">" + escape_html(run.title) + "</h2>\n<img src=\"pictures/" + name +
            "_force.svg\" alt=\"force and gains over time\">\n<img src=\"pictures/" + name +
            "_poles.svg\" alt=\"poles by quarter\">\n";
  }
  return write_page(out_dir, html + page_foot(outcome));
}

}  // namespace farrier::report
