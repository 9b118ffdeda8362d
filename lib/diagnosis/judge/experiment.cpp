#include "diagnosis/judge/experiment.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <optional>

#include "core/noise.hpp"
#include "plant/hydraulic_joint.hpp"
#include "plant/terms/load_effects.hpp"

namespace farrier::diagnosis {
namespace {

constexpr double kPeriod_s = 0.001;
constexpr double kDuration_s = 4.0;
constexpr std::array kAmplitudes{0.03, 0.1, 0.3};
constexpr std::array kFrequencies_Hz{0.5, 2.0, 8.0, 25.0};

struct Reading {
  double force, position, velocity;
};

/// Sensor readings of a joint with these effects; empty if it cannot be simulated or leaves its stroke.
std::optional<std::vector<Reading>> simulate(const JointModel& joint, const Model& model, const Experiment& experiment,
                                             double position) {
  std::vector<plant::ActiveEffect> effects;
  plant::TermSet<double> sensors;
  const auto add = [&](const Model::Effect& effect) {
    effects.push_back(plant::active_effect(effect.id, effect.fitted, joint.scales()));
    plant::add_to(sensors, effects.back(), joint.scales(), kPeriod_s);
  };
  std::ranges::for_each(model.effects, add);
  for (const Model::Effect& known : joint.known()) {
    if (!model.has(known.id)) {
      add(known);
    }
  }
  const plant::Loads loads = plant::loads_with_effects({joint.load(), joint.load()}, joint.actuator(), effects);
  const plant::ActuatorParams& actuator = joint.actuator();
  auto plant =
      plant::HydraulicJoint::create(actuator, loads.swing, plant::equilibrium(actuator, loads.swing, position, 0.0),
                                    plant::HydraulicJoint::kDefaultTolerance, effects);
  if (!plant) {
    return std::nullopt;
  }
  const NoiseStream draw(1, "diagnosis", "experiment");
  std::vector<Reading> readings;
  for (int k = 0; k < static_cast<int>(kDuration_s / kPeriod_s); ++k) {
    const double time_s = k * kPeriod_s;
    const auto hold = static_cast<Tick>(time_s * 2.0 * experiment.frequency_Hz);
    const double shape = experiment.excitation == "sine"
                             ? std::sin(2.0 * std::numbers::pi * experiment.frequency_Hz * time_s)
                             : 2.0 * draw.uniform(hold) - 1.0;
    const plant::State& state = plant.value().state();
    plant::ForceMoment<double> cell{plant.value().load_cell_force()};
    sensors.on_force(cell);
    readings.push_back({cell.force, state.position, sensors.on_velocity(state.velocity)});
    if (!(state.position > 0.05 * actuator.stroke && state.position < 0.95 * actuator.stroke)) {
      return std::nullopt;
    }
    plant.value().step(experiment.amplitude_A * shape, 0.0, kPeriod_s);
  }
  return readings;
}

double difference_of(const std::vector<Reading>& a, const std::vector<Reading>& b, const SensorNoiseLevels& noise) {
  std::array<double, 3> squares{};
  for (std::size_t i = 0; i < a.size(); ++i) {
    const std::array<double, 3> apart{(a[i].force - b[i].force) / noise.force,
                                      (a[i].position - b[i].position) / noise.position,
                                      (a[i].velocity - b[i].velocity) / noise.velocity};
    for (std::size_t c = 0; c < apart.size(); ++c) {
      squares[c] += apart[c] * apart[c];
    }
  }
  return std::sqrt(*std::ranges::max_element(squares) / static_cast<double>(a.size()));
}

}  // namespace

Experiment telling_experiment(const JointModel& joint, const Hypothesis& one, const Hypothesis& other,
                              const SensorNoiseLevels& noise, double position) {
  const plant::EffectId last = one.effects.back();
  Experiment best{last, other.effects.empty() ? last : other.effects.back(), "sine", 0.0, 0.0, kDuration_s, 0.0};
  for (const char* excitation : {"sine", "steps"}) {
    for (const double amplitude : kAmplitudes) {
      for (const double frequency_Hz : kFrequencies_Hz) {
        Experiment trial = best;
        trial.excitation = excitation;
        trial.amplitude_A = amplitude * joint.actuator().valve_current_max_A;
        trial.frequency_Hz = frequency_Hz;
        const auto a = simulate(joint, one.halves[0].model, trial, position);
        const auto b = simulate(joint, other.halves[0].model, trial, position);
        if (a && b) {
          trial.difference = difference_of(*a, *b, noise);
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
