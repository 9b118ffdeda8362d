#include "report/trot/pictures.hpp"

#include <algorithm>
#include <cmath>

#include "report/trot/adaptation_pictures.hpp"
#include "report/page/gnuplot.hpp"
#include "report/trot/html_report.hpp"
#include "report/trot/joint_poles.hpp"
#include "report/trot/picture_data.hpp"
#include "report/figures/text_format.hpp"
#include "report/trot/tracking.hpp"

namespace farrier::report {
namespace {

// Panels lie one above the other and share their x axis; the legend stands above both.
constexpr const char* kTrackingLayout =
    R"(set terminal svg size 1080,460 font "sans-serif,12" noenhanced background "#ffffff"
set lmargin at screen 0.075; set rmargin at screen 0.985
set key at screen 0.985,0.985 right top horizontal samplen 2 noautotitle
)";

constexpr const char* kOverviewLayout =
    R"(set terminal svg size 640,250 font "sans-serif,11" noenhanced background "#ffffff"
set lmargin at screen 0.125; set rmargin at screen 0.98; set tmargin at screen 0.88; set bmargin at screen 0.2
set key at screen 0.98,0.985 right top horizontal samplen 2 noautotitle
set xlabel "time / s" offset 0,0.4
)";

constexpr const char* kPolesLayout =
    R"(set terminal svg size 420,470 font "sans-serif,11" noenhanced background "#ffffff"
set lmargin at screen 0.13; set rmargin at screen 0.97; set tmargin at screen 0.98; set bmargin at screen 0.27
set size ratio -1
set key at screen 0.13,0.01 left bottom vertical Left reverse samplen 1 noautotitle
set xlabel "real part of z" offset 0,0.3; set ylabel "imaginary part of z" offset 1,0
set xtics 0.5; set ytics 0.5
)";

std::string number(double value) { return config::number_text(value); }

std::string x_range(double from, double to) { return "set xrange [" + number(from) + ":" + number(to) + "]\n"; }

std::string quantity(const Rating& rating) { return rating.rotary ? "torque / Nm" : "force / N"; }

std::string tracking_plot(const JointPictures& paths, const std::string& data, const JointPictureData& content,
                          const Rating& rating) {
  std::string script = std::string(kPictureStart) + kTrackingLayout;
  script += "set output '" + paths.tracking + "'\nset multiplot\n";
  script += x_range(content.window_start_s, content.window_end_s);
  for (const auto& [from, to] : content.stance_s) {
    script += "set object rectangle from " + number(from) + ", graph 0 to " + number(to) +
              ", graph 1 behind fillcolor rgb \"#e9eff3\" fillstyle solid noborder\n";
  }
  script += "set tmargin at screen 0.92; set bmargin at screen 0.49; set format x ''\n";
  script += "set ylabel '" + quantity(rating) + "'\n";
  script += "plot keyentry with boxes fillstyle solid noborder fillcolor rgb '#dbe5eb' title 'stance (planned)', '" +
            data + "_window.dat' using 1:2 with lines ls 1 title 'reference', '' using 1:3 with lines ls 2 title '" +
            (rating.rotary ? "torque" : "force") + "', keyentry with lines ls 3 title 'reference − " +
            (rating.rotary ? "torque" : "force") + "'\n";
  script += "set tmargin at screen 0.45; set bmargin at screen 0.13\n";
  script += "set xlabel 'time / s' offset 0,0.4; set format x '%g'\n";
  script += "set ylabel 'error / " + std::string(rating.rotary ? "Nm" : "N") + "'\n";
  script += "plot '" + data + "_window.dat' using 1:4 with lines ls 3\n";
  return script + "unset multiplot\n";
}

std::string overview_plot(const JointPictures& paths, const std::string& data, const JointPictureData& content,
                          const Rating& rating) {
  std::string script = std::string(kPictureStart) + kOverviewLayout;
  script += "set output '" + paths.overview + "'\n" + x_range(0.0, content.run_end_s);
  script += "set ylabel '" + quantity(rating) + "'\n";
  script += "set object rectangle from " + number(content.window_start_s) + ", graph 0 to " +
            number(content.window_end_s) + ", graph 1 behind fillcolor rgb '#f3ead3' fillstyle solid noborder\n";
  const auto band = [](const char* colour) {
    return std::string(" with filledcurves fillstyle solid border lc rgb '") + colour + "' fillcolor rgb '" + colour +
           "'";
  };
  script += "plot keyentry with boxes fillstyle solid noborder fillcolor rgb '#eadbb4' title 'shown above', '" + data +
            "_run.dat' using 1:2:3" + band("#9aa5ad") + " title 'reference', '' using 1:4:5" + band("#d55e00") +
            " title 'error'\n";
  return script;
}

std::string datablock(const char* name, const control::ClosedLoopPoles& poles, double& largest) {
  // A loop without delay leaves states unused: poles at zero, up to the root of the rounding of a double one.
  constexpr double kUnused = 1e-6;
  std::string block = std::string("$") + name + " << EOD\nNaN NaN\n";  // never empty, which gnuplot refuses
  for (const std::complex<double>& pole : poles) {
    if (std::abs(pole) > kUnused) {
      block += number(pole.real()) + " " + number(pole.imag()) + "\n";
      largest = std::max(largest, std::abs(pole));
    }
  }
  return block + "EOD\n";
}

std::string poles_plot(const JointPictures& paths, const JointPoles& poles) {
  constexpr double kRoom = 1.12;
  double largest = 1.0;
  std::string script = kPictureStart + datablock("own", poles.stance_on_stance, largest) +
                       datablock("lifted", poles.stance_on_swing, largest) +
                       datablock("landed", poles.swing_on_stance, largest) + kPolesLayout;
  const std::string range = "[" + number(-kRoom * largest) + ":" + number(kRoom * largest) + "]\n";
  const auto title = [](const char* design, double spectral_radius) {
    return std::string(" title '") + design + ": spectral radius " + short_number(spectral_radius) + "'";
  };
  script += "set output '" + paths.poles + "'\nset xrange " + range + "set yrange " + range;
  script += "set object circle at 0,0 size 1 behind fillstyle solid 0.08 fillcolor rgb '#0072b2' linewidth 1\n";
  script += "plot $own using 1:2 with points pt 7 ps 0.8 lc rgb '#0072b2'" +
            title("stance design, stance load", poles.stance_spectral_radius) +
            ", $lifted using 1:2 with points pt 8 ps 1.2 lw 1.3 lc rgb '#009e73'" +
            title("stance design, swing load", poles.stance_on_swing_spectral_radius) +
            ", $landed using 1:2 with points pt 2 ps 1.1 lw 1.5 lc rgb '#d55e00'" +
            title("swing design, stance load", poles.swing_on_stance_spectral_radius) + "\n";
  return script;
}

}  // namespace

Result<std::vector<JointPictures>> draw_pictures(const std::string& out_dir, const ReportInput& input) {
  const robot::Robot& robot = input.robot;
  FARRIER_TRY(make_picture_folders(out_dir));
  const auto by_joint = rows_by_joint(robot, input.rows);
  const Tick ticks = input.rows.empty() ? 0 : std::ranges::max(input.rows, {}, &trace::TraceRow::tick).tick + 1;
  std::vector<JointPictures> pictures;
  std::string script;
  for (const robot::Joint& joint : robot.joints) {
    const std::string data = "data/" + joint.name;
    const auto content =
        write_picture_data(out_dir + "/" + data, robot, input.schedule, joint, by_joint[joint.number]);
    const auto poles = joint_poles(joint, robot.period_s, input.loop_delay_ticks);
    if (!content || !poles) {
      return content ? poles.error() : content.error();
    }
    const bool has_run = !by_joint[joint.number].empty();
    const std::string stem = "pictures/" + joint.name;
    pictures.push_back({.tracking = content.value().empty ? "" : stem + "_tracking.svg",
                        .overview = has_run ? stem + "_overview.svg" : "",
                        .poles = stem + "_poles.svg"});
    const Rating rating = rating_of(robot, joint);
    script += content.value().empty ? "" : tracking_plot(pictures.back(), data, content.value(), rating);
    script += has_run ? overview_plot(pictures.back(), data, content.value(), rating) : "";
    script += poles_plot(pictures.back(), poles.value());
    const AdaptationPicture adaptation{robot, joint, input.outcome.run.decisions, input.gains, input.loop_delay_ticks, ticks};
    if (adapted(adaptation)) {
      pictures.back().adaptation = stem + "_adaptation.svg";
      FARRIER_TRY(plot_adaptation(adaptation, out_dir, data, pictures.back().adaptation, script));
    }
  }
  FARRIER_TRY(draw(out_dir, script));
  return pictures;
}

}  // namespace farrier::report
