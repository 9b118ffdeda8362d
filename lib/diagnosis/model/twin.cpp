#include "diagnosis/model/twin.hpp"

#include <cmath>
#include <limits>

#include "core/noise.hpp"

namespace farrier::diagnosis {
namespace {

std::vector<double> draw(std::size_t count, double deviation, const char* channel) {
  const NoiseStream stream(1, "diagnosis.twin", channel);
  std::vector<double> noise(count);
  for (std::size_t i = 0; i < count; ++i) {
    noise[i] = deviation * stream.normal(static_cast<Tick>(i));
  }
  return noise;
}

std::vector<double> sum_of(std::vector<double> signal, const std::vector<double>& noise) {
  for (std::size_t i = 0; i < signal.size(); ++i) {
    signal[i] += noise[i];
  }
  return signal;
}

}  // namespace

std::array<double, kChannels> expected_residuals(const Bench& bench, const JointSimulator& joint,
                                                 const Hypothesis& hypothesis, const SensorNoiseLevels& noise) {
  const JointData& data = joint.data();
  const Span all{0, data.size()};
  const Model& model = hypothesis.halves[0].model;
  const FitOptions& options = bench.options();
  const std::vector<double> position_noise = draw(data.size(), noise.position, "position");
  const std::vector<double> velocity_noise = draw(data.size(), noise.velocity, "velocity");
  const std::vector<double> force_noise = draw(data.size(), noise.force, "force");
  // The force that this model makes over the smoothed motion, running freely.
  Recording twin;
  twin.period_s = data.period_s;
  twin.valve_current_A = data.current_A;
  twin.position = sum_of(data.position, position_noise);
  twin.velocity = sum_of(data.velocity, velocity_noise);
  const bool oil = bench.fit_data().judged[0];
  constexpr double kFree_s = 1e9;
  const std::vector<double> force =
      oil ? joint.model().simulate(data, all, model, Channel::kForce, {kFree_s, kFree_s}) : data.force;
  twin.force = sum_of(force, force_noise);
  twin.swing = data.swing;
  const JointData observed = joint.model().prepared(twin, noise.position);
  std::array<double, kChannels> rms{};
  for (std::size_t c = 0; c < kChannels; ++c) {
    if (!bench.fit_data().judged[c]) {
      continue;
    }
    const auto channel = static_cast<Channel>(c);
    std::vector<double> error;
    switch (channel) {
      case Channel::kForce:
        error = residuals(JointSimulator(joint.model(), observed), all, model, channel, options);
        break;
      case Channel::kMotion: {
        // The load is driven by the measured force: what the noise of that moves, and what the position's makes of it.
        JointData noisy = data;
        noisy.force = sum_of(data.force, force_noise);
        const auto clean = joint.model().simulate(data, all, model, channel, options.observer);
        const auto moved = joint.model().simulate(noisy, all, model, channel, options.observer);
        const auto read = data.smoother.smooth<double>(position_noise, {0.0, 0.0, 0.0});
        for (std::size_t i = 0; i < clean.size(); ++i) {
          error.push_back(clean[i] - moved[i] + read[i][1] + read[i][0] / JointData::kMotionTime_s);
        }
        break;
      }
      case Channel::kVelocitySensor:
        for (std::size_t i = 0; i < data.size(); ++i) {
          error.push_back(velocity_noise[i] - (observed.velocity[i] - data.velocity[i]));
        }
        break;
    }
    double sum = 0.0;
    const auto skip = static_cast<std::size_t>(options.warm_up_s / data.period_s);
    for (std::size_t i = skip; i < error.size(); ++i) {
      sum += error[i] * error[i];
    }
    rms[c] = std::sqrt(sum / static_cast<double>(error.size() - skip));
  }
  return rms;
}

}  // namespace farrier::diagnosis
