#pragma once

#include <array>
#include <vector>

#include "diagnosis/model/joint_sides.hpp"
#include "plant/electric_actuator.hpp"

namespace farrier::diagnosis {

template <class T>
struct DriveNumbers;
template <class T>
struct LoadNumbers;

/// An electric joint as its file has it, for simulations of its sides: motor and gear from current and motion to the
/// torque at the sensor, the load from that torque to the motion. A rigid drive knows its torque from its current;
/// all that moves with the rotor is then on the side of the load.
class ElectricModel final : public JointSides {
 public:
  /// `rated_torque_Nm` > 0: the unit of torques of effects.
  ElectricModel(const plant::ElectricParams& drive, const plant::LoadParams& load, double rated_torque_Nm);

  const plant::ElectricParams& drive() const noexcept { return drive_; }

  const char* actuator_side() const noexcept override { return "drive"; }
  const plant::Scales& scales() const noexcept override { return scales_; }
  const plant::LoadParams& load() const noexcept override { return load_; }
  const std::vector<double>* known(plant::EffectId) const noexcept override { return nullptr; }
  ChannelMask channels(plant::EffectId id) const noexcept override;
  ChannelMask nominal_channels(std::size_t factor) const noexcept override;
  std::size_t replaced(plant::EffectId id) const noexcept override;
  bool fits(plant::EffectId id, std::size_t parameter) const noexcept override;
  std::vector<std::vector<double>> starts(plant::EffectId id, const JointData& data) const override;

  JointData prepared(const Recording& recording, double position_noise) const override;
  std::vector<double> simulate(const JointData& data, Span span, const Model& model, Channel channel,
                               const Observer& observer) const override;
  std::vector<double> simulate_lanes(const JointData& data, Span span, const Model& model, Channel channel,
                                     const Observer& observer, const std::vector<std::size_t>& lanes,
                                     std::vector<double>& jacobian) const override;
  std::vector<double> errors_ahead(const JointData& data, Span span, const Model& model, Channel channel,
                                   const Observer& observer, std::size_t steps, std::size_t every) const override;

  /// A spring of 2 Hz with half the critical damping, which asks at most half the rating at an end of the travel.
  Hold hold() const noexcept override;
  double torque_per_A() const noexcept override { return drive_.gear_ratio * drive_.torque_constant_Nm_A; }
  double largest_force() const noexcept override { return scales_.of(plant::Scale::kForce); }
  std::vector<plant::JointReadings> respond(const Model& model, std::span<const double> current_A,
                                            double period_s) const override;

 private:
  /// Steps that contacts and lags of a simulation have, s.
  struct Steps {
    double period_s, drive_s, load_s;
  };
  static Steps steps_of(const JointData& data) noexcept;
  template <class T>
  struct Parts;
  template <class T>
  Parts<T> parts(const Steps& steps, const std::array<T, kNominals>& factors, const EffectNumbers<T>& effects) const;
  /// True if a lane is by a number on which the torque at the sensor depends.
  bool moves_drive(const Model& model, const std::vector<std::size_t>& lanes) const noexcept;
  template <class T>
  std::vector<T> run(const JointData& data, Span span, const std::array<T, kNominals>& factors,
                     const EffectNumbers<T>& effects, Channel channel, const Observer& observer) const;

  plant::ElectricParams drive_;
  plant::LoadParams load_;
  plant::Scales scales_;
};

}  // namespace farrier::diagnosis
