#include "body/model/body_model.hpp"

#include <gtest/gtest.h>

#include <limits>

#include "test_bodies.hpp"

namespace farrier::body {
namespace body_model_test {

std::string refusal(const BodyModel& model) {
  const auto valid = validate(model);
  return valid ? "" : valid.error().message;
}

TEST(BodyModel, AcceptsAnyAxesAndOffsets) {
  for (int legs = 1; legs <= kMaxLegs; ++legs) {
    EXPECT_EQ(refusal(random_body(legs, 1)), "") << legs;
  }
}

TEST(BodyModel, RefusesAnotherNumberOfLegs) {
  EXPECT_EQ(refusal(random_body(0, 1)), "the body has 0 legs: give 1 to 6");
  EXPECT_EQ(refusal(random_body(7, 1)), "the body has 7 legs: give 1 to 6");
}

TEST(BodyModel, NamesTheBodyWithoutMass) {
  BodyModel model = random_body(2, 1);
  model.legs[1].links[2].inertia.mass_kg = 0.0;
  EXPECT_EQ(refusal(model), "leg leg1: the third link has no mass: give its mass in kg, above zero");
}

TEST(BodyModel, RefusesATensorAgainstTheTriangleInequality) {
  BodyModel model = random_body(2, 1);
  model.trunk.tensor_kg_m2 = Eigen::Vector3d(1.0, 2.0, 3.01).asDiagonal();
  EXPECT_EQ(refusal(model),
            "the trunk has a tensor that no masses can have: no principal moment may exceed the sum of the others");
}

TEST(BodyModel, RefusesARodWithoutInertiaAboutItself) {
  BodyModel model = random_body(2, 1);
  model.legs[0].links[0].inertia.tensor_kg_m2 = Eigen::Vector3d(0.0, 2.0, 2.0).asDiagonal();
  EXPECT_TRUE(is_possible_tensor(model.legs[0].links[0].inertia.tensor_kg_m2));
  EXPECT_EQ(refusal(model),
            "leg leg0: the first link has a tensor that is not positive definite: give every principal moment, above "
            "zero");
}

TEST(BodyModel, RefusesAnAsymmetricTensor) {
  BodyModel model = random_body(1, 1);
  model.trunk.tensor_kg_m2(0, 1) += 0.1;
  EXPECT_EQ(refusal(model), "the trunk has a tensor that is not symmetric");
}

TEST(BodyModel, RefusesAnAxisThatIsNotOfUnitLength) {
  BodyModel model = random_body(1, 1);
  model.legs[0].links[1].axis *= 1.01;
  EXPECT_EQ(refusal(model), "leg leg0: the second link has an axis that is not of unit length");
}

TEST(BodyModel, RefusesAFootWithoutRadius) {
  BodyModel model = random_body(1, 1);
  model.legs[0].foot_radius_m = 0.0;
  EXPECT_EQ(refusal(model), "leg leg0: the foot has no size: give the radius of its sphere in m, above zero");
}

TEST(BodyModel, RefusesStopsThatLeaveNoAngle) {
  BodyModel model = random_body(1, 1);
  model.legs[0].links[2].stops = {0.5, 0.5};
  EXPECT_EQ(refusal(model),
            "leg leg0: the third link has stops that leave no angle between them: give the least angle first");
}

TEST(BodyModel, RefusesAKneeOrATrunksBoxOfNoSize) {
  BodyModel model = random_body(1, 1);
  model.legs[0].knee_radius_m = -0.1;
  EXPECT_EQ(refusal(model), "leg leg0: the knee has a negative radius: give zero for none");
  model = random_body(1, 1);
  model.box = TrunkBox{};
  EXPECT_EQ(refusal(model), "the trunk has a box without volume: give three half extents in m, above zero");
}

TEST(BodyModel, RefusesNumbersThatAreNotFinite) {
  constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
  BodyModel model = random_body(1, 1);
  model.trunk.com_m.x() = kNaN;
  EXPECT_NE(refusal(model), "");
  model = random_body(1, 1);
  model.legs[0].links[0].axis.x() = kNaN;
  EXPECT_NE(refusal(model), "");
  model = random_body(1, 1);
  model.gravity_m_s2 = kNaN;
  EXPECT_NE(refusal(model), "");
}

TEST(BodyModel, AddsUpAllMasses) {
  BodyModel model = random_body(2, 1);
  double sum = model.trunk.mass_kg;
  for (const LegModel& leg : model.legs) {
    sum += leg.links[0].inertia.mass_kg + leg.links[1].inertia.mass_kg + leg.links[2].inertia.mass_kg;
  }
  EXPECT_DOUBLE_EQ(total_mass_kg(model), sum);
}

}  // namespace body_model_test
}  // namespace farrier::body
