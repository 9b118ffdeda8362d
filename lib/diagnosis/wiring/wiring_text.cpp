#include <algorithm>
#include <array>
#include <cmath>
#include <span>

#include "core/units.hpp"
#include "diagnosis/data/recording_units.hpp"
#include "diagnosis/data/sample_statistics.hpp"
#include "diagnosis/judge/finding_text.hpp"
#include "diagnosis/wiring/wiring.hpp"

namespace farrier::diagnosis {
namespace {

using enum WiredChannel;

std::string column_name(WiredChannel channel, const Recording& recording) {
  const Coordinates coordinates = recording.coordinates;
  switch (channel) {
    case kPosition:
      return position_column(coordinates);
    case kVelocity:
      return velocity_column(coordinates);
    case kForce:
      return force_column(coordinates);
    case kCurrent:
      return recording.torque_command_Nm.empty() ? "valve_current_A" : "torque_command_Nm";
    case kPressureA:
      return "pressure_a_Pa";
    case kPressureB:
      return "pressure_b_Pa";
    case kSupply:
      return "supply_pressure_Pa";
  }
  return "";
}

std::string reversed_text(const WiringFault& fault, const std::string& column, bool electric) {
  const std::string remedy = " Exchange them, or multiply the column by -1.";
  switch (fault.channel) {
    case kForce:
      return column + " is reversed: " + (electric ? "the torque sensor's" : "the load cell's") +
             " wires are exchanged, or its sign convention is (positive pushes towards extension)." + remedy;
    case kCurrent:
      return column + " is reversed: " + (electric ? "two phases of the motor" : "the wires of the valve's coil") +
             " are exchanged, or its sign convention is (positive extends)." + remedy;
    default:
      return column + " is reversed: the sensor's wires are exchanged, or its sign convention is (positive extends)." +
             remedy;
  }
}

/// The unit in which numbers are the fault's `amount` times those of the column; empty for none.
std::string unit_of(const WiringFault& fault, bool rotary) {
  static constexpr std::array kLengths{Unit{"millimetres", 1e3}, Unit{"centimetres", 100.0}};
  static constexpr std::array kAngles{Unit{"milliradians", 1e3}, Unit{"degrees", kDegrees}};
  static constexpr std::array kSpeeds{Unit{"millimetres per second", 1e3}, Unit{"centimetres per second", 100.0}};
  static constexpr std::array kRates{Unit{"milliradians per second", 1e3}, Unit{"degrees per second", kDegrees}};
  static constexpr std::array kForces{Unit{"kilonewtons", 1e-3}, Unit{"millinewtons", 1e3}};
  static constexpr std::array kTorques{Unit{"kilonewton metres", 1e-3}, Unit{"newton millimetres", 1e3}};
  static constexpr std::array kCurrents{Unit{"milliamperes", 1e3}};
  std::span<const Unit> units = kPressureUnits;
  switch (fault.channel) {
    case kPosition:
      units = rotary ? kAngles : kLengths;
      break;
    case kVelocity:
      units = rotary ? kRates : kSpeeds;
      break;
    case kForce:
      units = rotary ? kTorques : kForces;
      break;
    case kCurrent:
      units = kCurrents;
      break;
    case kPressureA:
    case kPressureB:
    case kSupply:
      break;
  }
  const auto found = std::ranges::find_if(
      units, [&](const Unit& unit) { return std::abs(std::log(unit.per_SI / fault.amount)) < 0.01; });
  return found == units.end() ? "" : found->name;
}

std::string factor_text(double factor) {
  return factor >= 1.0 ? rounded(factor) + " times as large as" : "a " + rounded(1.0 / factor) + "th of";
}

std::string body_of(const WiringAnswer& answer, const Recording& recording, const robot::Joint& joint) {
  const WiringFault& fault = answer.fault;
  const bool rotary = recording.coordinates == Coordinates::kRotary;
  const std::string& columns = answer.columns;
  const bool many = fault.both_pressures;
  switch (fault.kind) {
    case WiringKind::kReversed:
      return reversed_text(fault, columns, joint.electric.has_value());
    case WiringKind::kMirrored:
      return quantile(recording.position, 0.5) < 0.0
                 ? columns + " is reversed in sign: multiply the column by -1; it counts from the fully retracted end."
                 : columns +
                       " is mirrored: it counts from the extended end. Replace it by the stroke less its values, "
                       "or turn the sensor.";
    case WiringKind::kDead:
      return columns +
             " is dead: it does not move as the other columns say that it must. Check the sensor, its supply "
             "and its cable, or leave the column out.";
    case WiringKind::kScaled: {
      const std::string unit = unit_of(fault, rotary);
      return columns + (many ? " are " : " is ") + factor_text(fault.amount) + " the other columns say" +
             (unit.empty() ? "" : ", as in " + unit) + ". Multiply the column" + (many ? "s by " : " by ") +
             rounded(1.0 / fault.amount) + ", or correct the gain of its amplifier.";
    }
    case WiringKind::kLate:
    case WiringKind::kEarly:
      return columns + (many ? " are " : " is ") + rounded(fault.amount) + " sample" + (fault.amount > 1.0 ? "s" : "") +
             (fault.kind == WiringKind::kLate ? " late" : " early") +
             " against the other columns, as no delay or filter of a joint is. Take all columns in one cycle, or shift "
             "the column by " +
             rounded(fault.amount) +
             (fault.kind == WiringKind::kLate ? " rows towards the beginning." : " rows towards the end.");
    case WiringKind::kExchanged:
      return columns + " are exchanged: two cables or two columns are. Exchange them.";
    case WiringKind::kOtherJoint:
      return columns + " of " + joint.name + " is that of joint " + fault.joint + ": the cables of " + joint.name +
             " and " + fault.joint + " are exchanged. Plug each sensor into its own joint, or exchange the columns.";
  }
  return "";
}

}  // namespace

const char* to_string(WiringKind kind) noexcept {
  switch (kind) {
    case WiringKind::kReversed:
      return "reversed";
    case WiringKind::kMirrored:
      return "mirrored";
    case WiringKind::kDead:
      return "dead";
    case WiringKind::kScaled:
      return "scaled";
    case WiringKind::kLate:
      return "late";
    case WiringKind::kEarly:
      return "early";
    case WiringKind::kExchanged:
      return "exchanged";
    case WiringKind::kOtherJoint:
      return "other_joint";
  }
  return "";
}

std::string columns_of(const WiringFault& fault, const Recording& recording) {
  const std::string first = column_name(fault.channel, recording);
  if (fault.both_pressures) {
    return first + " and " + column_name(kPressureB, recording);
  }
  return fault.kind == WiringKind::kExchanged ? first + " and " + column_name(fault.other, recording) : first;
}

std::vector<Finding> wiring_findings(const std::vector<WiringAnswer>& answers, const Recording& recording,
                                     const robot::Joint& joint) {
  std::vector<Finding> findings;
  for (const WiringAnswer& answer : answers) {
    std::string text = body_of(answer, recording, joint);
    text += " Confidence " + rounded(std::floor(1000.0 * answer.confidence) / 1000.0);
    text += answer.left > 0.0 ? "; undone, " + rounded(std::max(0.1, 100.0 * answer.left)) +
                                    " % of the deviation from the laws of the joint is left."
                              : ".";
    findings.push_back({to_string(answer.fault.kind), 0, text});
  }
  return findings;
}

}  // namespace farrier::diagnosis
