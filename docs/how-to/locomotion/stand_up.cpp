// stand_up: takes the place of Farrier's locomotion and stands the robot up.

#include "stand_up.hpp"

#include "locomotion/body_locomotion.hpp"
#include "process/process.hpp"
#include "robot/locomotion_model.hpp"

namespace {

using namespace farrier;

/// The controller with the model that it refers to.
class OwnedStandUp final : public locomotion::Controller {
 public:
  OwnedStandUp(const robot::Robot& robot, robot::LocomotionModel model)
      : model_(std::move(model)), stand_up_(model_, robot.plan, robot.locomotion->reference.default_height_m) {}

  const locomotion::LegTorques& step(Tick now, const locomotion::Readings& readings,
                                     const locomotion::MotionCommand& command) noexcept override {
    return stand_up_.step(now, readings, command);
  }

 private:
  robot::LocomotionModel model_;
  locomotion::StandUp stand_up_;
};

Result<std::unique_ptr<participant::Application>> stand_up(participant::Participant& member, const robot::Robot& robot,
                                                           Tick ticks) {
  if (!robot.can_walk()) {
    return Error{robot.cannot_walk_error()};
  }
  auto model = FARRIER_TRY(robot::LocomotionModel::create(*robot.body));
  auto made = FARRIER_TRY(locomotion::create_body_locomotion(
      robot, std::make_unique<OwnedStandUp>(robot, std::move(model)), {}, member, ticks));
  return std::unique_ptr<participant::Application>(std::move(made));
}

}  // namespace

int main(int argc, char** argv) {
  const auto options = participant::parse_options("locomotion", "Stands the robot up", argc, argv);
  return process::run(options, [&](auto& member, const auto& robot) { return stand_up(member, robot, options.ticks); });
}
