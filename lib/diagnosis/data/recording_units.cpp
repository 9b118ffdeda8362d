#include "diagnosis/data/recording_units.hpp"

#include <algorithm>
#include <cmath>
#include <span>
#include <string>

#include "core/units.hpp"
#include "diagnosis/judge/finding_text.hpp"
#include "diagnosis/data/sample_statistics.hpp"
#include "robot/joint_scales.hpp"

namespace farrier::diagnosis {
namespace {

class UnitCheck {
 public:
  UnitCheck(const Recording& recording, const robot::Joint& joint)
      : recording_(recording), joint_(joint), rotary_(recording.coordinates == Coordinates::kRotary) {}

  std::vector<Finding> check() && {
    if (!has_coordinates_of(recording_, joint_)) {
      findings_.push_back(
          {"wrong_coordinates", 0,
           joint_.electric ? "the file has positions and forces, but joint " + joint_.name +
                                 " is electric; record angle_rad, velocity_rad_s and torque_Nm"
                           : "the file has angles and torques, but joint " + joint_.name +
                                 " is moved by a cylinder; record position_m, velocity_m_s and force_N of its piston"});
      return std::move(findings_);
    }
    check_position();
    check_velocity();
    check_force();
    check_current();
    check_pressure("pressure_a_Pa", recording_.pressure_a_Pa, 0.05, 0.6);
    check_pressure("pressure_b_Pa", recording_.pressure_b_Pa, 0.05, 0.6);
    check_pressure("supply_pressure_Pa", recording_.supply_pressure_Pa, 0.2, 1.0);
    return std::move(findings_);
  }

 private:
  std::size_t line(std::size_t sample) const { return recording_.line.empty() ? 0 : recording_.line[sample]; }
  void refuse(const char* what, const char* column, const std::string& text) {
    findings_.push_back({what, 0, std::string("column ") + column + ": " + text});
  }
  void refuse_unit(const char* column, const std::string& seen, const Unit* unit, const std::string& expected) {
    refuse("wrong_units", column,
           seen + (unit == nullptr ? "; no unit fits: give " + expected
                                   : "; this looks like " + std::string(unit->name) + ": divide by " +
                                         rounded(unit->per_SI) + " to give " + expected));
  }

  void check_position() {
    const char* const column = position_column(recording_.coordinates);
    const std::string unit_name = rotary_ ? "rad" : "m";
    const double stroke = joint_.actuator.stroke;
    const double low = quantile(recording_.position, 0.01);
    const double high = quantile(recording_.position, 0.99);
    const std::string stroke_text = "the stroke, 0 to " + rounded(stroke) + " " + unit_name;
    if (low < -0.5 * stroke || high > 1.5 * stroke) {
      static constexpr Unit kLengths[] = {{"millimetres", 1e3}, {"centimetres", 1e2}, {"micrometres", 1e6}};
      static constexpr Unit kAngles[] = {{"degrees", kDegrees}, {"milliradians", 1e3}};
      const double largest = std::max(std::abs(low), std::abs(high));
      // If two units fit, the first one is chosen in which more than a tenth of the stroke is used.
      const Unit* looks_like = nullptr;
      for (const Unit& unit : rotary_ ? std::span<const Unit>(kAngles) : std::span<const Unit>(kLengths)) {
        const double used = largest / unit.per_SI / stroke;
        if (looks_like == nullptr && used > (rotary_ ? 0.0 : 0.1) && used <= 1.02) {
          looks_like = &unit;
        }
      }
      position_good_ = false;
      refuse_unit(column, "values of " + rounded(low) + " to " + rounded(high) + " are far outside " + stroke_text,
                  looks_like, unit_name);
      return;
    }
    Places outside;
    for (std::size_t i = 0; i < recording_.position.size(); ++i) {
      if (recording_.position[i] < -0.02 * stroke || recording_.position[i] > 1.02 * stroke) {
        outside.add(line(i));
      }
    }
    if (outside.count() > 0) {
      const auto [least, most] = std::minmax_element(recording_.position.begin(), recording_.position.end());
      findings_.push_back({"out_of_range", outside.first(),
                           (outside.first() == 0 ? "" : outside.text() + ", ") + "column " + column + ": " +
                               counted(outside.count(), "value") + " outside " + stroke_text + " (" + rounded(*least) +
                               " to " + rounded(*most) +
                               "); count from the fully retracted end, or correct the stroke "
                               "in the robot file"});
    }
  }

  void check_velocity() {
    moves_ = quantile(recording_.position, 0.99) - quantile(recording_.position, 0.01) > 0.02 * joint_.actuator.stroke;
    velocity_good_ = recording_.velocity_derived && position_good_;
    if (recording_.velocity_derived || !position_good_ || !moves_) {
      return;
    }
    if (const auto agreement = agreement_of(recording_.position, recording_.velocity, recording_.period_s)) {
      judge_velocity(agreement->ratio, agreement->correlation);
    }
  }

  void judge_velocity(double ratio, double correlation) {
    const char* const column = velocity_column(recording_.coordinates);
    const std::string seen =
        rounded(std::abs(ratio)) + " times the derivative of " + position_column(recording_.coordinates);
    const Unit unit = rotary_ ? Unit{"degrees per second", kDegrees} : Unit{"millimetres per second", 1e3};
    const double size = std::abs(ratio);
    velocity_good_ = std::abs(correlation) > 0.7 && ratio > 0.5 && ratio < 2.0;
    if (velocity_good_) {
      return;
    }
    if (std::abs(correlation) <= 0.7) {
      refuse("inconsistent", column,
             "does not follow the derivative of " + std::string(position_column(recording_.coordinates)) +
                 " (correlation " + rounded(correlation) + "); check which sensors were recorded");
    } else if (size > 0.5 * unit.per_SI && size < 2.0 * unit.per_SI) {
      refuse_unit(column, seen, &unit, rotary_ ? "rad/s" : "m/s");
    } else if (size <= 0.5 || size >= 2.0) {
      refuse("inconsistent", column, seen + "; check the scale of both");
    }
    if (correlation < -0.7) {
      refuse("wrong_sign", column,
             "falls where " + std::string(position_column(recording_.coordinates)) +
                 " rises; both are positive towards extension: turn one of them");
    }
  }

  void check_force() {
    const char* const column = force_column(recording_.coordinates);
    const double size = magnitude(recording_.force);
    const double limit = std::max(joint_.push_limit, joint_.pull_limit);
    const double full =
        joint_.electric ? plant::stall_torque(*joint_.electric) : robot::scales_of(joint_).of(plant::Scale::kForce);
    const std::string unit_name = rotary_ ? "Nm" : "N";
    if (size > 3.0 * full) {
      refuse_unit(column,
                  "values up to " + rounded(size) + " where the " + (joint_.electric ? "drive" : "supply") + " gives " +
                      rounded(full) + " " + unit_name,
                  nullptr, unit_name);
      return;
    }
    // A recording in kilonewtons stays below a thousandth of the limit. A moving joint's recording in newtons does so
    // only with a very small load; then the load's damping and spring give as small a force.
    const double damping = std::min(joint_.swing_load.damping, joint_.stance_load.damping);
    const double stiffness = std::min(joint_.swing_load.stiffness, joint_.stance_load.stiffness);
    const double expected = position_good_ && velocity_good_
                                ? damping * rms(recording_.velocity, 0.0) +
                                      stiffness * rms(recording_.position, quantile(recording_.position, 0.5))
                                : 0.0;
    if (size > 0.0 && size < 1.5e-3 * limit && (moves_ || !position_good_) &&
        (expected == 0.0 || size < 0.03 * expected)) {
      const Unit kilo{rotary_ ? "kilonewton metres" : "kilonewtons", 1e-3};
      refuse("wrong_units", column,
             "values up to " + rounded(size) + " while the joint moves, of which " + rounded(limit) + " " + unit_name +
                 " are possible; this looks like " + kilo.name + ": multiply by 1000 to give " + unit_name);
    }
  }

  void check_current() {
    if (recording_.valve_current_A.empty()) {
      return;
    }
    const double limit = joint_.actuator.valve_current_max_A;
    const double size = magnitude(recording_.valve_current_A);
    if (size > 20.0 * limit) {
      static constexpr Unit kUnits[] = {{"milliamperes", 1e3}, {"microamperes", 1e6}};
      const Unit* looks_like = nullptr;
      for (const Unit& unit : kUnits) {
        const double share = size / unit.per_SI / limit;
        looks_like = looks_like == nullptr && share >= 0.02 && share <= 2.0 ? &unit : looks_like;
      }
      const Unit percent{"percent of full opening", 100.0 / limit};
      looks_like = looks_like == nullptr && size <= 101.0 ? &percent : looks_like;
      refuse_unit("valve_current_A",
                  "values up to " + rounded(size) +
                      (joint_.electric ? " where the drive gives " : " where the valve is full open at ") +
                      rounded(limit) + " A",
                  looks_like, "A");
    }
  }

  // `least` and `usual`: shares of the supply that the largest values of a live machine exceed and are near.
  void check_pressure(const char* column, const std::vector<double>& values, double least, double usual) {
    if (values.empty() || joint_.electric) {
      return;
    }
    const double supply = joint_.actuator.supply_pressure_Pa;
    const double size = magnitude(values);
    if (size == 0.0 || (size >= 0.1 * least * supply && size <= 3.0 * supply)) {
      return;
    }
    const Unit* looks_like = nullptr;
    double nearest = 0.0;
    for (const Unit& unit : kPressureUnits) {
      const double share = size / unit.per_SI / supply;
      const double distance = std::abs(std::log(share / usual));
      if (share >= least && share <= 1.5 && (looks_like == nullptr || distance < nearest)) {
        looks_like = &unit;
        nearest = distance;
      }
    }
    const std::string seen = "values up to " + rounded(size) + " where the supply has " + rounded(supply) + " Pa";
    if (looks_like == nullptr) {
      refuse_unit(column, seen, nullptr, "Pa");
    } else {
      refuse("wrong_units", column,
             seen + "; this looks like " + looks_like->name + ": multiply by " + rounded(1.0 / looks_like->per_SI) +
                 " to give Pa");
    }
  }

  const Recording& recording_;
  const robot::Joint& joint_;
  const bool rotary_;
  bool position_good_ = true;
  bool velocity_good_ = false;
  bool moves_ = false;
  std::vector<Finding> findings_;
};

}  // namespace

bool has_coordinates_of(const Recording& recording, const robot::Joint& joint) {
  const bool rotary = recording.coordinates == Coordinates::kRotary;
  return joint.electric ? rotary : !rotary || joint.actuator.area_a == joint.actuator.area_b;
}

std::vector<Finding> check_units(const Recording& recording, const robot::Joint& joint) {
  return recording.position.empty() ? std::vector<Finding>{} : UnitCheck(recording, joint).check();
}

}  // namespace farrier::diagnosis
