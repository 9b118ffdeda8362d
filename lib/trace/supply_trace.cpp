#include "trace/supply_trace.hpp"

namespace farrier::trace {
namespace supply_trace_parts {
namespace {

constexpr const char* kHeader =
    "tick,pressure_Pa,flow_m3_s,pump_flow_m3_s,relief_flow_m3_s,leakage_flow_m3_s,power_W,pump_J,accumulator_J,relief_"
    "J,"
    "supply_leakage_J,valve_J,leakage_J,return_J,oil_J,friction_J,work_J";

/// Calls visit(number) for every number behind the tick, in column order.
template <class Row, class Visit>
void visit_columns(Row& row, Visit&& visit) {
  auto& [state, truth] = row;
  visit(state.pressure_Pa);
  visit(state.flow_m3_s);
  visit(state.pump_flow_m3_s);
  visit(state.relief_flow_m3_s);
  visit(state.leakage_flow_m3_s);
  visit(state.power_W);
  visit(truth.pump_J);
  visit(truth.accumulator_J);
  visit(truth.relief_J);
  visit(truth.supply_leakage_J);
  visit(truth.valve_J);
  visit(truth.leakage_J);
  visit(truth.return_J);
  visit(truth.oil_J);
  visit(truth.friction_J);
  visit(truth.work_J);
}

}  // namespace
}  // namespace supply_trace_parts

std::string supply_trace_path(const std::string& trace_path) { return path_beside(trace_path, "supply"); }

Result<SupplyTraceWriter> SupplyTraceWriter::create(const std::string& path) {
  return SupplyTraceWriter(FARRIER_TRY(LineFile::create(path, supply_trace_parts::kHeader)));
}

char* SupplyTraceWriter::format(const SupplyRow& row, char* line) const noexcept {
  return format_numbers(row.state.tick, line, line + kLongestLine,
                        [&](auto put) { supply_trace_parts::visit_columns(row, put); });
}

void SupplyTraceWriter::write(const SupplyRow& row) {
  char line[kLongestLine];
  write_lines({line, static_cast<std::size_t>(format(row, line) - line)});
}

Result<std::vector<SupplyRow>> read_supply_trace(const std::string& path) {
  auto rows = FARRIER_TRY(read_numbers<SupplyRow>(
      path, supply_trace_parts::kHeader, "the trace of a supply",
      [](SupplyRow& row) -> Tick& { return row.state.tick; },
      [](SupplyRow& row, auto& read) { supply_trace_parts::visit_columns(row, read); }));
  for (SupplyRow& row : rows) {
    row.truth.tick = row.state.tick;
  }
  return rows;
}

}  // namespace farrier::trace
