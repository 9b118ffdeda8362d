#include "diagnosis/data/channel_report.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>

#include "diagnosis/data/sample_statistics.hpp"

namespace farrier::diagnosis {
namespace {

constexpr double kFree_s = 1e9;
constexpr int kBins = 12;
constexpr int kLags = 100;
constexpr int kSegment = 512;
constexpr std::size_t kAheadEvery = 10;

const char* name_of(Channel channel, const JointSides& joint) noexcept {
  switch (channel) {
    case Channel::kForce:
      return joint.actuator_side();
    case Channel::kMotion:
      return "load";
    case Channel::kVelocitySensor:
      return "velocity_sensor";
  }
  return "";
}

/// Held-out residual of a hypothesis over the whole recording: each half by the other half's fit.
std::vector<double> held_out_channel(const Bench& bench, const Hypothesis& hypothesis, Channel channel,
                                     double observer_s) {
  FitOptions options = bench.options();
  options.observer = {observer_s, observer_s};
  std::vector<double> all;
  for (std::size_t half = 0; half < 2; ++half) {
    const auto part =
        residuals(bench.simulator(), bench.halves()[half], hypothesis.halves[1 - half].model, channel, options);
    all.insert(all.end(), part.begin(), part.end());
  }
  return all;
}

/// Simulations that leave the observed one every few samples and run freely for 50 ms.
double ahead_50ms(const Bench& bench, const JointSimulator& joint, const Hypothesis& hypothesis, Channel channel) {
  const auto steps = static_cast<std::size_t>(0.05 / joint.data().period_s);
  double sum = 0.0;
  std::size_t count = 0;
  for (std::size_t half = 0; half < 2; ++half) {
    const Span span = bench.halves()[half];
    const auto errors = joint.model().errors_ahead(joint.data(), span, hypothesis.halves[1 - half].model, channel,
                                                   bench.options().observer, steps, kAheadEvery);
    const auto warm = static_cast<std::size_t>(bench.options().warm_up_s / joint.data().period_s) / kAheadEvery;
    for (std::size_t i = warm; i < errors.size(); ++i) {
      sum += errors[i] * errors[i];
      ++count;
    }
  }
  return count > 0 ? std::sqrt(sum / static_cast<double>(count)) : 0.0;
}

Horizons horizons(const Bench& bench, const JointSimulator& joint, const Hypothesis& hypothesis, Channel channel,
                  double deviation) {
  const JointData& data = joint.data();
  if (channel == Channel::kVelocitySensor) {  // has no state that an error could grow in
    const double error = judged_rms(held_out_channel(bench, hypothesis, channel, kFree_s)) / deviation;
    return {error, error, error};
  }
  return {judged_rms(held_out_channel(bench, hypothesis, channel, 0.1 * data.period_s)) / deviation,
          ahead_50ms(bench, joint, hypothesis, channel) / deviation,
          judged_rms(held_out_channel(bench, hypothesis, channel, kFree_s)) / deviation};
}

std::vector<double> less(const std::vector<double>& a, const std::vector<double>& b) {
  std::vector<double> out;
  std::ranges::transform(a, b, std::back_inserter(out), std::minus{});
  return out;
}

}  // namespace

std::vector<ChannelReport> report_channels(const Bench& bench, const JointSimulator& joint, const Hypothesis& before,
                                           const Hypothesis& after) {
  std::vector<ChannelReport> reports;
  const JointData& data = joint.data();
  for (const Channel channel : {Channel::kForce, Channel::kMotion, Channel::kVelocitySensor}) {
    if (!bench.fit_data().judged[static_cast<std::size_t>(channel)]) {
      continue;
    }
    const std::vector<double>& truth = joint.measured(channel);
    const double deviation = std::max(standard_deviation(truth), 1e-300);
    const Observer& observer = bench.options().observer;
    const double observer_s = channel == Channel::kForce ? observer.oil_s : observer.load_s;
    const auto was = held_out_channel(bench, before, channel, observer_s);
    const auto is = held_out_channel(bench, after, channel, observer_s);
    const std::vector<double>& input = channel == Channel::kForce    ? data.current_A
                                       : channel == Channel::kMotion ? data.force
                                                                     : data.velocity;
    ChannelReport report{.channel = channel,
                         .name = name_of(channel, joint.model()),
                         .before = horizons(bench, joint, before, channel, deviation),
                         .after = horizons(bench, joint, after, channel, deviation),
                         .whiteness = whiteness(was, kLags),
                         .cross_correlation = cross_correlation(was, input, kLags / 2),
                         .whiteness_after = whiteness(is, kLags),
                         .cross_correlation_after = cross_correlation(is, input, kLags / 2),
                         .dependences = {},
                         .frequency_Hz = {},
                         .spectrum_before = power_density(was, data.period_s, kSegment),
                         .spectrum_after = power_density(is, data.period_s, kSegment),
                         .measured = truth,
                         .simulated_before = less(truth, was),
                         .simulated_after = less(truth, is)};
    report.dependences.push_back(dependence("speed", data.velocity, was, kBins));
    if (!data.current_A.empty()) {
      report.dependences.push_back(dependence("current", data.current_A, was, kBins));
    }
    report.dependences.push_back(dependence("force", data.force, was, kBins));
    report.dependences.push_back(dependence("position", data.position, was, kBins));
    for (std::size_t i = 0; i < report.spectrum_before.size(); ++i) {
      report.frequency_Hz.push_back(static_cast<double>(i) / (kSegment * data.period_s));
    }
    reports.push_back(std::move(report));
  }
  return reports;
}

}  // namespace farrier::diagnosis
