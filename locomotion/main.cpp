// locomotion: clock/tick ──▶ joint/command, gait/phase. On a bench it plays the gait section of the robot file; a body
// on a ground it controls by joint/sensors and body/imu. A user's planner can take its place in the run.

#include "locomotion/body_locomotion.hpp"
#include "locomotion/gait_source.hpp"
#include "process/process.hpp"

int main(int argc, char** argv) {
  using namespace farrier;
  const auto options =
      participant::parse_options("locomotion", "Commands all joints: plays a gait, or walks", argc, argv);
  using Made = Result<std::unique_ptr<participant::Application>>;
  return process::run(options, [&](auto& member, const auto& robot) -> Made {
    auto made = FARRIER_TRY(
        participant::is_on_ground(options.world)
            ? locomotion::create_trot_locomotion(robot, locomotion::script_of(options.velocity), member, options.ticks,
                                                 participant::tells_supply(options.world, robot.supply.has_value()))
            : locomotion::create_gait_source(robot, options.seed, member, options.ticks));
    return std::unique_ptr<participant::Application>(std::move(made));
  });
}
