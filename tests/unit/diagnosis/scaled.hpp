#pragma once

// Recordings in scaled units of arms that never were.

#include <cmath>
#include <fstream>
#include <string>

#include "core/noise.hpp"
#include "diagnosis/data/scaled_recording.hpp"

namespace farrier::diagnosis::testing {

constexpr double kGain = -0.06;
constexpr double kDrift = -0.004;
constexpr double kStep = 1.0 / 512.0;  // of the converter

/// An arm under steps of the valve of several sizes, 1024 samples; `flow` makes of the valve's opening what passes it,
/// `noise` is the sensor's standard deviation.
template <class Flow>
ScaledRecording arm(Flow flow, std::uint64_t seed = 11, double noise = 0.0) {
  const NoiseStream draw(seed, "diagnosis_scaled", "valve");
  const NoiseStream sensor(seed, "diagnosis_scaled", "position");
  ScaledRecording recording{.source = "arm.csv", .valve = {}, .position = {}, .remarks = {}};
  double position = 0.5;
  for (int k = 0; k < 1024; ++k) {
    const double level = 2.0 * draw.uniform(k / 12) - 1.0;
    const double held = 0.8 * level * (k / 100 % 2 == 0 ? 0.4 : 1.4) + 0.3 * (position - 0.5);
    recording.valve.push_back(std::round(held / kStep) * kStep);
    recording.position.push_back(std::round((position + noise * sensor.normal(k)) / kStep) * kStep);
    position += kGain * flow(recording.valve.back()) + kDrift;
  }
  return recording;
}

inline double saturated(double opening, double at) { return opening / std::hypot(1.0, opening / at); }

inline double overlapped(double opening, double half_width) {
  return std::copysign(std::max(std::abs(opening) - half_width, 0.0), opening);
}

/// As a CSV file; `row` has its say about every line, and an empty one is left out.
template <class Row>
void write(const std::string& path, const ScaledRecording& recording, Row row) {
  std::ofstream file(path);
  file << "sample,valve,position,pressure\n";
  for (std::size_t k = 0; k < recording.valve.size(); ++k) {
    const std::string line = row(k, std::to_string(k) + "," + std::to_string(recording.valve[k]) + "," +
                                        std::to_string(recording.position[k]) + ",0.1");
    file << line << (line.empty() ? "" : "\n");
  }
}

}  // namespace farrier::diagnosis::testing
