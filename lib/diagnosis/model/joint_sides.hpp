#pragma once

#include <limits>
#include <span>
#include <vector>

#include "diagnosis/data/joint_data.hpp"
#include "diagnosis/data/recording.hpp"
#include "diagnosis/model/model.hpp"
#include "plant/joint.hpp"
#include "plant/terms/terms.hpp"

namespace farrier::diagnosis {

/// Spring and damper by which a joint's command holds it amid its travel, Nm/rad and Nms/rad. Zeros: it is not held.
struct Hold {
  double stiffness = 0.0, damping = 0.0;
};

/// Simulations of the two sides into which the force sensor splits a joint, and of its velocity sensor. Hydraulic joints
/// are a JointModel, electric ones an ElectricModel.
class JointSides {
 public:
  virtual ~JointSides() = default;

  /// Name of the side of the actuator, in reports and JSON.
  virtual const char* actuator_side() const noexcept = 0;
  virtual const plant::Scales& scales() const noexcept = 0;
  virtual const plant::LoadParams& load() const noexcept = 0;
  /// Numbers of an effect that the joint is known to have, null for none.
  virtual const std::vector<double>* known(plant::EffectId id) const noexcept = 0;

  /// Channels on which an effect shows; none for one that such joints do not have.
  virtual ChannelMask channels(plant::EffectId id) const noexcept = 0;
  /// True if an effect of the valve also bends the force between samples, which moves the load.
  virtual bool bends_force(plant::EffectId) const noexcept { return false; }
  /// Channels that a nominal factor concerns; none for one that the joint's model does not have.
  virtual ChannelMask nominal_channels(std::size_t factor) const noexcept = 0;
  /// Nominal factor whose place an effect takes, kNominals for none.
  virtual std::size_t replaced(plant::EffectId id) const noexcept = 0;
  /// True if a fit may change that number of an effect.
  virtual bool fits(plant::EffectId id, std::size_t parameter) const noexcept = 0;
  /// Numbers of an effect from which its fits to `data` begin.
  virtual std::vector<std::vector<double>> starts(plant::EffectId id, const JointData& data) const = 0;

  /// A recording made ready; `position_noise` as of the joint's sensor, > 0.
  virtual JointData prepared(const Recording& recording, double position_noise) const = 0;

  /// Simulated readings over a span: force; motion of the load, as JointData::motion; velocity sensor.
  virtual std::vector<double> simulate(const JointData& data, Span span, const Model& model, Channel channel,
                                       const Observer& observer) const = 0;
  /// simulate() with derivatives as Simulator::simulate_lanes has them.
  virtual std::vector<double> simulate_lanes(const JointData& data, Span span, const Model& model, Channel channel,
                                             const Observer& observer, const std::vector<std::size_t>& lanes,
                                             std::vector<double>& jacobian) const = 0;
  /// Errors, measured less simulated, of simulations that leave an observed one every `every` samples of a span and run
  /// freely for `steps`, by the places where they leave. They are errors of the force, or of the load's position over
  /// JointData::kMotionTime_s.
  virtual std::vector<double> errors_ahead(const JointData& data, Span span, const Model& model, Channel channel,
                                           const Observer& observer, std::size_t steps, std::size_t every) const = 0;

  /// Hold that keeps the joint amid its travel under a command without mean.
  virtual Hold hold() const noexcept { return {}; }
  /// Torque that the drive's command of 1 A asks for, Nm/A; 0 of a valve.
  virtual double torque_per_A() const noexcept { return 0.0; }
  /// Largest force at the sensor for which the joint is made, N or Nm.
  virtual double largest_force() const noexcept { return std::numeric_limits<double>::infinity(); }
  /// Readings of the whole joint with the model's effects, a period each, from rest amid its travel under `current_A`
  /// beside hold(). Empty if no such joint can be simulated.
  virtual std::vector<plant::JointReadings> respond(const Model& model, std::span<const double> current_A,
                                                    double period_s) const = 0;
};

/// Starts of an effect of either kind of joint: those of the library, springs slack where the load's is or amid the
/// recorded positions.
std::vector<std::vector<double>> usual_starts(const JointSides& joint, plant::EffectId id, const JointData& data);

/// Nominal factor of the load whose place an effect of the load takes, kNominals for none.
std::size_t replaced_of_load(plant::EffectId id) noexcept;

}  // namespace farrier::diagnosis
