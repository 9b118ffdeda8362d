#include "tools/faults/cells_file.hpp"

#include <nlohmann/json.hpp>

#include "report/figures/kept_lines.hpp"

namespace farrier::faults {
namespace {

using nlohmann::json;

json to_json(const CellsOrigin& origin) {
  return {{"git_revision", origin.git_revision},
          {"configuration_hash", origin.configuration_hash},
          {"slow", origin.slow},
          {"world", origin.world}};
}

json to_json(const Cell& cell) {
  json checks = json::array();
  for (const Check& check : cell.checks) {
    checks.push_back(
        {{"key", check.key}, {"what", check.what}, {"asked_s", check.asked_s}, {"measured_s", check.measured_s}});
  }
  json line{{"row", cell.row},   {"phase", cell.phase},     {"vendor", cell.vendor},
            {"seed", cell.seed}, {"repeats", cell.repeats}, {"checks", std::move(checks)}};
  if (cell.body) {
    line["body"] = {{"fell", cell.body->fell},
                    {"not_walking_s", cell.body->not_walking_s},
                    {"trunk_speed_m_s", cell.body->trunk_speed_m_s},
                    {"ground_force_N", cell.body->ground_force_N}};
  }
  return line;
}

Cell cell_of(const json& line) {
  Cell cell{.row = line.at("row"),
            .phase = line.at("phase"),
            .vendor = line.at("vendor"),
            .seed = line.at("seed"),
            .repeats = line.at("repeats"),
            .error = {},
            .checks = {}};
  for (const json& check : line.at("checks")) {
    cell.checks.push_back({check.at("key"), check.at("what"), check.at("asked_s"), check.at("measured_s")});
  }
  if (line.contains("body")) {
    const json& body = line["body"];
    cell.body = BodyAfterFault{body.at("fell"), body.at("not_walking_s"), body.at("trunk_speed_m_s"),
                               body.at("ground_force_N")};
  }
  return cell;
}

}  // namespace

Result<Done> append_cell(const std::string& path, const CellsOrigin& origin, const Cell& cell) {
  return report::append_kept(path, to_json(origin), to_json(cell));
}

std::vector<Cell> read_cells(const std::string& path, const CellsOrigin& origin) {
  std::vector<Cell> cells;
  for (const json& line : report::read_kept(path, to_json(origin))) {
    try {
      cells.push_back(cell_of(line));
    } catch (const json::exception&) {  // no cell, though its origin is right: it is run again
    }
  }
  return cells;
}

}  // namespace farrier::faults
