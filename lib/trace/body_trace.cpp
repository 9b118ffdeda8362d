#include "trace/body_trace.hpp"

#include <cerrno>
#include <charconv>
#include <cstring>
#include <filesystem>
#include <fstream>

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
  for (auto* numbers : {&truth.position_m[0], &truth.velocity_m_s[0], &truth.angular_velocity_rad_s[0],
                        &truth.push_N[0]}) {
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

std::string body_trace_path(const std::string& trace_path) {
  const std::filesystem::path path(trace_path);
  return (path.parent_path() / (path.stem().string() + "_body" + path.extension().string())).string();
}

Result<BodyTraceWriter> BodyTraceWriter::create(const std::string& path, int legs) {
  std::FILE* file = std::fopen(path.c_str(), "w");
  if (file == nullptr) {
    return Error{"cannot write the trace " + path + ": " + std::strerror(errno)};
  }
  BodyTraceWriter writer(file, legs);
  std::fprintf(file, "%s\n", header(legs).c_str());
  return writer;
}

char* BodyTraceWriter::format(const signals::BodyTruth& truth, char* line) const noexcept {
  char* const end = line + kLongestLine - 2;
  char* at = std::to_chars(line, end, truth.tick).ptr;
  visit_columns(truth, legs_, [&](double number) {
    *at++ = ',';
    at = std::to_chars(at, end, number).ptr;
  });
  *at++ = '\n';
  return at;
}

void BodyTraceWriter::write(const signals::BodyTruth& truth) {
  char line[kLongestLine];
  write_lines({line, static_cast<std::size_t>(format(truth, line) - line)});
}

void BodyTraceWriter::write_lines(std::string_view lines) {
  std::fwrite(lines.data(), 1, lines.size(), file_.get());
}

bool BodyTraceWriter::finish() { return std::fflush(file_.get()) == 0 && std::ferror(file_.get()) == 0; }

Result<std::vector<signals::BodyTruth>> read_body_trace(const std::string& path, int legs) {
  std::ifstream file(path);
  std::string line;
  if (!std::getline(file, line) || line != header(legs)) {
    return Error{path + ":1: not the trace of a body with " + std::to_string(legs) + " legs of this version"};
  }
  std::vector<signals::BodyTruth> rows;
  for (int number = 2; std::getline(file, line); ++number) {
    signals::BodyTruth row;
    const char* at = line.data();
    const char* const end = at + line.size();
    bool good = true;
    const auto read = [&](auto& value) {
      const auto got = std::from_chars(at, end, value);
      good = good && got.ec == std::errc();
      at = got.ptr != end && *got.ptr == ',' ? got.ptr + 1 : got.ptr;
    };
    read(row.tick);
    visit_columns(row, legs, read);
    if (!good || at != end) {
      return Error{path + ":" + std::to_string(number) + ": not a line of a body's trace"};
    }
    rows.push_back(row);
  }
  return rows;
}

}  // namespace farrier::trace
