// estimator_service: joint/measurement ──▶ one estimator per joint ──▶ joint/model_estimate

#include "participant/plain_processes.hpp"
#include "process/process.hpp"

int main(int argc, char** argv) {
  using namespace farrier;
  const auto options = participant::parse_options("estimator_service", "Estimates every joint's dynamics", argc, argv);
  return process::run(options, [&](auto& member, const auto& robot) {
    return estimator_service::create_application(robot, member, options.ticks);
  });
}
