#include "report/body/body_result.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <sstream>

#include "core/replace_file.hpp"
#include "core/units.hpp"
#include "report/figures/text_format.hpp"

namespace farrier::report {
namespace {

constexpr double kMillimetres = 1e3;
constexpr double kPercent = 100.0;
constexpr double kPerMinute = 60.0;
constexpr double kDegreesPerMinute = kPerMinute * kDegrees;

// Bounds of the runs on flat ground.
constexpr double kHeightRms_mm = 10.0;
constexpr double kHeightOffset_mm = 15.0;
constexpr double kLoadedSag_mm = 10.0;
constexpr double kTiltRms_deg = 1.0;
constexpr double kSpeedError_percent = 5.0;
constexpr double kOdometryError_percent = 2.0;
constexpr double kHeadingDrift_deg_min = 1.0;
constexpr double kLateralDrift_m_min = 0.2;
constexpr double kEnergyError_percent = 1.0;
constexpr double kLeastWay_m = 1.0;  // of an energy per way
// Part of the runs over obstacles that must stay upright.
constexpr double kUprightShare = 0.95;

bool has_obstacles(const std::string& trial) { return trial == "blocks" || trial == "step"; }
bool is_search(const std::string& trial) { return trial == trials::PushLimitSearch::kTrial; }
// Falls with a stuck valve are judged with the landings.
bool is_judged(const std::string& trial) {
  return trial != "long_lag" && !trials::trot_trial(trial).valve_sticks && !is_search(trial);
}
bool is_judged_closely(const std::string& trial) { return trial == "flat"; }

void take_larger(double& largest, double value) { largest = std::max(largest, std::abs(value)); }

void add_row(const trials::TrotFigures& figures, BodyTrialResult& result) {
  take_larger(result.largest_torque_Nm, figures.largest_torque_Nm);
  if (figures.fell_s) {
    ++result.falls;
    return;
  }
  for (std::size_t place = 0; place < figures.force_nrmse.size(); ++place) {
    for (std::size_t phase = 0; phase < kPhaseCount; ++phase) {
      take_larger(result.force_nrmse[place][phase], figures.force_nrmse[place][phase]);
    }
  }
  if (figures.least_supply_Pa > 0.0) {
    take_larger(result.energy_error_percent, kPercent * figures.energy_error);
    const double least_bar = figures.least_supply_Pa / kPascalPerBar;
    result.least_supply_bar = std::min(result.least_supply_bar.value_or(least_bar), least_bar);
    result.mean_flow_l_min = std::max(result.mean_flow_l_min.value_or(0.0), kLitrePerMinute * figures.mean_flow_m3_s);
    if (figures.way_m > kLeastWay_m) {
      const double energy_J_m = (figures.energy.pump_J - figures.energy.relief_J) / figures.way_m;
      result.energy_J_m = std::max(result.energy_J_m.value_or(0.0), energy_J_m);
    }
  }
  take_larger(result.height_rms_mm, kMillimetres * figures.height_rms_m);
  take_larger(result.height_offset_mm, kMillimetres * figures.height_offset_m);
  take_larger(result.sag_mm, kMillimetres * figures.sag_m);
  if (figures.loaded_sag_m) {
    result.loaded_sag_mm = std::max(result.loaded_sag_mm.value_or(0.0), kMillimetres * *figures.loaded_sag_m);
  }
  take_larger(result.tilt_rms_deg, kDegrees * figures.tilt_rms_rad);
  take_larger(result.speed_error_percent, kPercent * figures.speed_error);
  if (figures.odometry_error) {
    result.odometry_error_percent =
        std::max(result.odometry_error_percent.value_or(0.0), kPercent * *figures.odometry_error);
  }
  take_larger(result.heading_drift_deg_min, kDegreesPerMinute * figures.heading_drift_rad_s);
  if (figures.lateral_drift_m_s) {
    result.lateral_drift_m_min =
        std::max(result.lateral_drift_m_min.value_or(0.0), kPerMinute * std::abs(*figures.lateral_drift_m_s));
  }
}

// The means of pushes that are made to fall, and of robots that become slower or lie down for a fault, say nothing.
bool has_means(const BodyTrialResult& result) {
  return result.falls < result.runs && !is_search(result.trial) && result.trial != "low_supply" &&
         result.trial != "pump_stops" && !trials::trot_trial(result.trial).valve_sticks;
}

/// Figures of simulated actuators and their supply, where there are any.
template <class Add>
void add_actuators(const BodyTrialResult& result, const Add& add, std::optional<double> energy_limit) {
  for_each_force_error([&](std::size_t place, std::size_t phase, const std::string& name) {
    if (result.force_nrmse[place][phase] > 0.0) {
      add(("force_nrmse." + name).c_str(), result.force_nrmse[place][phase], std::nullopt);
    }
  });
  if (result.least_supply_bar) {
    add("energy_error_percent", result.energy_error_percent, energy_limit);
    add("least_supply_bar", *result.least_supply_bar, std::nullopt);
    add("mean_flow_l_min", *result.mean_flow_l_min, std::nullopt);
  }
  if (result.energy_J_m) {
    add("energy_J_m", *result.energy_J_m, std::nullopt);
  }
}

void add_result(Figures& figures, const BodyTrialResult& result) {
  const auto bound = [](bool bounded, double value) { return bounded ? std::optional(value) : std::nullopt; };
  const bool closely = is_judged_closely(result.trial);
  const bool obstacles = has_obstacles(result.trial);
  const auto add = [&](const char* name, double value, std::optional<double> limit = std::nullopt) {
    figures.add("body." + result.trial + "." + name, value, limit);
  };
  add("runs", static_cast<double>(result.runs));
  add("falls", static_cast<double>(result.falls), bound(is_judged(result.trial) && !obstacles, 0.0));
  add("upright_share", result.upright_share(), bound(obstacles, kUprightShare));
  add("largest_torque_Nm", result.largest_torque_Nm);
  if (!has_means(result)) {
    if (result.least_supply_bar) {
      add("least_supply_bar", *result.least_supply_bar);
    }
    return;
  }
  add("height_rms_mm", result.height_rms_mm, bound(closely, kHeightRms_mm));
  add("height_offset_mm", result.height_offset_mm, bound(closely, kHeightOffset_mm));
  add("sag_mm", result.sag_mm);
  if (result.loaded_sag_mm) {
    add("sag_after_2_s_mm", *result.loaded_sag_mm, kLoadedSag_mm);
  }
  add("tilt_rms_deg", result.tilt_rms_deg, bound(closely, kTiltRms_deg));
  add("speed_error_percent", result.speed_error_percent, bound(closely, kSpeedError_percent));
  if (result.odometry_error_percent) {
    add("odometry_error_percent", *result.odometry_error_percent, bound(closely, kOdometryError_percent));
  }
  add("heading_drift_deg_min", result.heading_drift_deg_min, bound(closely, kHeadingDrift_deg_min));
  if (result.lateral_drift_m_min) {
    add("lateral_drift_m_min", *result.lateral_drift_m_min, bound(closely, kLateralDrift_m_min));
  }
  add_actuators(result, add, bound(closely, kEnergyError_percent));
}

std::string fixed(double value, int digits) {
  char text[32];
  std::snprintf(text, sizeof text, "%.*f", digits, value);
  return text;
}

std::string verdict_of(const Figures& figures, const std::string& trial) {
  bool bounded = false;
  for (const Figure& figure : figures.all()) {
    if (figure.name.starts_with("body." + trial + ".") && figure.bound) {
      bounded = true;
      if (!figure.holds()) {
        return "fail";
      }
    }
  }
  return bounded ? "pass" : "-";
}

std::vector<std::string> cells_of(const Figures& figures, const BodyTrialResult& result) {
  std::vector<std::string> cells{result.trial, std::to_string(result.runs), std::to_string(result.falls)};
  if (!has_means(result)) {
    cells.insert(cells.end(), 8, "-");
  } else {
    for (const double value : {result.height_rms_mm, result.height_offset_mm, result.sag_mm}) {
      cells.push_back(fixed(value, 1));
    }
    cells.push_back(fixed(result.tilt_rms_deg, 2));
    cells.push_back(fixed(result.speed_error_percent, 2));
    cells.push_back(result.odometry_error_percent ? fixed(*result.odometry_error_percent, 2) : "-");
    cells.push_back(fixed(result.heading_drift_deg_min, 2));
    cells.push_back(result.lateral_drift_m_min ? fixed(*result.lateral_drift_m_min, 2) : "-");
  }
  cells.push_back(fixed(result.largest_torque_Nm, 0));
  cells.push_back(verdict_of(figures, result.trial));
  return cells;
}

}  // namespace

double BodyTrialResult::upright_share() const noexcept {
  return runs == 0 ? 0.0 : static_cast<double>(runs - falls) / static_cast<double>(runs);
}

std::vector<BodyTrialResult> body_results(std::span<const trials::TrotRow> rows) {
  std::vector<BodyTrialResult> results;
  for (const trials::TrotTrial& trial : trials::kTrotTrials) {
    BodyTrialResult result;
    result.trial = trial.name;
    for (const trials::TrotRow& row : rows) {
      if (row.trial == trial.name && row.failure.empty()) {
        ++result.runs;
        add_row(row.figures, result);
      }
    }
    if (result.runs > 0) {
      results.push_back(result);
    }
  }
  return results;
}

void add_body(Figures& figures, std::span<const BodyTrialResult> results) {
  for (const BodyTrialResult& result : results) {
    add_result(figures, result);
  }
}

std::string body_text(const Figures& figures, std::span<const BodyTrialResult> results) {
  std::vector<std::vector<std::string>> rows{
      {"trial", "runs", "falls", "height rms", "offset", "sag", "tilt", "speed", "odometry", "heading", "drift",
       "torque", "verdict"},
      {"", "", "", "mm", "mm", "mm", "deg", "%", "%", "deg/min", "m/min", "Nm", ""}};
  for (const BodyTrialResult& result : results) {
    rows.push_back(cells_of(figures, result));
  }
  return aligned(rows);
}

void add_push_limits(Figures& figures, std::span<const trials::PushLimit> limits) {
  for (const trials::PushLimit& limit : limits) {
    if (limit.half_Ns) {
      figures.add(std::string("body.push_limit.") + limit.side + "_Ns", *limit.half_Ns);
    }
  }
}

std::string push_limits_text(std::span<const trials::PushLimit> limits) {
  std::string text;
  for (const trials::PushLimit& limit : limits) {
    text += std::string("pushes from ") + limit.side + ": " +
            (limit.half_Ns
                 ? "half fall at " + fixed(*limit.half_Ns, 1) + " Ns, fewer at " + fixed(limit.fewer_Ns, 1) + " Ns"
                 : "fewer than half fall up to " + fixed(limit.fewer_Ns, 1) + " Ns, the largest tried") +
            "\n";
  }
  return text;
}

std::string falls_text(std::span<const trials::TrotRow> rows) {
  std::string text;
  for (const trials::TrotRow& row : rows) {
    if (row.failure.empty() && row.figures.fell_s && !is_search(row.trial)) {
      text += "fell: " + row.trial + ", " + row.name + ", at " + fixed(*row.figures.fell_s, 3) +
              " s: " + row.figures.fall + "\n";
    }
  }
  return text;
}

Result<Done> write_body_csv(const std::string& path, std::span<const trials::TrotRow> rows) {
  std::ostringstream file;
  file << "trial,run,fell_s,fall,height_rms_m,height_offset_m,sag_m,tilt_rms_rad,speed_error,odometry_error,"
          "heading_drift_rad_s,lateral_drift_m_s,largest_torque_Nm,hash\n";
  for (const trials::TrotRow& row : rows) {
    const trials::TrotFigures& f = row.figures;
    file << row.trial << ",\"" << row.name << "\"," << (f.fell_s ? fixed(*f.fell_s, 3) : "") << ",\"" << f.fall << "\","
         << f.height_rms_m << ',' << f.height_offset_m << ',' << f.sag_m << ',' << f.tilt_rms_rad << ','
         << f.speed_error << ',';
    if (f.odometry_error) {
      file << *f.odometry_error;
    }
    file << ',' << f.heading_drift_rad_s << ',';
    if (f.lateral_drift_m_s) {
      file << *f.lateral_drift_m_s;
    }
    file << ',' << f.largest_torque_Nm << ',' << std::hex << f.hash << std::dec << '\n';
  }
  return replace_file(path, file.str());
}

}  // namespace farrier::report
