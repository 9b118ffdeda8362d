#include "report/compare/bandwidth.hpp"

#include <cmath>

#include "core/units.hpp"
#include "report/figures/text_format.hpp"

namespace farrier::report {
namespace {

std::string hertz(const std::optional<double>& value_Hz) {
  return value_Hz ? std::to_string(std::lround(*value_Hz))
                  : ">" + std::to_string(std::lround(trials::ForceBandwidth::kHighest_Hz));
}

std::string cell(const trials::ForceBandwidth& one) {
  return one.swings ? "swings" : hertz(one.gain_Hz) + " / " + hertz(one.phase_Hz);
}

}  // namespace

void add_bandwidth(Figures& figures, std::span<const BandwidthRow> rows) {
  for (const BandwidthRow& row : rows) {
    for (std::size_t i = 0; row.typical && i < row.of.size(); ++i) {
      const std::string prefix = "compare.bandwidth." + row.joint + "." + kBandwidthDesigns[i].name + ".";
      if (row.of[i].gain_Hz) {
        figures.add(prefix + "gain_Hz", *row.of[i].gain_Hz);
      }
      if (row.of[i].phase_Hz) {
        figures.add(prefix + "phase_Hz", *row.of[i].phase_Hz);
      }
    }
  }
}

std::string bandwidth_text(std::span<const BandwidthRow> rows) {
  std::vector<std::vector<std::string>> lines{{"joint", "pose (deg)", "sine (Nm)"}};
  for (const BandwidthDesign& design : kBandwidthDesigns) {
    lines.back().emplace_back(design.title);
  }
  lines.back().insert(lines.back().end(), {"spool", "full flow"});
  for (const BandwidthRow& row : rows) {
    std::vector<std::string>& line = lines.emplace_back();
    line = {row.joint, std::to_string(std::lround(kDegrees * row.angle_rad)), short_number(row.amplitude_Nm)};
    for (const trials::ForceBandwidth& one : row.of) {
      line.push_back(cell(one));
    }
    line.push_back(row.spool_Hz ? std::to_string(std::lround(*row.spool_Hz)) : "-");
    line.push_back(std::to_string(std::lround(row.full_flow_Hz)));
  }
  return aligned(lines);
}

}  // namespace farrier::report
