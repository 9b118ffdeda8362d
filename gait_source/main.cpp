// gait_source: clock/tick ──▶ the gait section of the robot file ──▶ joint/command, gait/phase
// A user's planner can take its place in the run.

#include "gait_source/gait_source.hpp"
#include "process/process.hpp"

int main(int argc, char** argv) {
  using namespace farrier;
  const auto options = participant::parse_options("gait_source", "Plays the robot file's gait", argc, argv);
  using Made = Result<std::unique_ptr<participant::Application>>;
  return process::run(options, [&](auto& member, const auto& robot) -> Made {
    auto gait = FARRIER_TRY(gait_source::GaitSource::create(robot, options.seed, member, options.ticks));
    return std::unique_ptr<participant::Application>(std::move(gait));
  });
}
