// Text that must be of a kind, and lists of names that may be left out.

#include <gtest/gtest.h>

#include "config/printer.hpp"
#include "config/reader.hpp"
#include "config/reference_table.hpp"

namespace farrier::config {
namespace text_test {

struct Door {
  std::string hinge;
  std::vector<std::string> keys;
};

bool is_left_or_right(const std::string& text) { return text == "l.h." || text == "r.h."; }
constexpr TextRule kHinge{"side", is_left_or_right, "give l.h. or r.h."};

void declare(Visitor& v, Door& door) {
  v.text("hinge", door.hinge, kHinge, "Where it hangs.");
  v.names("keys", door.keys, Defaults{}, "What opens it.");
}

std::string mistakes(const std::string& text) {
  const auto door = read_text<Door>(text, "door.yaml");
  return door ? "" : to_string(door.error());
}

TEST(TextOfAKind, IsTakenWhenTheRuleTakesIt) {
  const auto door = read_text<Door>("hinge: l.h.\n", "door.yaml");
  ASSERT_TRUE(door.ok());
  EXPECT_EQ(door.value().hinge, "l.h.");
}

TEST(TextOfAKind, IsRefusedWithTheRulesRemedy) {
  EXPECT_EQ(mistakes("hinge: up\n"), "door.yaml:1: hinge: up is no side: give l.h. or r.h.\n");
  EXPECT_EQ(mistakes("hinge: [l.h.]\n"), "door.yaml:1: hinge: a list is no side: give l.h. or r.h.\n");
}

TEST(TextOfAKind, IsRequired) {
  EXPECT_EQ(mistakes("keys: [a]\n"), "door.yaml:1: hinge: is missing: give l.h. or r.h. (Where it hangs.)\n");
}

TEST(NamesThatMayBeLeftOut, AreEmptyThenAndNotPrinted) {
  const auto door = read_text<Door>("hinge: l.h.\n", "door.yaml");
  ASSERT_TRUE(door.ok());
  EXPECT_TRUE(door.value().keys.empty());
  EXPECT_EQ(print_yaml(door.value()), "hinge: \"l.h.\"\n");
}

TEST(NamesThatMayBeLeftOut, AreReadAndPrintedWhereGiven) {
  const auto door = read_text<Door>("hinge: r.h.\nkeys: [ann, bob]\n", "door.yaml");
  ASSERT_TRUE(door.ok());
  EXPECT_EQ(print_yaml(door.value()), "hinge: \"r.h.\"\nkeys: [\"ann\", \"bob\"]\n");
}

TEST(NamesThatMayBeLeftOut, AreNotGivenAsAnEmptyList) {
  EXPECT_EQ(mistakes("hinge: l.h.\nkeys: []\n"), "door.yaml:2: keys: is empty: give at least one name\n");
}

TEST(TheTableOfParameters, SaysOfWhatKindATextIs) {
  const std::string table = reference_table<Door>();
  EXPECT_NE(table.find("| `hinge` |  | side | required | Where it hangs. |"), std::string::npos) << table;
  EXPECT_NE(table.find("| `keys` |  | list of names | empty | What opens it. |"), std::string::npos) << table;
}

}  // namespace text_test
}  // namespace farrier::config
