#include <gtest/gtest.h>

#include "sample.hpp"

namespace farrier::config::sample {
namespace reader_test {

TEST(ConfigReader, ReadsEveryKindOfParameter) {
  const auto cart = read_text<Cart>(kGood +
                                        "drag_Ns_m: 1.5e0\nseats: +4\nbrakes: false\ncolour: blue\n"
                                        "gears: [1, 2.5]\ntrailer: {axles: 2}\n",
                                    "cart.yaml");
  ASSERT_TRUE(cart.ok()) << to_string(cart.error());
  const Cart& c = cart.value();
  EXPECT_EQ(c.name, "cart");
  EXPECT_EQ(c.mass_kg, 20.0);
  EXPECT_EQ(c.drag_Ns_m, 1.5);
  EXPECT_EQ(c.seats, 4);
  EXPECT_FALSE(c.brakes);
  EXPECT_EQ(c.colour, Colour::kBlue);
  EXPECT_EQ(c.gears, (std::vector<double>{1.0, 2.5}));
  EXPECT_EQ(c.drivers, (std::vector<std::string>{"ann", "bob"}));
  ASSERT_TRUE(c.trailer.has_value());
  EXPECT_EQ(c.trailer->axles, 2);
  ASSERT_EQ(c.wheels.size(), 2u);
  EXPECT_EQ(c.wheels[0].first, "left");
  EXPECT_EQ(c.wheels[1].second.radius_m, 0.4);
  EXPECT_EQ(c.roles, (Named<std::string>{{"ann", "front"}, {"bob", "rear"}}));
}

TEST(ConfigReader, FillsInDefaults) {
  const auto cart = read_text<Cart>(kGood, "cart.yaml");
  ASSERT_TRUE(cart.ok()) << to_string(cart.error());
  EXPECT_EQ(cart.value().drag_Ns_m, 5.0);
  EXPECT_EQ(cart.value().seats, 2);
  EXPECT_TRUE(cart.value().brakes);
  EXPECT_EQ(cart.value().colour, Colour::kGreen);
  EXPECT_FALSE(cart.value().trailer.has_value());
  EXPECT_EQ(cart.value().wheels[0].second.pressure_Pa, 2e5);
}

TEST(ConfigReader, LeavesOutWhatHasDefaultsThroughout) {
  const auto cart = read_text<Cart>(kGood, "cart.yaml");
  ASSERT_TRUE(cart.ok()) << to_string(cart.error());
  EXPECT_EQ(cart.value().owner, "nobody");
  EXPECT_EQ(cart.value().lamp.power_W, Lamp{}.power_W);
  EXPECT_TRUE(cart.value().lanterns.empty());
}

TEST(ConfigReader, ChecksWhatMayBeLeftOutOnceItIsThere) {
  EXPECT_EQ(mistakes_with("lamp: {power_W: 900}\n"),
            "cart.yaml:9: lamp.power_W: 900 is out of range: give 1 to 100\n");
  EXPECT_EQ(mistakes_with("lamp: bright\n"), "cart.yaml:9: lamp: is bright: give a group of parameters\n");
  EXPECT_EQ(mistakes_with("lanterns: {}\n"), "cart.yaml:9: lanterns: is empty: give at least one entry\n");
  EXPECT_EQ(mistakes_with("lanterns:\n  red: {powr_W: 2}\n"),
            "cart.yaml:10: lanterns.red.powr_W: is not a known parameter: did you mean power_W?\n");
  EXPECT_EQ(mistakes_with("owner: 3 men\n").substr(0, 18), "cart.yaml:9: owner");
}

TEST(ConfigReader, KnowsTheLineOfEveryKey) {
  const auto cart = read_text<Cart>(kGood, "cart.yaml");
  ASSERT_TRUE(cart.ok());
  EXPECT_EQ(to_string(cart.value().place.problem("wheels", "is odd")), "cart.yaml:4: wheels: is odd");
  EXPECT_EQ(to_string(cart.value().roles_place.problem("bob", "is odd")), "cart.yaml:8: roles.bob: is odd");
}

TEST(ConfigReader, NamesTheRangeOfAValueOutsideIt) {
  EXPECT_EQ(mistakes("mass_kg: 20", "mass_kg: -3"), "cart.yaml:2: mass_kg: -3 is out of range: give 0.01 to 1000\n");
  EXPECT_EQ(mistakes("radius_m: 0.4", "radius_m: 40"),
            "cart.yaml:7: wheels.right.radius_m: 40 is out of range: give 0.1 to 1\n");
  EXPECT_EQ(mistakes_with("seats: 99999999999999999999\n"),
            "cart.yaml:9: seats: 99999999999999999999 is out of range: give 1 to 8\n");
  EXPECT_EQ(mistakes_with("gears: [1,\n 20]\n"), "cart.yaml:10: gears[1]: 20 is out of range: give 0.1 to 10\n");
}

TEST(ConfigReader, AcceptsTheEndsOfARange) {
  EXPECT_EQ(mistakes("mass_kg: 20", "mass_kg: 1000"), "");
  EXPECT_EQ(mistakes_with("drag_Ns_m: 0\n"), "");
}

TEST(ConfigReader, RefusesNumbersThatAreNotFinite) {
  for (const char* text : {".inf", "-.inf", ".nan", "inf", "nan", "-nan", "1e999"}) {
    EXPECT_EQ(mistakes("mass_kg: 20", std::string("mass_kg: ") + text),
              std::string("cart.yaml:2: mass_kg: ") + text + " is not a finite number: give 0.01 to 1000\n");
  }
}

TEST(ConfigReader, RefusesTheWrongType) {
  const std::string where = "cart.yaml:2: mass_kg: ";
  const std::string remedy = " is not a number: give 0.01 to 1000\n";
  EXPECT_EQ(mistakes("mass_kg: 20", "mass_kg: heavy"), where + "heavy" + remedy);
  EXPECT_EQ(mistakes("mass_kg: 20", "mass_kg: \"20\""), where + "\"20\"" + remedy);
  EXPECT_EQ(mistakes("mass_kg: 20", "mass_kg: 20 kg"), where + "20 kg" + remedy);
  EXPECT_EQ(mistakes("mass_kg: 20", "mass_kg: 0x14"), where + "0x14" + remedy);
  EXPECT_EQ(mistakes("mass_kg: 20", "mass_kg: [20]"), where + "a list" + remedy);
  EXPECT_EQ(mistakes("mass_kg: 20", "mass_kg:"), where + "nothing" + remedy);
  EXPECT_EQ(mistakes_with("seats: 2.5\n"), "cart.yaml:9: seats: 2.5 is not a whole number: give 1 to 8\n");
  EXPECT_EQ(mistakes_with("brakes: yes\n"), "cart.yaml:9: brakes: yes is neither true nor false: give one of them\n");
  EXPECT_EQ(mistakes_with("gears: 3\n"), "cart.yaml:9: gears: 3 is not a list: give [ ..., ... ]\n");
  EXPECT_EQ(mistakes_with("trailer: 3\n"), "cart.yaml:9: trailer: is 3: give a group of parameters\n");
}

TEST(ConfigReader, ListsTheChoicesOfAnEnum) {
  EXPECT_EQ(mistakes_with("colour: pink\n"), "cart.yaml:9: colour: pink is not known: give red, green or blue\n");
}

TEST(ConfigReader, RejectsInvalidNames) {
  EXPECT_EQ(mistakes("name: cart", "name: my cart"),
            "cart.yaml:1: name: my cart is not a name: give 1 to 8 letters, digits, \"_\" or \"-\"\n");
  EXPECT_EQ(mistakes("name: cart", "name: wheelbarrow"),
            "cart.yaml:1: name: wheelbarrow is not a name: give 1 to 8 letters, digits, \"_\" or \"-\"\n");
  EXPECT_EQ(mistakes("  left:", "  far-too-long:"),
            "cart.yaml:5: wheels: far-too-long is not a name: give 1 to 8 letters, digits, \"_\" or \"-\"\n");
}

TEST(ConfigReader, SaysWhatIsMissingAndWhatItIsFor) {
  EXPECT_EQ(mistakes("mass_kg: 20\n", ""), "cart.yaml:1: mass_kg: is missing: give 0.01 to 1000 (Mass of the cart.)\n");
  EXPECT_EQ(mistakes("    radius_m: 0.4\n", "    pressure_Pa: 3e5\n"),
            "cart.yaml:6: wheels.right.radius_m: is missing: give 0.1 to 1 (Radius of the wheel.)\n");
}

TEST(ConfigReader, SuggestsTheNearestNameForAnUnknownOne) {
  EXPECT_EQ(mistakes("mass_kg: 20", "mas_kg: 20"),
            "cart.yaml:2: mas_kg: is not a known parameter: did you mean mass_kg?\n");
  EXPECT_EQ(mistakes_with("trailer: {axles: 1, zzz: 3}\n"),
            "cart.yaml:9: trailer.zzz: is not a known parameter here; known are axles\n");
}

TEST(ConfigReader, NamesTheUnitWhenOnlyThatIsWrong) {
  EXPECT_EQ(mistakes("{radius_m: 0.3}", "{radius_mm: 300}"),
            "cart.yaml:5: wheels.left.radius_mm: is given in m: radius_m\n");
  EXPECT_EQ(mistakes("{radius_m: 0.3}", "{radius_m: 0.3, pressure_bar: 2}"),
            "cart.yaml:5: wheels.left.pressure_bar: is given in Pa: pressure_Pa\n");
  EXPECT_EQ(mistakes("mass_kg: 20", "mass: 20"), "cart.yaml:2: mass: is given in kg: mass_kg\n");
  EXPECT_EQ(mistakes_with("drag_kg_s: 5\n"), "cart.yaml:9: drag_kg_s: is given in Ns_m: drag_Ns_m\n");
}

TEST(ConfigReader, RefusesAKeyGivenTwice) {
  EXPECT_EQ(mistakes_with("mass_kg: 21\n"), "cart.yaml:9: mass_kg: is given twice, first in line 2: remove one\n");
  EXPECT_EQ(mistakes("  right:", "  left:"),
            "cart.yaml:6: wheels.left: is given twice, first in line 5: remove one\n");
}

TEST(ConfigReader, ChecksConditionsBetweenParameters) {
  EXPECT_EQ(mistakes_with("drag_Ns_m: 30\n"), "cart.yaml:9: drag_Ns_m: must be below mass_kg\n");
}

TEST(ConfigReader, DoesNotJudgeConditionsOfParametersItCouldNotRead) {
  EXPECT_EQ(mistakes("mass_kg: 20", "mass_kg: heavy"),
            "cart.yaml:2: mass_kg: heavy is not a number: give 0.01 to 1000\n");
}

TEST(ConfigReader, ListsAllMistakesAtOnceInTheOrderOfTheFile) {
  const auto cart = read_text<Cart>(
      "name: cart\n"
      "mass_kg: .nan\n"
      "colour: pink\n"
      "seats: two\n"
      "wheels:\n"
      "  left: {radius_cm: 30}\n"
      "  right: {radius_m: 30, flat: true}\n",
      "cart.yaml");
  ASSERT_FALSE(cart.ok());
  EXPECT_EQ(to_string(cart.error()),
            "cart.yaml:1: drivers: is missing: give [ name, ... ] (Who may drive.)\n"
            "cart.yaml:1: roles: is missing: give this group (Who does what.)\n"
            "cart.yaml:2: mass_kg: .nan is not a finite number: give 0.01 to 1000\n"
            "cart.yaml:3: colour: pink is not known: give red, green or blue\n"
            "cart.yaml:4: seats: two is not a whole number: give 1 to 8\n"
            "cart.yaml:6: wheels.left.radius_cm: is given in m: radius_m\n"
            "cart.yaml:7: wheels.right.radius_m: 30 is out of range: give 0.1 to 1\n"
            "cart.yaml:7: wheels.right.flat: is not a known parameter here; known are radius_m, pressure_Pa\n");
}

TEST(ConfigReader, AppliesSettingsFromOutsideTheFileAndChecksThem) {
  const auto cart = read_text<Cart>(kGood, "cart.yaml", {{"mass_kg", "30"}, {"trailer.axles", "3"}});
  ASSERT_TRUE(cart.ok()) << to_string(cart.error());
  EXPECT_EQ(cart.value().mass_kg, 30.0);
  EXPECT_EQ(cart.value().trailer->axles, 3);
  const auto refused = read_text<Cart>(kGood, "cart.yaml", {{"mass_kg", "-1"}, {"name.first", "x"}});
  ASSERT_FALSE(refused.ok());
  EXPECT_EQ(to_string(refused.error()),
            "cart.yaml: name.first: cannot be set: the path leads through a value that is not a group\n"
            "cart.yaml: mass_kg: -1 is out of range: give 0.01 to 1000\n");
}

}  // namespace reader_test
}  // namespace farrier::config::sample
