#include "trace/body_trace.hpp"

namespace farrier::trace {
namespace {

constexpr std::size_t kAxes = 3;

std::string header(int legs) {
  std::string text =
      "tick,x_m,y_m,z_m,attitude_w,attitude_x,attitude_y,attitude_z,velocity_x_m_s,velocity_y_m_s,velocity_z_m_s,"
      "rate_x_rad_s,rate_y_rad_s,rate_z_rad_s,push_x_N,push_y_N,push_z_N";
  for (int leg = 0; leg < legs; ++leg) {
    for (const char* axis : {"x", "y", "z"}) {
      text += ",foot" + std::to_string(leg) + "_" + axis + "_N";
    }
  }
  return text;
}

/// Calls visit(number) for every number behind the tick, in column order.
template <class Truth, class Visit>
void visit_columns(Truth& truth, int legs, Visit&& visit) {
  for (auto* numbers :
       {&truth.position_m[0], &truth.velocity_m_s[0], &truth.angular_velocity_rad_s[0], &truth.push_N[0]}) {
    for (std::size_t i = 0; i < kAxes; ++i) {
      visit(numbers[i]);
    }
    if (numbers == &truth.position_m[0]) {
      for (auto& number : truth.attitude) {
        visit(number);
      }
    }
  }
  for (std::size_t i = 0; i < kAxes * static_cast<std::size_t>(legs); ++i) {
    visit(truth.foot_force_N[i]);
  }
}

}  // namespace

std::string body_trace_path(const std::string& trace_path) { return path_beside(trace_path, "body"); }

Result<BodyTraceWriter> BodyTraceWriter::create(const std::string& path, int legs) {
  return BodyTraceWriter(FARRIER_TRY(LineFile::create(path, header(legs))), legs);
}

char* BodyTraceWriter::format(const signals::BodyTruth& truth, char* line) const noexcept {
  return format_numbers(truth.tick, line, line + kLongestLine, [&](auto put) { visit_columns(truth, legs_, put); });
}

void BodyTraceWriter::write(const signals::BodyTruth& truth) {
  char line[kLongestLine];
  write_lines({line, static_cast<std::size_t>(format(truth, line) - line)});
}

Result<std::vector<signals::BodyTruth>> read_body_trace(const std::string& path, int legs) {
  return read_numbers<signals::BodyTruth>(
      path, header(legs), "the trace of a body with " + std::to_string(legs) + " legs",
      [](signals::BodyTruth& row) -> Tick& { return row.tick; },
      [legs](signals::BodyTruth& row, auto& read) { visit_columns(row, legs, read); });
}

}  // namespace farrier::trace
