#pragma once

// The physics engine: contacts of the feet with the scene, and the integration of the robot's motion. MuJoCo does the
// work behind this header; no other source knows it. decisions/0066 has the settings with their reasons.

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <memory>
#include <optional>

#include "body/engine/engine_fault.hpp"
#include "body/model/body_model.hpp"
#include "body/model/body_state.hpp"
#include "body/scene/scene.hpp"
#include "core/result.hpp"

namespace farrier::body {

/// The trunk's load from outside, in the world's axes.
struct TrunkWrench {
  Eigen::Vector3d force_N = Eigen::Vector3d::Zero();  ///< at the trunk's centre of mass
  Eigen::Vector3d torque_Nm = Eigen::Vector3d::Zero();
};

struct EngineSettings {
  double step_s = 0.00025;  ///< (0, 0.01]
};

/// The equations of motion as the engine sees them: M, c, and the feet's positions and Jacobians of RigidBody.
struct EngineDynamics {
  MassMatrix mass_matrix;
  VelocityVector bias_forces;
  std::array<Eigen::Vector3d, kMaxLegs> foot_position_m;
  std::array<FootJacobian, kMaxLegs> foot_jacobian;
  std::array<Eigen::Vector3d, kMaxLegs> foot_bias_acceleration_m_s2;  ///< (dJ/dt) v
};

/// A robot in a scene. The same model, scene, settings and inputs give the same bits: no state is carried from one step
/// to the next beside position and velocity, and sine and cosine are our own (own_math.hpp). One thread uses an engine
/// at a time; several engines may run at once.
class Engine {
 public:
  /// At rest in BodyState::zero. Refuses a model or a scene that its validate() refuses, and an engine that it cannot
  /// bind to our own sine and cosine.
  static Result<Engine> create(const BodyModel& model, const Scene& scene, const EngineSettings& settings = {});
  Engine(Engine&&) noexcept;
  Engine& operator=(Engine&&) noexcept;
  ~Engine();

  /// Continues from this state. Steps are counted from zero again, and a failure is cleared.
  void set_state(const BodyState& state) noexcept;

  /// Replaces the trunk's inertia, as when a payload is put on it. It must be one that validate() accepts.
  void set_trunk(const RigidInertia& trunk) noexcept;

  /// Holds torques, one per joint of the model, and wrench over one step. A step that fails leaves the state as it was,
  /// and no further step moves it. It allocates nothing.
  void step(const JointVector& torques_Nm, const TrunkWrench& wrench = {}) noexcept;

  /// The state after the last good step.
  BodyState state() const noexcept;

  /// Force of the scene on a foot during the last step, in the world's axes.
  Eigen::Vector3d contact_force_N(int leg) const noexcept;

  /// Steps since set_state().
  std::int64_t steps() const noexcept;
  const std::optional<EngineFailure>& failure() const noexcept;

  /// The engine's own step by itself, as often as asked, which farrier bench holds a whole run against. No failure is
  /// noted, contact forces are not summed and steps are not counted.
  void bare_steps(const JointVector& torques_Nm, int steps) noexcept;

  /// The engine's own dynamics in a state, to compare RigidBody with. Nothing that they do not need is computed. The
  /// engine's state changes. It allocates nothing.
  EngineDynamics dynamics(const BodyState& state) noexcept;

 private:
  struct Simulation;
  explicit Engine(std::unique_ptr<Simulation> simulation) noexcept;
  std::unique_ptr<Simulation> simulation_;
};

}  // namespace farrier::body
