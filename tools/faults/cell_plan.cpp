#include "tools/faults/cell_plan.hpp"

#include <algorithm>
#include <map>
#include <tuple>

#include "core/noise.hpp"

namespace farrier::faults {

Cell CellPlan::cell() const {
  return {.row = row->name,
          .phase = phase == gait::Phase::kStance ? "stance" : "swing",
          .vendor = vendor,
          .seed = seed,
          .repeats = 0,
          .error = {},
          .checks = {}};
}

std::string place_text(const Cell& cell) {
  return cell.row + ", " + cell.phase + ", " + cell.vendor + ", seed " + std::to_string(cell.seed);
}

Result<std::vector<const Row*>> chosen_rows(const std::vector<std::string>& names, Where robot) {
  for (const std::string& name : names) {
    const Row* row = find_row(name);
    if (row == nullptr) {
      std::string known;
      for (const Row& each : rows()) {
        known += (known.empty() ? "" : ", ") + std::string(each.name);
      }
      return Error{"--rows: no row is called '" + name + "': " + known};
    }
    if (!is_row_of(*row, robot)) {
      return Error{"--rows: " + name + " does not happen to " +
                   (robot == Where::kBench ? "joints on a bench: leave it out, or add --world body"
                                           : "this robot on a ground: leave it out, or add --world bench")};
    }
  }
  std::vector<const Row*> chosen;
  for (const Row& row : rows()) {
    if (is_row_of(row, robot) && (names.empty() || std::ranges::find(names, row.name) != names.end())) {
      chosen.push_back(&row);
    }
  }
  return chosen;
}

std::vector<CellPlan> plan_cells(const std::vector<const Row*>& rows, const std::vector<std::string>& vendors,
                                 int seeds) {
  std::vector<CellPlan> plans;
  for (int seed = 1; seed <= seeds; ++seed) {
    for (const Row* row : rows) {
      for (const std::string& vendor : vendors) {
        for (const gait::Phase phase : {gait::Phase::kStance, gait::Phase::kSwing}) {
          plans.push_back({row, phase, vendor, static_cast<std::uint64_t>(seed)});
        }
      }
    }
  }
  return plans;
}

std::vector<CellPlan> draw_cells(const std::vector<CellPlan>& plans, std::size_t count, std::uint64_t seed) {
  struct Lot {
    int of_row;  ///< number of the row's cells before this one
    double chance;
    std::size_t plan;
  };
  std::vector<Lot> lots;
  for (std::size_t i = 0; i < plans.size(); ++i) {
    // By its place, so that the chance of a cell does not depend on the other cells.
    lots.push_back({0, NoiseStream(seed, place_text(plans[i].cell()), "draw").uniform(0), i});
  }
  std::ranges::sort(lots, {}, [](const Lot& lot) { return std::tuple(lot.chance, lot.plan); });
  std::map<const Row*, int> of_row;
  for (Lot& lot : lots) {
    lot.of_row = of_row[plans[lot.plan].row]++;
  }
  std::ranges::stable_sort(lots, {}, &Lot::of_row);
  std::vector<CellPlan> drawn;
  for (std::size_t i = 0; i < std::min(count, lots.size()); ++i) {
    drawn.push_back(plans[lots[i].plan]);
  }
  return drawn;
}

}  // namespace farrier::faults
