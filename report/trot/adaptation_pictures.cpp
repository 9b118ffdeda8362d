#include "report/trot/adaptation_pictures.hpp"

#include <algorithm>
#include <cmath>

#include "config/problem.hpp"
#include "control/numerics/spectrum.hpp"
#include "robot/joint_model.hpp"
#include "supervisor/joint_design.hpp"
#include "report/page/gnuplot.hpp"

namespace farrier::report {
namespace {

using signals::JointControllerGains;
using signals::Phase;

constexpr const char* kLayout =
    R"(set terminal svg size 1080,380 font "sans-serif,11" noenhanced background "#ffffff"
set lmargin at screen 0.075; set rmargin at screen 0.60
set key at screen 0.60,0.985 right top horizontal samplen 2 noautotitle
)";

// Okabe and Ito (2008): stance blue, swing orange; the true loads dashed.
constexpr const char* kStance = "'#0072b2'";
constexpr const char* kSwing = "'#d55e00'";

std::string axis_number(double value) { return config::number_text(value); }

double seconds(const AdaptationPicture& input, Tick tick) {
  return static_cast<double>(tick) * input.robot.period_s;
}

std::string gain_line(double time_s, const JointControllerGains& gains) {
  return axis_number(time_s) + " " + axis_number(gains.k_velocity) + " " + axis_number(gains.k_force) + "\n";
}

/// Time s, velocity gain, force gain of one slot; the last pair again at the end of the run.
std::string gain_lines(const AdaptationPicture& input, Phase phase) {
  std::vector<JointControllerGains> slot;
  std::ranges::copy_if(input.gains, std::back_inserter(slot), [&](const JointControllerGains& gains) {
    return gains.joint == input.joint.number && gains.phase == static_cast<std::uint8_t>(phase);
  });
  std::ranges::stable_sort(slot, {}, &JointControllerGains::effective_tick);
  std::string lines;
  for (const JointControllerGains& gains : slot) {
    lines += gain_line(seconds(input, gains.effective_tick), gains);
  }
  return slot.empty() ? "NaN NaN NaN\n" : lines + gain_line(seconds(input, input.ticks), slot.back());
}

/// Real and imaginary part of the poles of the estimates of one slot that were accepted, or not.
std::string estimate_lines(const AdaptationPicture& input, Phase phase, bool accepted) {
  std::string lines = "NaN NaN\n";  // never empty, which gnuplot refuses
  for (const DecisionInfo& info : input.decisions) {
    const signals::JointUpdateDecision& decision = info.decision;
    if (info.joint == input.joint.name && info.accepted() == accepted &&
        decision.phase == static_cast<std::uint8_t>(phase)) {
      for (std::size_t i = 0; i < decision.poles_re.size(); ++i) {
        const bool unused = decision.poles_re[i] == 0.0 && decision.poles_im[i] == 0.0;  // compliant: two states
        lines += unused ? "" : axis_number(decision.poles_re[i]) + " " + axis_number(decision.poles_im[i]) + "\n";
      }
    }
  }
  return lines;
}

std::string true_lines(const AdaptationPicture& input, const plant::LoadParams& load) {
  std::string lines;
  const control::SmallMatrix a = robot::model_of(input.joint, load, input.robot.period_s).a;
  // The compliant form leaves the position out, and so do its estimates.
  const bool compliant = input.joint.form == control::Form::kCompliant;
  const auto poles = control::eigenvalues(compliant ? control::SmallMatrix(a.bottomRightCorner(2, 2)) : a);
  for (Eigen::Index i = 0; i < poles.size(); ++i) {
    lines += axis_number(poles[i].real()) + " " + axis_number(poles[i].imag()) + "\n";
  }
  return lines;
}

std::string level(double value, const char* colour) {
  return "set arrow from graph 0, first " + axis_number(value) + " to graph 1, first " + axis_number(value) +
         " nohead dashtype 2 lw 1 lc rgb " + colour + "\n";
}

/// One panel: column `column` of the gains' data over time, and what it is for the true loads.
std::string gain_panel(const std::string& gains, int column, double for_stance, double for_swing, bool titled) {
  const std::string with = "\" using 1:" + std::to_string(column) + " with steps lw 1.5 lc rgb ";
  const auto title = [&](const char* text) { return titled ? std::string(" title '") + text + "'" : std::string(); };
  return "unset arrow\n" + level(for_stance, kStance) + level(for_swing, kSwing) +
         // An arrow alone does not stretch the axis.
         "plot " + axis_number(for_stance) + " with lines lw 0.01 lc rgb 'white', " + axis_number(for_swing) +
         " with lines lw 0.01 lc rgb 'white', \"" + gains + "_stance.dat" + with + kStance + title("stance slot") +
         ", \"" + gains + "_swing.dat" + with + kSwing + title("swing slot") +
         (titled ? ", keyentry with lines dashtype 2 lc rgb '#667078' title 'for the true load'\n" : "\n");
}

std::string pole_panel(const std::string& poles) {
  const auto points = [&](int index, const char* style, const char* colour, const char* title) {
    return "\"" + poles + "\" index " + std::to_string(index) + " using 1:2 with points " + style + " lc rgb " +
           colour + " title '" + title + "'";
  };
  return std::string(R"(unset arrow
set lmargin at screen 0.66; set rmargin at screen 0.985; set tmargin at screen 0.98; set bmargin at screen 0.36
set key at screen 0.66,0.01 left bottom vertical Left reverse samplen 1 noautotitle
set size ratio -1; set xtics 0.5; set ytics 0.5; set format x '%g'
set xrange [-1.12:1.12]; set yrange [-1.12:1.12]; unset xlabel; set ylabel 'imaginary part of z' offset 1,0
set object circle at 0,0 size 1 behind fillstyle solid 0.08 fillcolor rgb '#0072b2' linewidth 1
)") + "plot " + points(2, "pt 7 ps 0.6", kStance, "estimates accepted, stance") + ", " +
         points(3, "pt 7 ps 0.6", kSwing, "estimates accepted, swing") + ", " +
         points(4, "pt 1 ps 0.8", "'#999999'", "estimates refused") + ", " +
         points(0, "pt 4 ps 1.5 lw 1.5", kStance, "true, stance load") + ", " +
         points(1, "pt 8 ps 1.5 lw 1.5", kSwing, "true, swing load") + "\n";
}

}  // namespace

bool adapted(const AdaptationPicture& input) {
  return std::ranges::any_of(input.decisions,
                             [&](const DecisionInfo& info) { return info.joint == input.joint.name; });
}

Result<Done> plot_adaptation(const AdaptationPicture& input, const std::string& out_dir, const std::string& stem,
                             const std::string& output, std::string& script) {
  const robot::Joint& joint = input.joint;
  const auto stance = supervisor::design_joint(joint, joint.stance_load, input.robot.period_s, input.loop_delay_ticks);
  const auto swing = supervisor::design_joint(joint, joint.swing_load, input.robot.period_s, input.loop_delay_ticks);
  if (!stance || !swing) {
    return stance ? swing.error() : stance.error();
  }
  const std::string poles = true_lines(input, joint.stance_load) + "\n\n" + true_lines(input, joint.swing_load) +
                            "\n\n" + estimate_lines(input, Phase::kStance, true) + "\n\n" +
                            estimate_lines(input, Phase::kSwing, true) + "\n\n" +
                            estimate_lines(input, Phase::kStance, false) + estimate_lines(input, Phase::kSwing, false);
  for (const auto& [name, lines] : {std::pair("_gains_stance.dat", gain_lines(input, Phase::kStance)),
                                    std::pair("_gains_swing.dat", gain_lines(input, Phase::kSwing)),
                                    std::pair("_estimates.dat", poles)}) {
    if (auto written = write_plot_data(out_dir + "/" + stem + name, lines); !written) {
      return written;
    }
  }
  script += std::string(kPictureStart) + kLayout + "set output '" + output + "'\nset multiplot\nset xrange [0:" +
            axis_number(seconds(input, input.ticks)) + "]\n";
  script += "set tmargin at screen 0.90; set bmargin at screen 0.53; set format x ''; set ylabel 'velocity gain'\n";
  script += gain_panel(stem + "_gains", 2, stance.value().velocity, swing.value().velocity, true);
  script += "set tmargin at screen 0.48; set bmargin at screen 0.12; set format x '%g'; set ylabel 'force gain'\n";
  script += "set xlabel 'time / s' offset 0,0.4\n";
  script += gain_panel(stem + "_gains", 3, stance.value().force, swing.value().force, false);
  script += pole_panel(stem + "_estimates.dat") + "unset multiplot\n";
  return Done{};
}

}  // namespace farrier::report
