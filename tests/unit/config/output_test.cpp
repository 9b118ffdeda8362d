#include <gtest/gtest.h>

#include "config/printer.hpp"
#include "config/reference_table.hpp"
#include "config/suggest.hpp"
#include "sample.hpp"

namespace farrier::config::sample {
namespace output_test {

TEST(ConfigPrinter, PrintsEveryParameterWithItsEffectiveValue) {
  const auto cart = read_text<Cart>(kGood + "gears: [1, 2.5]\ntrailer: {axles: 2}\n", "cart.yaml");
  ASSERT_TRUE(cart.ok()) << to_string(cart.error());
  EXPECT_EQ(print_yaml(cart.value()),
            "name: \"cart\"\n"
            "mass_kg: 20\n"
            "drag_Ns_m: 5\n"
            "seats: 2\n"
            "brakes: true\n"
            "colour: green\n"
            "gears: [1, 2.5]\n"
            "drivers: [\"ann\", \"bob\"]\n"
            "trailer:\n"
            "  axles: 2\n"
            "wheels:\n"
            "  \"left\":\n"
            "    radius_m: 0.3\n"
            "    pressure_Pa: 2e+05\n"
            "  \"right\":\n"
            "    radius_m: 0.4\n"
            "    pressure_Pa: 2e+05\n"
            "roles:\n"
            "  \"ann\": \"front\"\n"
            "  \"bob\": \"rear\"\n"
            "owner: \"nobody\"\n"
            "lamp:\n"
            "  power_W: 5\n");
}

TEST(ConfigPrinter, PrintsWhatMayBeAbsentSoThatItReadsBack) {
  const auto cart = read_text<Cart>(
      kGood + "owner: eve\nlamp: {power_W: 7}\nlanterns: {red: {power_W: 2}, blue: {}}\n", "cart.yaml");
  ASSERT_TRUE(cart.ok()) << to_string(cart.error());
  const std::string printed = print_yaml(cart.value());
  EXPECT_NE(printed.find("owner: \"eve\"\nlamp:\n  power_W: 7\n"
                         "lanterns:\n  \"red\":\n    power_W: 2\n  \"blue\":\n    power_W: 5\n"),
            std::string::npos)
      << printed;
  const auto again = read_text<Cart>(printed, "printed");
  ASSERT_TRUE(again.ok()) << to_string(again.error());
  EXPECT_EQ(print_yaml(again.value()), printed);
}

TEST(ConfigPrinter, ReadsBackBitForBit) {
  auto cart = read_text<Cart>(kGood, "cart.yaml");
  ASSERT_TRUE(cart.ok());
  cart.value().mass_kg = 20.1 + 0.2;  // has no short decimal
  cart.value().name = "true";        // would be a flag without quotes
  const auto again = read_text<Cart>(print_yaml(cart.value()), "printed");
  ASSERT_TRUE(again.ok()) << to_string(again.error());
  EXPECT_EQ(again.value().mass_kg, 20.1 + 0.2);
  EXPECT_EQ(again.value().name, "true");
  EXPECT_EQ(print_yaml(again.value()), print_yaml(cart.value()));
}

TEST(ConfigReferenceTable, ListsEveryParameterWithUnitRangeDefaultAndSentence) {
  const std::string table = reference_table<Cart>();
  for (const char* row : {"| `mass_kg` | kg | 0.01 to 1000 | required | Mass of the cart. |\n",
                          "| `seats` |  | whole, 1 to 8 | 2 | Seats. |\n",
                          "| `colour` |  | red, green, blue | green | Paint. |\n",
                          "| `owner` |  | name of at most 8 | nobody | Whose it is. |\n",
                          "| `lamp` |  | group | its defaults | Its lamp. |\n",
                          "| `lanterns` |  | map of groups | absent | What hangs on it. |\n",
                          "| `lanterns.<name>.power_W` | W | 1 to 100 | 5 | Power of the lamp. |\n",
                          "| `trailer` |  | group | absent | What it pulls. |\n",
                          "| `trailer.axles` |  | whole, 1 to 3 | required | Number of axles. |\n",
                          "| `wheels.<name>.pressure_Pa` | Pa | 1e+05 to 1e+06 | 2e+05 | Pressure of the tyre. |\n"}) {
    EXPECT_NE(table.find(row), std::string::npos) << row << table;
  }
}

TEST(ConfigSuggest, TellsTheUnitFromTheStem) {
  EXPECT_EQ(unit_of("supply_pressure_Pa"), "Pa");
  EXPECT_EQ(unit_of("piston_damping_Ns_m"), "Ns_m");
  EXPECT_EQ(unit_of("gain_m3_s_AsqrtPa"), "m3_s_AsqrtPa");
  EXPECT_EQ(unit_of("duty"), "");
  EXPECT_EQ(unit_of("m"), "");
}

TEST(ConfigSuggest, StaysSilentWhenNothingIsNear) {
  EXPECT_EQ(suggest("quux", {"mass_kg", "drag_Ns_m"}).name, "");
  EXPECT_EQ(suggest(std::string(10000, 'x'), {"mass_kg"}).name, "");
}

}  // namespace output_test
}  // namespace farrier::config::sample
