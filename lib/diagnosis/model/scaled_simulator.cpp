#include "diagnosis/model/scaled_simulator.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "diagnosis/model/delayed_command.hpp"
#include "diagnosis/model/jets.hpp"
#include "diagnosis/data/sample_statistics.hpp"
#include "diagnosis/model/side_models.hpp"
#include "plant/terms/active_effect.hpp"

namespace farrier::diagnosis {
namespace {

/// Samples in which the slowest spool settles to a thousandth.
constexpr std::size_t kSettling = 200;

constexpr std::size_t kGain = 0;
constexpr std::size_t kDrift = 1;

constexpr std::array kEffects{plant::effect_id<plant::InputDelay>(),     plant::effect_id<plant::ValveBias>(),
                              plant::effect_id<plant::ValveDynamics>(),  plant::effect_id<plant::ValveDeadband>(),
                              plant::effect_id<plant::ValveAsymmetry>(), plant::effect_id<plant::FlowSaturation>()};

/// Scales for a valve that is full open at the largest opening of the recording; nothing else of a joint is known.
plant::Scales scales_of(const ScaledRecording& recording) {
  const plant::ActuatorParams unit{.area_a = 1.0,
                                   .area_b = 1.0,
                                   .stroke = 1.0,
                                   .line_volume_m3 = 1.0,
                                   .bulk_modulus_Pa = 1.0,
                                   .valve_gain = 1.0,
                                   .valve_current_max_A = magnitude(recording.valve, 1.0),
                                   .supply_pressure_Pa = 1.0};
  return {unit, plant::LoadParams{}};
}

/// Least squares of the position's steps over valve and one.
Model fit_of_steps(const ScaledRecording& recording) {
  const std::size_t count = recording.position.size() - 1;
  const double middle = mean(std::span(recording.valve).first(count));
  const double step = (recording.position[count] - recording.position[0]) / static_cast<double>(count);
  double together = 0.0;
  double alone = std::numeric_limits<double>::min();
  for (std::size_t i = 0; i < count; ++i) {
    const double valve = recording.valve[i] - middle;
    together += valve * (recording.position[i + 1] - recording.position[i] - step);
    alone += valve * valve;
  }
  Model model = Model::nominal();
  model.factors[kGain] = together / alone;
  model.factors[kDrift] = step - model.factors[kGain] * middle;
  return model;
}

}  // namespace

ScaledSimulator::ScaledSimulator(const ScaledRecording& recording)
    : recording_(recording), valve_integral_{0.0}, scales_(scales_of(recording)), nominal_(fit_of_steps(recording)) {
  for (const double valve : recording.valve) {
    valve_integral_.push_back(valve_integral_.back() + kSample_s * valve);
  }
}

ChannelMask ScaledSimulator::channels(plant::EffectId effect) const noexcept {
  return effect < plant::kEffectCount ? channels_of(effect) : ChannelMask{};
}

std::vector<std::vector<double>> ScaledSimulator::starts(plant::EffectId effect) const {
  if (std::ranges::find(kEffects, effect) == kEffects.end()) {
    return {};
  }
  return starts_of(plant::effect_info(effect));
}

std::vector<FreeNumber> ScaledSimulator::free_numbers(const Model& model, const ChannelMask& mask, double) const {
  constexpr ChannelMask kMine{true, false, false};
  constexpr double kAny = std::numeric_limits<double>::max();
  if (!mask[static_cast<std::size_t>(kChannel)]) {
    return {};
  }
  std::vector<FreeNumber> free{{kGain, kMine, -kAny, kAny, 0.0, 0.0}, {kDrift, kMine, -kAny, kAny, 0.0, 0.0}};
  std::size_t place = kNominals;
  for (const Model::Effect& effect : model.effects) {
    for (const plant::Parameter& parameter : plant::effect_info(effect.id).parameters) {
      if (!parameter.held) {
        free.push_back({place, kMine, parameter.low, parameter.high, 0.0, 0.0});
      }
      ++place;
    }
  }
  return free;
}

template <class T>
std::vector<T> ScaledSimulator::run(Span span, const T& gain, const T& drift, plant::TermSet<T>& terms) const {
  std::vector<T> positions;
  positions.reserve(span.size());
  const DelayedCommand<T> command({recording_.valve, valve_integral_, kSample_s}, terms);
  // The valve is where its commands before the span have brought it; before the first it was where that one holds it.
  for (std::size_t i = kSettling; i > 0; --i) {
    plant::ValveMoment<T> valve{command.mean(span.begin > i ? span.begin - i : 0), T(1.0)};
    terms.on_valve(valve);
  }
  T position(recording_.position[span.begin]);
  for (std::size_t k = span.begin; k < span.end; ++k) {
    positions.push_back(position);
    plant::ValveMoment<T> valve{command.mean(k), T(1.0)};
    terms.on_valve(valve);
    position += gain * valve.flow_factor * valve.opening_A + drift;
  }
  const std::size_t first = std::min(kFirst, span.size());
  T error(0.0);
  for (std::size_t i = 0; i < first; ++i) {
    error += recording_.position[span.begin + i] - positions[i];
  }
  error /= static_cast<double>(first);
  for (T& one : positions) {
    one += error;
  }
  return positions;
}

std::vector<double> ScaledSimulator::simulate(Span span, const Model& model, Channel, const Observer&) const {
  plant::TermSet<double> terms;
  for (const Model::Effect& effect : model.effects) {
    terms.add(effect.id, effect.fitted.data(), scales_, kSample_s);
  }
  return run<double>(span, model.factors[kGain], model.factors[kDrift], terms);
}

std::vector<double> ScaledSimulator::simulate_lanes(Span span, const Model& model, Channel, const Observer&,
                                                    const std::vector<std::size_t>& lanes,
                                                    std::vector<double>& jacobian) const {
  plant::TermSet<Jet> terms;
  for (const auto& [id, fitted] : effect_jets(model, lanes)) {
    terms.add(id, fitted.data(), scales_, kSample_s);
  }
  const auto jets =
      run<Jet>(span, jet_at(kGain, model.factors[kGain], lanes), jet_at(kDrift, model.factors[kDrift], lanes), terms);
  return values_and_jacobian(jets, lanes.size(), jacobian);
}

}  // namespace farrier::diagnosis
