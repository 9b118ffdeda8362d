#pragma once

#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <functional>
#include <numbers>
#include <string>
#include <vector>

#include "core/noise.hpp"
#include "diagnosis/data/recording.hpp"
#include "tests/unit/robot/test_files.hpp"

namespace farrier::diagnosis {

/// A joint of HyQ on its load, moved by two sines that leave the stops alone; noise as in the robot file.
struct TestBench {
  std::size_t samples = 2000;
  double period_s = 0.001;
  bool rotary = false;
  bool noise = true;

  robot::Joint joint() const {
    const robot::Robot robot = robot::load_shipped("hyq");
    return *robot.find(rotary ? "lf_haa" : "lf_kfe");
  }

  static double position(double share, double t) {
    const double one = 2 * std::numbers::pi * 1.7;
    const double two = 2 * std::numbers::pi * 6.1;
    return share * (0.5 + 0.2 * std::sin(one * t) + 0.05 * std::sin(two * t));
  }
  static double velocity(double share, double t) {
    const double one = 2 * std::numbers::pi * 1.7;
    const double two = 2 * std::numbers::pi * 6.1;
    return share * (0.2 * one * std::cos(one * t) + 0.05 * two * std::cos(two * t));
  }

  Recording recording() const {
    const robot::Joint of = joint();
    const NoiseStream stream(20140701, of.name, "bench");
    const auto noisy = [&](double value, double sigma, std::size_t i, Tick channel) {
      return value + (noise ? sigma * stream.normal(static_cast<Tick>(8 * i) + channel) : 0.0);
    };
    Recording r;
    r.coordinates = rotary ? Coordinates::kRotary : Coordinates::kLinear;
    r.period_s = period_s;
    const double stroke = of.actuator.stroke;
    const double supply = of.actuator.supply_pressure_Pa;
    for (std::size_t i = 0; i < samples; ++i) {
      const double t = static_cast<double>(i) * period_s;
      const double v = velocity(stroke, t);
      const double a = (velocity(stroke, t + 1e-6) - velocity(stroke, t - 1e-6)) / 2e-6;
      const double force = of.swing_load.mass * a + of.swing_load.damping * v;
      r.time_s.push_back(t);
      r.position.push_back(noisy(position(stroke, t), of.noise.position, i, 0));
      r.velocity.push_back(noisy(v, of.noise.velocity, i, 1));
      r.force.push_back(noisy(force, of.noise.force, i, 2));
      r.valve_current_A.push_back(0.8 * of.actuator.valve_current_max_A * v / (4.1 * stroke));
      r.pressure_a_Pa.push_back(noisy(0.5 * supply + 0.5 * force / of.actuator.area_a, 1e3, i, 3));
      r.pressure_b_Pa.push_back(noisy(0.5 * supply - 0.5 * force / of.actuator.area_b, 1e3, i, 4));
      r.supply_pressure_Pa.push_back(noisy(supply, 1e4, i, 5));
      r.line.push_back(i + 2);
    }
    return r;
  }
};

/// A CSV file as cells, to be changed before it is written.
struct CsvFile {
  std::vector<std::string> names;
  std::vector<std::vector<std::string>> rows;

  static std::string number(double value) {
    char text[32];
    return std::string(text, std::to_chars(text, text + sizeof text, value).ptr);
  }
  static CsvFile of(const Recording& r) {
    const bool linear = r.coordinates == Coordinates::kLinear;
    CsvFile file{.names = {"time_s", "valve_current_A", linear ? "position_m" : "angle_rad",
                           linear ? "velocity_m_s" : "velocity_rad_s", linear ? "force_N" : "torque_Nm"},
                 .rows = {}};
    for (std::size_t i = 0; i < r.time_s.size(); ++i) {
      file.rows.push_back({number(r.time_s[i]), number(r.valve_current_A[i]), number(r.position[i]),
                           number(r.velocity[i]), number(r.force[i])});
    }
    return file;
  }

  void erase(std::size_t column) {
    names.erase(names.begin() + static_cast<long>(column));
    for (auto& row : rows) {
      row.erase(row.begin() + static_cast<long>(column));
    }
  }
  void add(const std::string& name, const std::string& value) {
    names.push_back(name);
    for (auto& row : rows) {
      row.push_back(value);
    }
  }
  std::string text(const std::string& line_end = "\n") const {
    const auto joined = [&](const std::vector<std::string>& cells) {
      std::string line;
      for (const std::string& cell : cells) {
        line += (&cell == cells.data() ? "" : ",") + cell;
      }
      return line + line_end;
    };
    std::string all = joined(names);
    for (const auto& row : rows) {
      all += joined(row);
    }
    return all;
  }
};

/// A file that lives as long as its test.
class RecordingFile : public ::testing::Test {
 protected:
  void TearDown() override { std::filesystem::remove_all(path_); }

  auto read(const std::string& text) const {
    std::ofstream(path_, std::ios::binary) << text;
    return read_recording(path_);
  }
  auto read(const CsvFile& file) const { return read(file.text()); }

  /// Returns the reasons why a text is refused; empty for an accepted one.
  std::vector<Finding> findings(const std::string& text) const {
    auto recording = read(text);
    return recording ? std::vector<Finding>{} : recording.error().findings;
  }
  std::vector<Finding> findings(const CsvFile& file) const { return findings(file.text()); }

  const std::string path_ = (std::filesystem::temp_directory_path() /
                             ("farrier_recording_" + std::to_string(::getpid()) + "_" +
                              ::testing::UnitTest::GetInstance()->current_test_info()->name() + ".csv"))
                                .string();
};

/// "what@row what@row", the order of the findings.
inline std::string summary(const std::vector<Finding>& findings) {
  std::string text;
  for (const Finding& finding : findings) {
    text += (text.empty() ? "" : " ") + finding.what + "@" + std::to_string(finding.row);
  }
  return text;
}

inline bool mentions(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

}  // namespace farrier::diagnosis
