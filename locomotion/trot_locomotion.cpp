#include "locomotion/body_locomotion.hpp"
#include "locomotion/trot_controller.hpp"
#include "robot/locomotion_model.hpp"
#include "robot/locomotion_params.hpp"

namespace farrier::locomotion {
namespace {

/// The trot controller with the model that it refers to.
class OwnedTrot final : public Controller {
 public:
  OwnedTrot(const robot::Robot& robot, robot::LocomotionModel model)
      : model_(std::move(model)), trot_(*robot.locomotion, robot::locomotion_plan(robot.plan), model_) {}

  const LegTorques& step(Tick now, const Readings& readings, const MotionCommand& command) noexcept override {
    return trot_.step(now, readings, command);
  }
  std::optional<gait::PhaseSwitch> announcement(int leg) const noexcept override { return trot_.announcement(leg); }
  const LocomotionState* published_state() const noexcept override { return trot_.published_state(); }

 private:
  robot::LocomotionModel model_;
  TrotController trot_;
};

}  // namespace

std::vector<TimedCommand> script_of(const std::vector<double>& velocity) {
  if (velocity.empty()) {
    return {};
  }
  return walk_script(
      {.request = Request::kTrot, .forward_m_s = velocity[0], .left_m_s = velocity[1], .yaw_rate_rad_s = velocity[2]});
}

Result<std::unique_ptr<Locomotion>> create_trot_locomotion(const robot::Robot& robot, std::vector<TimedCommand> script,
                                                           participant::Participant& participant, Tick ticks,
                                                           bool hears_supply) {
  if (!robot.can_walk()) {
    return Error{robot.cannot_walk_error()};
  }
  auto model = FARRIER_TRY(robot::LocomotionModel::create(*robot.body));
  return create_body_locomotion(robot, std::make_unique<OwnedTrot>(robot, std::move(model)), std::move(script),
                                participant, ticks, hears_supply);
}

}  // namespace farrier::locomotion
