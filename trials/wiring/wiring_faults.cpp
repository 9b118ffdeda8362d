#include "trials/wiring/wiring_faults.hpp"

#include <algorithm>
#include <array>
#include <iterator>
#include <utility>

#include "core/noise.hpp"
#include "core/units.hpp"

namespace farrier::wiring {
namespace {

using diagnosis::OtherJoint;
using diagnosis::Recording;
using diagnosis::WiredChannel;
using diagnosis::WiringFault;
using diagnosis::WiringKind;
using enum diagnosis::WiredChannel;

constexpr std::array<int, kRecordings> kLags{2, 5, 11, 24, 50};
constexpr std::array<double, kRecordings> kFactors{10.0, 0.1, 1e3, 1e-3, 100.0};
constexpr std::array<double, kRecordings> kPressureFactors{1e-5, 1e-6, 1.0 / kPascalPerPsi, 10.0, 0.1};

void scale(std::vector<double>& values, double factor) {
  for (double& value : values) {
    value *= factor;
  }
}

/// Positive: late.
void shift(std::vector<double>& values, int samples) {
  const std::vector<double> before = values;
  const int last = static_cast<int>(values.size()) - 1;
  for (int i = 0; i <= last; ++i) {
    values[static_cast<std::size_t>(i)] = before[static_cast<std::size_t>(std::clamp(i - samples, 0, last))];
  }
}

FaultKind reversed(const char* name, WiredChannel channel) {
  return {name, [channel](Recording& r, const robot::Joint&, const OtherJoint&, int) {
            scale(column(r, channel), -1.0);
            return WiringFault{.kind = WiringKind::kReversed, .channel = channel};
          }};
}

/// A sensor whose cable is off: a constant, in every other recording with noise.
FaultKind dead(const char* name, WiredChannel channel) {
  return {name, [channel](Recording& r, const robot::Joint& joint, const OtherJoint&, int number) {
            std::vector<double>& values = column(r, channel);
            const double level = channel == kPosition && number > 1 ? values.front() : 0.0;
            const double noise = number % 2 == 0        ? 0.0
                                 : channel == kPosition ? joint.noise.position
                                 : channel == kVelocity ? joint.noise.velocity
                                 : channel == kForce    ? joint.noise.force
                                 : channel == kCurrent  ? 1e-4 * joint.actuator.valve_current_max_A
                                                        : 2e3;
            const NoiseStream stream(static_cast<std::uint64_t>(number), joint.name, "dead channel");
            for (std::size_t i = 0; i < values.size(); ++i) {
              values[i] = level + noise * stream.normal(static_cast<Tick>(i));
            }
            return WiringFault{.kind = WiringKind::kDead, .channel = channel};
          }};
}

FaultKind scaled(const char* name, WiredChannel channel) {
  return {name, [channel](Recording& r, const robot::Joint&, const OtherJoint&, int number) {
            const double factor = kFactors[static_cast<std::size_t>(number)];
            scale(column(r, channel), factor);
            return WiringFault{.kind = WiringKind::kScaled, .channel = channel, .amount = factor};
          }};
}

WiringFault shifted(Recording& r, const std::vector<WiredChannel>& channels, int late) {
  for (const WiredChannel channel : channels) {
    shift(column(r, channel), late);
  }
  return {.kind = late > 0 ? WiringKind::kLate : WiringKind::kEarly,
          .channel = channels.front(),
          .amount = static_cast<double>(std::abs(late)),
          .both_pressures = channels.size() > 1};
}

FaultKind lagged(const char* name, int sign, std::vector<WiredChannel> channels) {
  return {name,
          [sign, channels = std::move(channels)](Recording& r, const robot::Joint&, const OtherJoint&, int number) {
            return shifted(r, channels, sign * kLags[static_cast<std::size_t>(number)]);
          }};
}

FaultKind pressures_scaled(const char* name, std::vector<WiredChannel> channels) {
  return {name, [channels = std::move(channels)](Recording& r, const robot::Joint&, const OtherJoint&, int number) {
            const double factor = kPressureFactors[static_cast<std::size_t>(number)];
            for (const WiredChannel channel : channels) {
              scale(column(r, channel), factor);
            }
            return WiringFault{.kind = WiringKind::kScaled,
                               .channel = channels.front(),
                               .amount = factor,
                               .both_pressures = channels.size() > 1};
          }};
}

FaultKind exchanged(const char* name, WiredChannel one, WiredChannel other) {
  return {name, [one, other](Recording& r, const robot::Joint&, const OtherJoint&, int) {
            std::swap(column(r, one), column(r, other));
            return WiringFault{.kind = WiringKind::kExchanged, .channel = one, .other = other};
          }};
}

FaultKind foreign(const char* name, WiredChannel channel) {
  return {name, [channel](Recording& r, const robot::Joint&, const OtherJoint& other, int) {
            column(r, channel) = column(other.recording, channel);
            return WiringFault{.kind = WiringKind::kOtherJoint, .channel = channel, .joint = other.name};
          }};
}

}  // namespace

std::vector<FaultKind> fault_kinds(bool electric) {
  std::vector<FaultKind> kinds{
      reversed("force reversed", kForce),
      reversed("current reversed", kCurrent),
      reversed("velocity reversed", kVelocity),
      {"position mirrored",
       [](Recording& r, const robot::Joint& joint, const OtherJoint&, int) {
         for (double& x : r.position) {
           x = joint.actuator.stroke - x;
         }
         return WiringFault{.kind = WiringKind::kMirrored, .channel = kPosition};
       }},
      {"position reversed in sign",
       [](Recording& r, const robot::Joint&, const OtherJoint&, int) {
         scale(r.position, -1.0);
         return WiringFault{.kind = WiringKind::kMirrored, .channel = kPosition};
       }},
      exchanged("force and current exchanged", kForce, kCurrent),
      exchanged("position and velocity exchanged", kPosition, kVelocity),
      exchanged("position and force exchanged", kPosition, kForce),
      exchanged("force and velocity exchanged", kForce, kVelocity),
      exchanged("velocity and current exchanged", kVelocity, kCurrent),
      dead("force dead", kForce),
      dead("current dead", kCurrent),
      dead("velocity dead", kVelocity),
      dead("position dead", kPosition),
      scaled("force in other units", kForce),
      scaled("current in other units", kCurrent),
      scaled("velocity in other units", kVelocity),
      scaled("position in other units", kPosition),
      lagged("force late", 1, {kForce}),
      lagged("force early", -1, {kForce}),
      lagged("current late", 1, {kCurrent}),
      {"current early by more than a delay", [](Recording& r, const robot::Joint&, const OtherJoint&,
                                                int number) { return shifted(r, {kCurrent}, -34 - 4 * number); }},
      lagged("velocity late", 1, {kVelocity}),
      lagged("velocity early", -1, {kVelocity}),
      lagged("position late", 1, {kPosition}),
      lagged("position early", -1, {kPosition}),
      foreign("force of another joint", kForce),
      foreign("position of another joint", kPosition),
      foreign("velocity of another joint", kVelocity),
      foreign("current of another joint", kCurrent),
  };
  if (!electric) {
    std::ranges::move(
        std::vector<FaultKind>{
            exchanged("pressures exchanged", kPressureA, kPressureB),
            dead("pressure a dead", kPressureA),
            dead("pressure b dead", kPressureB),
            dead("supply dead", kSupply),
            pressures_scaled("pressures in other units", {kPressureA, kPressureB}),
            pressures_scaled("pressure a in other units", {kPressureA}),
            pressures_scaled("supply in other units", {kSupply}),
            lagged("pressures late", 1, {kPressureA, kPressureB}),
            lagged("pressures early", -1, {kPressureA, kPressureB}),
        },
        std::back_inserter(kinds));
  }
  return kinds;
}

}  // namespace farrier::wiring
