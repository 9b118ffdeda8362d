// controller ROBOT.yaml: designs a force controller for HyQ's left front knee and runs it on the simulated joint.
#include <cstdio>
#include "control/law/force_controller.hpp"
#include "robot/joint_model.hpp"
#include "robot/joint_plant.hpp"

int main(int argc, char** argv) {
  using namespace farrier;
  const auto robot = robot::load_robot(argc > 1 ? argv[1] : "");
  if (!robot) {
    std::fputs(config::to_string(robot.error()).c_str(), stderr);
    return 2;
  }
  const double period_s = robot.value().period_s;
  const robot::Joint& knee = *robot.value().find("lf_kfe");
  plant::Joint joint = robot::make_plant(knee, knee.stance_load).value();  // at rest in its home pose
  const double home = joint.readings().position;

  control::LqrWeights weights;  // on normalised states
  weights.force = 2000.0;
  const control::DiscreteModel model = robot::model_of(knee, knee.stance_load, period_s);
  control::ForceController controller;
  controller.set_gains(control::design_lqr(model, weights, knee.normalisation, knee.form, 0).value(), {}, 0.0);

  for (int tick = 0; tick <= 20; ++tick) {
    const auto [position, velocity, force] = joint.readings();
    const double current_A = controller.step(1000.0, {position - home, velocity, force}).valve_current_A;
    if (tick % 4 == 0) std::printf("tick %2d: force %6.1f N, valve %5.2f mA\n", tick, force, 1e3 * current_A);
    joint.step(current_A, -1000.0, period_s);  // a weight of 1000 N presses on the cylinder
  }
}
