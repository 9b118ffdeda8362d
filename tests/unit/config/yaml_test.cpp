#include <gtest/gtest.h>

#include <cstdio>
#include <fstream>

#include "sample.hpp"

namespace farrier::config::sample {
namespace yaml_test {

std::string refusal(const std::string& text) {
  const auto parsed = parse_yaml(text, "f.yaml");
  return parsed ? "accepted" : to_string(parsed.error());
}

TEST(ConfigYaml, SaysThatAFileCannotBeRead) {
  const auto cart = read_file<Cart>("no/such/file.yaml");
  ASSERT_FALSE(cart.ok());
  EXPECT_EQ(to_string(cart.error()), "no/such/file.yaml: cannot be read: check the path and its permissions\n");
  EXPECT_FALSE(read_file<Cart>(".").ok());  // a directory
}

TEST(ConfigYaml, ReadsAFile) {
  const std::string path = testing::TempDir() + "config_yaml_test.yaml";
  std::ofstream(path) << kGood;
  EXPECT_TRUE(read_file<Cart>(path).ok());
  std::ofstream(path, std::ios::trunc) << "";
  EXPECT_EQ(to_string(read_file<Cart>(path).error()), path + ": is empty\n");
  std::remove(path.c_str());
}

TEST(ConfigYaml, NamesTheLineOfASyntaxError) {
  EXPECT_EQ(refusal("a: 1\nb: [1, 2\nc: 3\n").substr(0, 26), "f.yaml:3: is not valid YAM");
  EXPECT_EQ(refusal("a: *nowhere\n").substr(0, 26), "f.yaml:1: is not valid YAM");
}

TEST(ConfigYaml, TakesExactlyOneDocument) {
  EXPECT_EQ(refusal(""), "f.yaml: is empty");
  EXPECT_EQ(refusal("# nothing\n"), "f.yaml: is empty");
  EXPECT_EQ(refusal("%YAML 1.2\n---\na: 1\n").find("second"), std::string::npos) << "a directive is no document";
  EXPECT_EQ(refusal("a: 1\n---\nb: 2\n"), "f.yaml:2: starts a second document: give one");
  EXPECT_EQ(refusal("a: 1\n...\n# said\nb: 2\n"), "f.yaml:4: starts a second document: give one");
}

TEST(ConfigYaml, RefusesADocumentThatIsNoMap) {
  const auto cart = read_text<Cart>("- 1\n- 2\n", "f.yaml");
  ASSERT_FALSE(cart.ok());
  EXPECT_EQ(to_string(cart.error().front()), "f.yaml:1: is a list: give a map of parameters");
}

TEST(ConfigYaml, RefusesKeysThatAreNotText) { EXPECT_EQ(refusal("? [1, 2]\n: 3\n").substr(0, 16), "f.yaml:1: has a "); }

TEST(ConfigYaml, BoundsDepthAndSize) {
  EXPECT_NE(refusal(std::string(40, '[') + std::string(40, ']')).find("nested deeper than 32"), std::string::npos);
  std::string laughs = "a0: &a0 [1, 1, 1, 1, 1, 1, 1, 1, 1, 1]\n";
  for (int i = 1; i < 9; ++i) {
    const std::string last = "*a" + std::to_string(i - 1);
    laughs += "a" + std::to_string(i) + ": &a" + std::to_string(i) + " [";
    for (int k = 0; k < 9; ++k) {
      laughs += last + " , ";
    }
    laughs += last + " ]\n";
  }
  EXPECT_NE(refusal(laughs).find("more than 100000 values"), std::string::npos);
  EXPECT_NE(refusal(std::string(5u << 20, ' ')).find("larger than 4 MB"), std::string::npos);
}

TEST(ConfigYaml, SurvivesAnAliasThatContainsItself) {
  EXPECT_NE(refusal("a: &a [1, *a]\n"), "accepted");
}

TEST(ConfigYaml, MergesAnchorsBelowWhatTheMapSaysItself) {
  const auto cart = read_text<Cart>(
      "name: cart\nmass_kg: 20\ndrivers: [ann]\nroles: {ann: front}\n"
      "wheels:\n"
      "  left: &wheel {radius_m: 0.3, pressure_Pa: 3e5}\n"
      "  right: {<<: *wheel, radius_m: 0.5}\n"
      "  third: {<<: [*wheel]}\n",
      "cart.yaml");
  ASSERT_TRUE(cart.ok()) << to_string(cart.error());
  EXPECT_EQ(cart.value().wheels[1].second.radius_m, 0.5);
  EXPECT_EQ(cart.value().wheels[1].second.pressure_Pa, 3e5);
  EXPECT_EQ(cart.value().wheels[2].second.radius_m, 0.3);
}

TEST(ConfigYaml, ReportsAMistakeInMergedKeysWhereItIsWritten) {
  const auto cart = read_text<Cart>(
      "name: cart\nmass_kg: 20\ndrivers: [ann]\nroles: {ann: front}\n"
      "wheels:\n"
      "  left: &wheel\n"
      "    radius_m: 3\n"
      "  right: {<<: *wheel, radius_m: 0.5}\n",
      "cart.yaml");
  ASSERT_FALSE(cart.ok());
  EXPECT_EQ(to_string(cart.error()), "cart.yaml:7: wheels.left.radius_m: 3 is out of range: give 0.1 to 1\n");
  EXPECT_NE(refusal("a: {<<: 3}\n").find("merges (<<) something that is not a map"), std::string::npos);
}

}  // namespace yaml_test
}  // namespace farrier::config::sample
