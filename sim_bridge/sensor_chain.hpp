#pragma once

// One channel's path from truth to sample:
//
//   truth ──▶ effects ──▶ + noise ──▶ analog low-pass ──▶ resolution ──▶ mean of tick ──▶ digital low-pass ──▶ sample
//             at each of the tick's conversions, the last at the tick itself               at the tick.
//
// Effects are those of the joint that lie in its load cell (lag, gain, offset) and its velocity sensor (lag).

#include <cstddef>
#include <utility>
#include <vector>

#include "control/law/low_pass.hpp"
#include "core/noise.hpp"
#include "core/result.hpp"
#include "plant/joint.hpp"
#include "plant/terms/active_effect.hpp"
#include "robot/robot.hpp"
#include "signals/signals.hpp"

namespace farrier::sim_bridge {

/// One number per channel of a joint, in actuator coordinates. Each member has a row in sensor_chain.cpp, which declares
/// the channel.
struct Measured {
  double position = 0.0;
  double velocity = 0.0;
  double force = 0.0;
};

inline constexpr std::size_t kChannels = sizeof(Measured) / sizeof(double);

/// Returns the true values that a joint's sensors measure.
Measured truth_of(const plant::Joint& joint) noexcept;

/// Writes a sample into the fields of its channels; the other fields are left unchanged.
void put(const Measured& sample, signals::JointSensors& sensors) noexcept;

/// One channel.
class SensorChannel {
 public:
  struct Parts {
    double noise;  ///< standard deviation of a conversion
    NoiseStream stream;
    control::FilterCoefficients anti_alias;  ///< at the rate of conversions
    control::FilterCoefficients filter;      ///< at the rate of ticks
    double step;                             ///< resolution; 0: none
  };
  explicit SensorChannel(const Parts& parts) noexcept;

  /// Sets the state as if `truth` had always been the input.
  void settle(double truth) noexcept;
  /// Conversion number `number` of the run, `index` of its tick.
  void convert(double truth, Tick number, int index) noexcept;
  /// The tick's sample after all its conversions.
  double sample(int conversions) noexcept;

 private:
  Parts parts_;
  bool has_anti_alias_, has_filter_;
  control::LowPass anti_alias_, filter_;
  double sum_ = 0.0;
};

/// Effects of sensors, by the code of their terms: the same that a diagnosis fits.
class SensorEffects {
 public:
  /// Takes those of the joint's effects that lie in sensors; read() is called every `period_s`.
  SensorEffects(const robot::Joint& joint, double period_s) noexcept;

  /// Readings of the sensors for the truth, without noise.
  Measured read(const Measured& truth) noexcept;

 private:
  plant::TermSet<double> terms_;
  bool any_ = false;
};

/// All sensors of a joint. Noise is addressed by (seed, joint, channel, conversion): the same truth gives the same
/// samples bit for bit. Without filters, oversampling and resolution a sample is truth + noise of the tick.
class SensorChain {
 public:
  /// Refuses filters that their sampling rate cannot represent.
  static Result<SensorChain> create(const robot::Joint& joint, double period_s, std::uint64_t seed);

  int conversions() const noexcept { return conversions_; }

  /// Sets the first sample, as if the joint had always been there.
  void begin(const Measured& truth) noexcept;
  /// Conversion `index` (0 to conversions() - 1, the last at the tick itself) of tick `tick`; with the last comes the
  /// sample.
  void convert(const Measured& truth, Tick tick, int index) noexcept;
  const Measured& sample() const noexcept { return sample_; }

 private:
  SensorChain(std::vector<SensorChannel> channels, const SensorEffects& effects, int conversions) noexcept
      : channels_(std::move(channels)), effects_(effects), conversions_(conversions) {}

  std::vector<SensorChannel> channels_;  // in the order of the rows
  SensorEffects effects_;
  int conversions_;
  Measured sample_;
};

}  // namespace farrier::sim_bridge
