// Words for curves, windows and effects that reports of a diagnosis use.

#include <cmath>

#include "diagnosis.hpp"
#include "report/diagnosis/diagnosis_pictures.hpp"
#include "report/diagnosis/effects_table.hpp"
#include "report/diagnosis/remedies.hpp"

namespace farrier::report {
namespace diagnosis_words_test {

TEST(Shape, IsNamedByTheCurveThatBinsFollow) {
  const auto shape = [](auto curve) { return shape_of(testing::dependence(curve)); };
  EXPECT_EQ(shape([](double x) { return 3.0 * x; }), "grows straight with speed");
  EXPECT_EQ(shape([](double x) { return -x; }), "falls straight with speed");
  EXPECT_EQ(shape([](double x) { return x > 0.0 ? -1.0 : 1.0; }), "jumps down where the sign changes of speed");
  EXPECT_EQ(shape([](double x) { return std::abs(x) - 0.5; }), "grows either way with speed");
  EXPECT_EQ(shape([](double x) { return 1.0 - 3.0 * x * x; }), "falls with the square of speed");
  EXPECT_EQ(shape([](double x) { return x * x * x * x * x; }), "grows with the cube of speed");
  EXPECT_EQ(shape([](double) { return 2.0; }), "is about the same over all of speed");
  EXPECT_EQ(shape([](double x) { return std::sin(20.0 * x); }), "changes with speed along no simple curve");
  EXPECT_EQ(shape_of(testing::dependence([](double x) { return x; }, "speed", 0.05)), "");
}

TEST(WorstSecond, IsWhereTheErrorIsLargest) {
  const diagnosis::ChannelReport c = testing::force_channel();
  const WorstWindow window = worst_second(c.measured, c.simulated_before, 0.001);
  EXPECT_EQ(window.begin, 600u);
  EXPECT_EQ(window.size, 1000u);
  EXPECT_EQ(worst_second(c.measured, c.simulated_before, 0.01).size, 100u);
  EXPECT_EQ(worst_second(c.measured, c.simulated_before, 1e-5).size, 2000u);
}

TEST(Remedies, StandForEveryEffectThatADiagnosisNames) {
  for (plant::EffectId id = 0; id < plant::kNameableCount; ++id) {
    EXPECT_STREQ(remedy_of(id).effect, plant::effect_info(id).name);
  }
}

TEST(EffectsTable, HasEveryEffectWithASentence) {
  const std::string table = effects_table_markdown();
  for (plant::EffectId id = 0; id < plant::kEffectCount; ++id) {
    EXPECT_NE(table.find("| `" + std::string(plant::effect_info(id).name) + "` |"), std::string::npos);
    EXPECT_STRNE(plant::effect_info(id).meaning, "") << plant::effect_info(id).name;
  }
}

}  // namespace diagnosis_words_test
}  // namespace farrier::report
