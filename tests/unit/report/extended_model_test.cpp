#include "diagnosis.hpp"

#include <fstream>

#include "report/diagnosis/extended_model.hpp"

#include "core/replace_file.hpp"

namespace farrier::report {
namespace extended_model_test {

using testing::active;

class ExtendedModel : public testing::OwnFolder {
 protected:
  const robot::Robot robot_ = testing::rig();
};

TEST_F(ExtendedModel, LoadsWithTheEffectsBesideThoseThatWereThere) {
  const robot::Joint& joint = robot_.joints[0];
  const std::vector<plant::ActiveEffect> first{active(testing::two_effects()[1], joint)};
  const auto text = extended_model(robot_, joint, first);
  ASSERT_TRUE(text.ok()) << text.error().message;
  const auto loaded = robot::load_robot_text(text.value(), "first");
  ASSERT_TRUE(loaded.ok());
  EXPECT_EQ(loaded.value().joints[0].effects, first);
  const auto more =
      extended_model(loaded.value(), loaded.value().joints[0], std::vector{active(testing::two_effects()[0], joint)});
  ASSERT_TRUE(more.ok()) << more.error().message;
  EXPECT_EQ(robot::load_robot_text(more.value(), "more").value().joints[0].effects.size(), 2u);
}

TEST_F(ExtendedModel, OfARotaryJointLeavesTheOthersAlone) {
  const robot::Robot hyq = testing::hyq();
  const robot::Joint& hip = *hyq.find("rh_haa");
  const auto text = extended_model(hyq, hip, std::vector{active(testing::two_effects()[0], hip)});
  ASSERT_TRUE(text.ok()) << text.error().message;
  const robot::Robot loaded = robot::load_robot_text(text.value(), "hyq").value();
  for (const robot::Joint& joint : loaded.joints) {
    EXPECT_EQ(joint.effects.size(), hyq.find(joint.name)->effects.size() + (joint.name == "rh_haa" ? 1u : 0u))
        << joint.name;
  }
}

TEST_F(ExtendedModel, RefusesWhatWouldNotLoad) {
  plant::ActiveEffect effect = active(testing::two_effects()[0], robot_.joints[0]);
  effect.values[0] = 1e9;
  const auto text = extended_model(robot_, robot_.joints[0], std::vector{effect});
  ASSERT_FALSE(text.ok());
  EXPECT_NE(text.error().message.find("coulomb_N"), std::string::npos) << text.error().message;
}

TEST_F(ExtendedModel, ItsFileIsReplacedWholeOrNotAtAll) {
  const std::string file = path_ + "/model.yaml";
  ASSERT_TRUE(replace_file(file, "old").ok());
  ASSERT_TRUE(replace_file(file, "new").ok());
  std::ifstream stream(file);
  EXPECT_EQ(std::string(std::istreambuf_iterator<char>(stream), {}), "new");
  EXPECT_FALSE(std::filesystem::exists(file + ".part"));
  EXPECT_FALSE(replace_file(path_ + "/nowhere/model.yaml", "new").ok());
}

}  // namespace extended_model_test
}  // namespace farrier::report
