#include "diagnosis/judge/experiment.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "core/noise.hpp"

namespace farrier::diagnosis {
namespace {

constexpr double kPeriod_s = 0.001;
constexpr double kDuration_s = 4.0;
constexpr std::array kAmplitudes{0.03, 0.1, 0.3};
constexpr std::array kFrequencies_Hz{0.5, 2.0, 8.0, 25.0};
constexpr double kMostForce = 0.8;  ///< of the largest

using Readings = std::vector<plant::JointReadings>;

/// True for readings of a joint that stays within its travel and its rating.
bool bears(const JointSides& joint, const Readings& readings) {
  const double travel = joint.scales().of(plant::Scale::kLength);
  return !readings.empty() && std::ranges::all_of(readings, [&](const plant::JointReadings& read) {
    return read.position > 0.05 * travel && read.position < 0.95 * travel &&
           std::abs(read.load_cell_force) <= kMostForce * joint.largest_force();
  });
}

double difference_of(const Readings& a, const Readings& b, const SensorNoiseLevels& noise) {
  std::array<double, 3> squares{};
  for (std::size_t i = 0; i < a.size(); ++i) {
    const std::array<double, 3> apart{(a[i].load_cell_force - b[i].load_cell_force) / noise.force,
                                      (a[i].position - b[i].position) / noise.position,
                                      (a[i].velocity - b[i].velocity) / noise.velocity};
    for (std::size_t c = 0; c < apart.size(); ++c) {
      squares[c] += apart[c] * apart[c];
    }
  }
  return std::sqrt(*std::ranges::max_element(squares) / static_cast<double>(a.size()));
}

}  // namespace

std::vector<double> experiment_current_A(const Experiment& experiment, double period_s) {
  const NoiseStream draw(1, "diagnosis", "experiment");
  std::vector<double> current_A;
  for (int k = 0; k < static_cast<int>(experiment.duration_s / period_s); ++k) {
    const double time_s = k * period_s;
    const auto level = static_cast<Tick>(time_s * 2.0 * experiment.frequency_Hz);
    current_A.push_back(experiment.amplitude_A *
                        (experiment.excitation == "sine"
                             ? std::sin(2.0 * std::numbers::pi * experiment.frequency_Hz * time_s)
                             : 2.0 * draw.uniform(level) - 1.0));
  }
  return current_A;
}

Experiment telling_experiment(const JointSides& joint, std::pair<plant::EffectId, plant::EffectId> pair,
                              const Model& one, const Model& other, const SensorNoiseLevels& noise) {
  Experiment best{.one = pair.first,
                  .other = pair.second,
                  .excitation = "sine",
                  .amplitude_A = 0.0,
                  .frequency_Hz = 0.0,
                  .duration_s = kDuration_s,
                  .difference = 0.0,
                  .hold = joint.hold()};
  for (const char* excitation : {"sine", "steps"}) {
    for (const double amplitude : kAmplitudes) {
      for (const double frequency_Hz : kFrequencies_Hz) {
        Experiment trial = best;
        trial.excitation = excitation;
        trial.amplitude_A = amplitude * joint.scales().of(plant::Scale::kCurrent);
        trial.amplitude_Nm = trial.amplitude_A * joint.torque_per_A();
        trial.frequency_Hz = frequency_Hz;
        const std::vector<double> current_A = experiment_current_A(trial, kPeriod_s);
        const Readings a = joint.respond(one, current_A, kPeriod_s);
        const Readings b = joint.respond(other, current_A, kPeriod_s);
        if (bears(joint, a) && bears(joint, b)) {
          trial.difference = difference_of(a, b, noise);
          if (trial.difference > best.difference) {
            best = trial;
          }
        }
      }
    }
  }
  return best;
}

}  // namespace farrier::diagnosis
