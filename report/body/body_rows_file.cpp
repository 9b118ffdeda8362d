#include "report/body/body_rows_file.hpp"

#include <nlohmann/json.hpp>

#include "report/body/energy_result.hpp"
#include "report/figures/kept_lines.hpp"

namespace farrier::report {
namespace {

using nlohmann::json;

json number_or_null(const std::optional<double>& number) { return number ? json(*number) : json(); }

std::optional<double> number_of(const json& value) {
  return value.is_null() ? std::nullopt : std::optional(value.get<double>());
}

json json_of(const std::optional<trials::SupplyFigures>& supply) {
  if (!supply) {
    return {};
  }
  return {{"low_s", number_or_null(supply->low_s)},
          {"sag_s", number_or_null(supply->sag_s)},
          {"slows_s", number_or_null(supply->slows_s)},
          {"acts_s", number_or_null(supply->acts_s)},
          {"lying_s", number_or_null(supply->lying_s)},
          {"largest_sinking_m_s", supply->largest_sinking_m_s},
          {"largest_foot_force_N", supply->largest_foot_force_N},
          {"recovers", supply->recovers},
          {"end_speed_m_s", supply->end_speed_m_s}};
}

std::optional<trials::SupplyFigures> supply_of(const json& supply) {
  if (supply.is_null()) {
    return std::nullopt;
  }
  return trials::SupplyFigures{.low_s = number_of(supply.at("low_s")),
                               .sag_s = number_of(supply.at("sag_s")),
                               .slows_s = number_of(supply.at("slows_s")),
                               .acts_s = number_of(supply.at("acts_s")),
                               .lying_s = number_of(supply.at("lying_s")),
                               .largest_sinking_m_s = supply.at("largest_sinking_m_s"),
                               .largest_foot_force_N = supply.at("largest_foot_force_N"),
                               .recovers = supply.at("recovers"),
                               .end_speed_m_s = supply.at("end_speed_m_s")};
}

json json_of(const world::EnergyAudit& energy) {
  json of;
  for (const world::EnergyTerm& term : world::kEnergyTerms) {
    of[term.name] = energy.*term.energy_J;
  }
  return of;
}

world::EnergyAudit energy_of(const json& energy) {
  world::EnergyAudit of;
  for (const world::EnergyTerm& term : world::kEnergyTerms) {
    of.*term.energy_J = energy.at(term.name);
  }
  return of;
}

json json_of(const trials::GainSwitches& switches) {
  return {{"planned", switches.planned},
          {"felt", switches.felt},
          {"late_touchdowns", switches.late_touchdowns},
          {"late_s", switches.late_s},
          {"largest_late_s", switches.largest_late_s}};
}

trials::GainSwitches switches_of(const json& switches) {
  return {.planned = switches.at("planned"),
          .felt = switches.at("felt"),
          .late_touchdowns = switches.at("late_touchdowns"),
          .late_s = switches.at("late_s"),
          .largest_late_s = switches.at("largest_late_s")};
}

json json_of(const trials::TrotRow& row) {
  const trials::TrotFigures& f = row.figures;
  return {{"trial", row.trial},
          {"name", row.name},
          {"fell_s", number_or_null(f.fell_s)},
          {"fall", f.fall},
          {"height_rms_m", f.height_rms_m},
          {"height_offset_m", f.height_offset_m},
          {"sag_m", f.sag_m},
          {"loaded_sag_m", number_or_null(f.loaded_sag_m)},
          {"tilt_rms_rad", f.tilt_rms_rad},
          {"speed_error", f.speed_error},
          {"odometry_error", number_or_null(f.odometry_error)},
          {"heading_drift_rad_s", f.heading_drift_rad_s},
          {"lateral_drift_m_s", number_or_null(f.lateral_drift_m_s)},
          {"largest_torque_Nm", f.largest_torque_Nm},
          {"force_nrmse", f.force_nrmse},
          {"switches", json_of(f.switches)},
          {"energy_error", f.energy_error},
          {"least_supply_Pa", f.least_supply_Pa},
          {"mean_flow_m3_s", f.mean_flow_m3_s},
          {"energy", json_of(f.energy)},
          {"way_m", f.way_m},
          {"finer", f.finer},
          {"supply", json_of(f.supply)},
          {"hash", f.hash}};
}

trials::TrotRow row_of(const json& line) {
  return {.trial = line.at("trial"),
          .name = line.at("name"),
          .figures = {.fell_s = number_of(line.at("fell_s")),
                      .fall = line.at("fall"),
                      .height_rms_m = line.at("height_rms_m"),
                      .height_offset_m = line.at("height_offset_m"),
                      .sag_m = line.at("sag_m"),
                      .loaded_sag_m = number_of(line.at("loaded_sag_m")),
                      .tilt_rms_rad = line.at("tilt_rms_rad"),
                      .speed_error = line.at("speed_error"),
                      .odometry_error = number_of(line.at("odometry_error")),
                      .heading_drift_rad_s = line.at("heading_drift_rad_s"),
                      .lateral_drift_m_s = number_of(line.at("lateral_drift_m_s")),
                      .largest_torque_Nm = line.at("largest_torque_Nm"),
                      .force_nrmse = line.at("force_nrmse").get<trials::ForceErrors>(),
                      .switches = switches_of(line.at("switches")),
                      .energy_error = line.at("energy_error"),
                      .least_supply_Pa = line.at("least_supply_Pa"),
                      .mean_flow_m3_s = line.at("mean_flow_m3_s"),
                      .energy = energy_of(line.at("energy")),
                      .way_m = line.at("way_m"),
                      .finer = line.at("finer"),
                      .supply = supply_of(line.at("supply")),
                      .hash = line.at("hash")},
          .failure = {}};
}

}  // namespace

Result<Done> append_row(const std::string& path, const std::string& origin, const trials::TrotRow& row) {
  return append_kept(path, origin, json_of(row));
}

std::vector<trials::TrotRow> read_rows(const std::string& path, const std::string& origin) {
  std::vector<trials::TrotRow> rows;
  for (const json& line : read_kept(path, origin)) {
    try {
      rows.push_back(row_of(line));
    } catch (const json::exception&) {  // no run, though its origin is right: it is run again
    }
  }
  return rows;
}

}  // namespace farrier::report
