#include <gtest/gtest.h>
#include <mujoco/mujoco.h>

#include <fstream>
#include <memory>

#include "body/dynamics/rigid_body.hpp"
#include "core/noise.hpp"
#include "shipped.hpp"
#include "tests/support/scratch_directory.hpp"
#include "urdf/urdf_text.hpp"

namespace farrier::urdf {
namespace urdf_engine_test {

// MuJoCo finds the principal axes of a full tensor to 1e-8 of it.
constexpr double kOfAxes = 1e-6;
constexpr int kPoses = 20;

struct ModelDeleter {
  void operator()(mjModel* model) const { mj_deleteModel(model); }
};
struct DataDeleter {
  void operator()(mjData* data) const { mj_deleteData(data); }
};

/// The URDF under a floating joint, as MuJoCo reads it.
std::unique_ptr<mjModel, ModelDeleter> floating(const std::string& urdf) {
  const test::ScratchDirectory scratch;
  const std::string path = scratch.file("robot.urdf");
  std::ofstream(path) << with(
      urdf, "</robot>",
      "<link name=\"world\"/><joint name=\"floating\" type=\"floating\"><parent link=\"world\"/>"
      "<child link=\"base_link\"/></joint></robot>");
  char error[1000] = "";
  std::unique_ptr<mjModel, ModelDeleter> model(mj_loadXML(path.c_str(), nullptr, error, sizeof error));
  EXPECT_NE(model, nullptr) << error;
  return model;
}

class OfMujoco : public testing::TestWithParam<const char*> {};

TEST_P(OfMujoco, KinematicsAndMassMatrixOfTheUrdfAreOurs) {
  const robot::Robot robot = load_shipped(GetParam());
  const auto model = floating(urdf_text(robot).value());
  ASSERT_NE(model, nullptr);
  auto body = body::RigidBody::create(*robot.body).value();
  ASSERT_EQ(model->nv, body.velocities());
  const std::unique_ptr<mjData, DataDeleter> data(mj_makeData(model.get()));
  const NoiseStream draws(1, robot.name, "angles");
  Tick draw = 0;
  for (int pose = 0; pose < kPoses; ++pose) {
    body::BodyState state = body::BodyState::zero(body.joints());
    data->qpos[3] = 1.0;
    for (const robot::Joint& joint : robot.joints) {
      const double angle_rad = 4.0 * draws.uniform(draw++) - 2.0;
      state.angles_rad[joint.number] = angle_rad;
      const int id = mj_name2id(model.get(), mjOBJ_JOINT, joint.name.c_str());
      ASSERT_GE(id, 0) << joint.name;
      ASSERT_EQ(model->jnt_dofadr[id], body::kTrunkVelocities + joint.number) << "the order is that of the robot file";
      data->qpos[model->jnt_qposadr[id]] = angle_rad;
    }
    body.set_state(state);
    mj_kinematics(model.get(), data.get());
    mj_comPos(model.get(), data.get());
    mj_crb(model.get(), data.get());
    Eigen::MatrixXd mass(model->nv, model->nv);
    mj_fullM(model.get(), mass.data(), data->qM);
    const body::MassMatrix ours = body.mass_matrix();
    EXPECT_LT((mass - ours).cwiseAbs().maxCoeff(), kOfAxes * ours.cwiseAbs().maxCoeff());
    for (int leg = 0; leg < body.legs(); ++leg) {
      const Eigen::Vector3d foot_m = body.foot_position_m(leg);
      double nearest_m = 1.0;
      for (int geom = 0; geom < model->ngeom; ++geom) {
        nearest_m = std::min(nearest_m, (Eigen::Map<Eigen::Vector3d>(data->geom_xpos + 3 * geom) - foot_m).norm());
      }
      EXPECT_LT(nearest_m, 1e-12) << "a sphere is in the middle of foot " << leg;
    }
  }
}

INSTANTIATE_TEST_SUITE_P(ShippedRobots, OfMujoco, testing::ValuesIn(kWithBody));

}  // namespace urdf_engine_test
}  // namespace farrier::urdf
