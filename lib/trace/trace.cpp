#include "trace/trace.hpp"

#include <algorithm>
#include <charconv>
#include <fstream>

namespace farrier::trace {
namespace {

constexpr const char* kHeader =
    "tick,joint,position_m_or_rad,velocity_m_s_or_rad_s,force_N_or_Nm,pressure_a_Pa,pressure_b_Pa,"
    "force_reference_N_or_Nm,valve_current_A,external_force_N_or_Nm,load_mass_kg_or_kgm2,phase,actual_phase,state,"
    "generation,faults,command_age_ticks";

/// Calls visit(field) for every number behind the joint's name, in column order.
template <class Row, class Visit>
void visit_columns(Row& row, Visit&& visit) {
  visit(row.position_m_or_rad);
  visit(row.velocity_m_s_or_rad_s);
  visit(row.force_N_or_Nm);
  visit(row.pressure_a_Pa);
  visit(row.pressure_b_Pa);
  visit(row.force_reference_N_or_Nm);
  visit(row.valve_current_A);
  visit(row.external_force_N_or_Nm);
  visit(row.load_mass_kg_or_kgm2);
  visit(row.phase);
  visit(row.actual_phase);
  visit(row.state);
  visit(row.generation);
  visit(row.faults);
  visit(row.command_age_ticks);
}

}  // namespace

Result<TraceWriter> TraceWriter::create(const std::string& path, std::vector<std::string> joint_names) {
  return TraceWriter(FARRIER_TRY(LineFile::create(path, kHeader)), std::move(joint_names));
}

char* TraceWriter::format(const TraceRow& row, char* line) const noexcept {
  char* const end = line + kLongestLine - 2;
  char* at = std::to_chars(line, end, row.tick).ptr;
  *at++ = ',';
  const std::string& name = joint_names_[row.joint];
  at = std::copy_n(name.data(), std::min<std::size_t>(name.size(), 64), at);
  visit_columns(row, [&](auto field) {
    *at++ = ',';
    if constexpr (std::is_enum_v<decltype(field)>) {
      at = std::to_chars(at, end, static_cast<unsigned>(field)).ptr;
    } else {
      at = std::to_chars(at, end, field).ptr;
    }
  });
  *at++ = '\n';
  return at;
}

void TraceWriter::write(const TraceRow& row) {
  char line[kLongestLine];
  write_lines({line, format(row, line)});
}

Result<std::vector<TraceRow>> read_trace(const std::string& path, const std::vector<std::string>& joint_names) {
  std::ifstream file(path);
  std::string line;
  if (!std::getline(file, line) || line != kHeader) {
    return Error{path + ":1: not a trace of this version"};
  }
  std::vector<TraceRow> rows;
  for (int number = 2; std::getline(file, line); ++number) {
    TraceRow row;
    const char* at = line.data();
    const char* const end = at + line.size();
    bool good = true;
    const auto parse = [&](auto& field) {
      const auto result = std::from_chars(at, end, field);
      good = good && result.ec == std::errc{} && (result.ptr == end || *result.ptr == ',');
      at = result.ptr == end ? end : result.ptr + 1;
    };
    parse(row.tick);
    const char* const comma = std::find(at, end, ',');
    const auto name = std::find(joint_names.begin(), joint_names.end(), std::string_view(at, comma));
    good = good && name != joint_names.end() && comma != end;
    if (good) {
      row.joint = static_cast<std::uint16_t>(name - joint_names.begin());
      at = comma + 1;
      visit_columns(row, [&]<class Field>(Field& field) {
        if constexpr (std::is_enum_v<Field>) {
          std::uint8_t value = 0;
          parse(value);
          field = static_cast<Field>(value);
        } else {
          parse(field);
        }
      });
    }
    if (!good || at != end || line.back() == ',') {
      return Error{path + ":" + std::to_string(number) + ": not a row of a trace"};
    }
    rows.push_back(row);
  }
  return rows;
}

}  // namespace farrier::trace
