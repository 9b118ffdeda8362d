#include "report/compare/load_cycle_pictures.hpp"

#include <algorithm>
#include <cstdio>

#include "config/problem.hpp"
#include "control/model/model_rows.hpp"
#include "control/numerics/spectrum.hpp"
#include "robot/joint_model.hpp"
#include "supervisor/joint_design.hpp"
#include "report/page/gnuplot.hpp"

namespace farrier::report {
namespace {

using signals::JointControllerGains;

constexpr std::size_t kQuarters = 4;

constexpr const char* kForceLayout =
    R"(set terminal svg size 1080,560 font "sans-serif,12" noenhanced background "#ffffff"
set lmargin at screen 0.075; set rmargin at screen 0.985
set key at graph 1,1.13 right top horizontal samplen 2 noautotitle
)";

constexpr const char* kCyclePolesLayout =
    R"(set terminal svg size 1080,330 font "sans-serif,11" noenhanced background "#ffffff"
set size ratio -1
set key off
set xrange [-1.15:1.15]; set yrange [-1.15:1.15]; set xtics 1; set ytics 1
unset colorbox
set palette defined (0 "#000000", 1 "#e69f00")
)";

std::string number_word(double value) { return config::number_text(value); }

/// Gains that act in a stand, in the order of their ticks.
std::vector<JointControllerGains> acting(const LoadCycleRun& run) {
  std::vector<JointControllerGains> gains;
  for (const JointControllerGains& update : run.gains) {
    if (update.phase == static_cast<std::uint8_t>(signals::Phase::kStance)) {
      gains.push_back(update);
    }
  }
  std::ranges::stable_sort(gains, {}, &JointControllerGains::effective_tick);
  return gains;
}

std::string pole_lines(const Eigen::Matrix3d& a, double time_s) {
  std::string lines;
  const control::SmallSpectrum poles = control::eigenvalues(a);
  for (Eigen::Index i = 0; i < poles.size(); ++i) {
    lines += number_word(poles[i].real()) + " " + number_word(poles[i].imag()) + " " + number_word(time_s) + "\n";
  }
  return lines;
}

std::string force_lines(const LoadCycleRun& run, double period_s) {
  std::string lines;
  char line[96];
  for (const trace::TraceRow& row : run.rows) {
    std::snprintf(line, sizeof line, "%.4f %.6g %.6g\n", static_cast<double>(row.tick) * period_s,
                  row.force_reference_N_or_Nm, row.force_N_or_Nm);
    lines += line;
  }
  return lines;
}

std::string cycle_gain_lines(const std::vector<JointControllerGains>& gains, const LoadCyclePlan& plan) {
  std::string lines;
  const auto line = [&](Tick tick, const JointControllerGains& g) {
    lines += number_word(static_cast<double>(tick) * plan.robot.period_s);
    for (const double gain : {g.k_position, g.k_velocity, g.k_force, g.k_integral, g.feed_forward}) {
      lines += " " + number_word(gain);
    }
    lines += "\n";
  };
  for (const JointControllerGains& update : gains) {
    line(update.effective_tick, update);
  }
  if (!gains.empty()) {
    line(plan.begin.back(), gains.back());
  }
  return lines;
}

std::string shaded(const LoadCyclePlan& plan) {
  std::string script;
  for (std::size_t i = 1; i < kQuarters; i += 2) {
    script += "set object rectangle from " + number_word(static_cast<double>(plan.begin[i]) * plan.robot.period_s) +
              ", graph 0 to " + number_word(static_cast<double>(plan.begin[i + 1]) * plan.robot.period_s) +
              ", graph 1 behind fillcolor rgb \"#e9eff3\" fillstyle solid noborder\n";
  }
  return script;
}

std::string force_plot(const LoadCycleRun& run, const LoadCyclePlan& plan) {
  const std::string end = number_word(static_cast<double>(plan.begin.back()) * plan.robot.period_s);
  std::string script = std::string(kPictureStart) + kForceLayout + "set output 'pictures/" + run.name +
                       "_force.svg'\nset multiplot\nset xrange [0:" + end + "]\n" + shaded(plan);
  script += "set tmargin at screen 0.93; set bmargin at screen 0.55; set format x ''; set ylabel 'force / N'\n";
  script += "plot 'data/" + run.name + "_force.dat' using 1:3 with lines lc rgb '#009e73' lw 1.4 title 'force', '' "
            "using 1:2 with lines ls 2 title 'reference'\n";
  script += "set tmargin at screen 0.46; set bmargin at screen 0.10; set format x '%g'\n";
  script += "set xlabel 'time / s' offset 0,0.4; set ylabel 'gains, normalised'\n";
  script += "plot 'data/" + run.name + "_gains.dat' using 1:2 with steps ls 1 title 'position', '' using 1:3 with "
            "steps ls 2 title 'velocity', '' using 1:4 with steps ls 3 title 'force', '' using 1:5 with steps lc rgb "
            "'#cc79a7' title 'integral', '' using 1:6 with steps lc rgb '#009e73' title 'feed-forward'\n";
  return script + "unset multiplot\n";
}

std::string cycle_poles_plot(const LoadCycleRun& run, const LoadCyclePlan& plan) {
  std::string script = std::string(kPictureStart) + kCyclePolesLayout + "set output 'pictures/" + run.name +
                       "_poles.svg'\nset cbrange [0:" +
                       number_word(static_cast<double>(plan.begin.back()) * plan.robot.period_s) +
                       "]\nset multiplot layout 1,4\n"
                       "set object circle at 0,0 size 1 behind fillstyle solid 0.08 fillcolor rgb '#0072b2'\n";
  for (std::size_t i = 0; i < kQuarters; ++i) {
    const std::string data = "data/" + run.name + "_poles" + std::to_string(i + 1) + ".dat";
    script += "set title 'quarter " + std::to_string(i + 1) + "'\nplot '" + data +
              "' index 1 using 1:2 with points pt 2 ps 1.3 lw 1.5 lc rgb '#0072b2', '" + data +
              "' index 0 using 1:2:3 with points pt 7 ps 0.6 palette\n";
  }
  return script + "unset multiplot\n";
}

/// Poles of the models whose gains act at any time of the quarter; then, as a second block, of the true load.
std::string quarter_poles(const std::vector<JointControllerGains>& gains, const LoadCyclePlan& plan,
                          std::size_t quarter) {
  std::string lines;
  for (std::size_t i = 0; i < gains.size(); ++i) {
    const bool begins = gains[i].effective_tick < plan.begin[quarter + 1];
    const bool ends = i + 1 < gains.size() && gains[i + 1].effective_tick <= plan.begin[quarter];
    if (begins && !ends) {
      const Tick since = std::max(gains[i].effective_tick, plan.begin[quarter]);
      lines += pole_lines(control::model_of_rows(gains[i].model_a, gains[i].model_b).a, static_cast<double>(since) * plan.robot.period_s);
    }
  }
  const robot::Joint& joint = plan.robot.joints.front();
  const auto truth = robot::model_of(joint, plan.loads[quarter], plan.robot.period_s);
  return lines + "\n\n" + pole_lines(truth.a, 0.0);
}

}  // namespace

Result<Done> draw_load_cycle(const std::string& out_dir, const LoadCyclePlan& plan,
                             std::span<const LoadCycleRun> runs) {
  if (auto made = make_picture_folders(out_dir); !made) {
    return made.error();
  }
  std::string script;
  for (const LoadCycleRun& run : runs) {
    const std::vector<JointControllerGains> gains = acting(run);
    const std::string stem = out_dir + "/data/" + run.name;
    Result<Done> written = write_plot_data(stem + "_force.dat", force_lines(run, plan.robot.period_s));
    if (written) {
      written = write_plot_data(stem + "_gains.dat", cycle_gain_lines(gains, plan));
    }
    for (std::size_t i = 0; i < kQuarters && written; ++i) {
      written = write_plot_data(stem + "_poles" + std::to_string(i + 1) + ".dat", quarter_poles(gains, plan, i));
    }
    if (!written) {
      return written.error();
    }
    script += force_plot(run, plan) + cycle_poles_plot(run, plan);
  }
  return draw(out_dir, script);
}

}  // namespace farrier::report
