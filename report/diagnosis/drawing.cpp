#include "report/diagnosis/drawing.hpp"

#include <algorithm>
#include <cmath>

#include "config/visitor.hpp"
#include "report/page/gnuplot.hpp"

namespace farrier::report {

std::string line_of(const std::vector<double>& values) {
  std::string line;
  for (const double value : values) {
    line += (line.empty() ? "" : " ") + (std::isfinite(value) ? config::number_text(value) : "nan");
  }
  return line + "\n";
}

bool has_points(const std::vector<double>& values) {
  return std::ranges::count_if(values, [](double value) { return std::isfinite(value); }) >= 2;
}

std::string Drawing::data(const std::string& name, const std::string& lines) {
  const std::string path = "data/" + name + ".dat";
  if (kept) {
    kept = write_plot_data(out_dir + "/" + path, lines);
  }
  return path;
}

std::string round_picture(Drawing& drawing, std::vector<diagnosis::Candidate> candidates, std::size_t round) {
  std::ranges::sort(candidates, {}, [](const diagnosis::Candidate& one) { return one.gain.log_ratio; });
  std::string lines;
  std::string tics;
  for (std::size_t i = 0; i < candidates.size(); ++i) {
    const diagnosis::Candidate& one = candidates[i];
    lines += line_of({static_cast<double>(i), one.gain.log_ratio, one.gain.low, one.gain.high,
                      one.accepted ? 1.0 : 0.0});
    tics += (i == 0 ? "'" : ", '") + std::string(plant::effect_info(one.id).name) + "' " + std::to_string(i);
  }
  const std::string name = "round_" + std::to_string(round + 1);
  const std::string data = drawing.data(name, lines);
  const std::string path = "pictures/" + name + ".svg";
  drawing.script += std::string(kPictureStart) + "set terminal svg size 720," +
                    std::to_string(90 + 22 * candidates.size()) +
                    " font \"sans-serif,11\" noenhanced background \"#ffffff\"\nset key off\nset output '" + path +
                    "'\nset yrange [-0.7:" + config::number_text(static_cast<double>(candidates.size()) - 0.3) +
                    "]\nset ytics (" + tics +
                    ")\nunset grid; set grid xtics ls 9\nset yzeroaxis lt 1 lc rgb '#667078'\n"
                    "set style fill solid noborder\n"
                    "set xlabel 'ln of held-out error before over after, with its 95 % interval' offset 0,0.4\nplot '" +
                    data + "' using ($2/2):1:(abs($2)/2):(0.35):($5 > 0 ? 0x0072b2 : 0xb8c4cc) with boxxyerror lc rgb "
                    "variable, '' using 2:1:3:4 with xerrorbars pt 0 lc rgb '#1c2226'\n";
  return path;
}

}  // namespace farrier::report
