#include "tools/faults/cells_file.hpp"

#include <cerrno>
#include <cstring>
#include <fstream>
#include <nlohmann/json.hpp>

namespace farrier::faults {
namespace {

using nlohmann::json;

json to_json(const CellsOrigin& origin) {
  return {{"git_revision", origin.git_revision}, {"configuration_hash", origin.configuration_hash},
          {"slow", origin.slow}};
}

json to_json(const Cell& cell) {
  json checks = json::array();
  for (const Check& check : cell.checks) {
    checks.push_back({{"key", check.key}, {"what", check.what}, {"asked_s", check.asked_s},
                      {"measured_s", check.measured_s}});
  }
  return {{"row", cell.row},   {"phase", cell.phase},     {"vendor", cell.vendor},
          {"seed", cell.seed}, {"repeats", cell.repeats}, {"checks", std::move(checks)}};
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
  return cell;
}

/// The last line of a run that was killed may lack its end.
bool ends_within_a_line(const std::string& path) {
  std::ifstream file(path, std::ios::binary | std::ios::ate);
  return file && file.tellg() > 0 && file.seekg(-1, std::ios::end) && file.get() != '\n';
}

}  // namespace

Result<Done> append_cell(const std::string& path, const CellsOrigin& origin, const Cell& cell) {
  json line = to_json(cell);
  line["origin"] = to_json(origin);
  const bool cut_off = ends_within_a_line(path);
  std::ofstream file(path, std::ios::app);
  file << (cut_off ? "\n" : "") << line.dump() << '\n';
  file.flush();
  if (!file) {
    return Error{"cannot write " + path + ": " + std::strerror(errno)};
  }
  return Done{};
}

std::vector<Cell> read_cells(const std::string& path, const CellsOrigin& origin) {
  std::vector<Cell> cells;
  std::ifstream file(path);
  for (std::string text; std::getline(file, text);) {
    try {
      const json line = json::parse(text);
      if (line.at("origin") == to_json(origin)) {
        cells.push_back(cell_of(line));
      }
    } catch (const json::exception&) {  // the last one of a run that was killed
    }
  }
  return cells;
}

}  // namespace farrier::faults
