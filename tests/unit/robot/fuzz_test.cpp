#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <sstream>

#include "test_files.hpp"

namespace farrier::robot {
namespace fuzz_test {

constexpr std::uint32_t kSeed = 20140701;

std::vector<std::string> lines_of(const std::string& text) {
  std::vector<std::string> lines;
  std::istringstream stream(text);
  for (std::string line; std::getline(stream, line);) {
    lines.push_back(line);
  }
  return lines;
}

std::string joined(const std::vector<std::string>& lines) {
  std::string text;
  for (const std::string& line : lines) {
    text += line + "\n";
  }
  return text;
}

class RobotFileFuzz : public testing::TestWithParam<const char*> {
 protected:
  std::size_t below(std::size_t bound) { return bound == 0 ? 0 : random_() % bound; }

  // A robot that loads must be one: its printed form loads again to the same.
  void expect_sound(const std::string& text) {
    const auto robot = load_robot_text(text, "fuzz.yaml");
    if (!robot) {
      EXPECT_FALSE(robot.error().empty()) << "refused without a reason, seed " << kSeed << "\n" << text;
      return;
    }
    ++loaded_;
    const std::string printed = print_config(robot.value());
    const auto again = load_robot_text(printed, "printed.yaml");
    ASSERT_TRUE(again.ok()) << to_string(again.error()) << "seed " << kSeed << "\n" << text;
    EXPECT_EQ(print_config(again.value()), printed);
  }

  std::mt19937 random_{kSeed};
  int loaded_ = 0;
};

TEST_P(RobotFileFuzz, SurvivesRandomBytes) {
  const std::string good = text_of(GetParam());
  const std::string alphabet = "0123456789.-+eE:,[]{}&*<>!|'\"%@`#?\\ \n\tanifxyz_\x80\xff\x01";
  for (int i = 0; i < 300; ++i) {
    std::string text = good;
    for (std::size_t k = 0; k <= below(4); ++k) {
      const std::size_t at = below(text.size());
      switch (below(3)) {
        case 0: text[at] = alphabet[below(alphabet.size())]; break;
        case 1: text.insert(at, 1, alphabet[below(alphabet.size())]); break;
        default: text.erase(at, 1 + below(5)); break;
      }
    }
    expect_sound(text);
  }
}

TEST_P(RobotFileFuzz, SurvivesLinesMovedRepeatedAndCut) {
  const std::vector<std::string> good = lines_of(text_of(GetParam()));
  for (int i = 0; i < 300; ++i) {
    std::vector<std::string> lines = good;
    const auto at = lines.begin() + static_cast<long>(below(lines.size()));
    switch (below(4)) {
      case 0: lines.erase(at); break;
      case 1: lines.insert(at, lines[below(lines.size())]); break;
      case 2: std::iter_swap(at, lines.begin() + static_cast<long>(below(lines.size()))); break;
      default: lines.erase(at, lines.end()); break;
    }
    expect_sound(joined(lines));
  }
}

TEST_P(RobotFileFuzz, SurvivesRandomValues) {
  const std::vector<std::string> good = lines_of(print_config(load_shipped(GetParam())));
  const std::vector<std::string> values = {"0",   "-1", "1e308", "-1e-308", ".nan", "1e9", "0.5",
                                           "[1]", "{}", "~",     "haa",     "0.02", "2",   "1e-9",
                                           "*a",  "[]", "&a 1",  "trot",    "true", "\"\""};
  for (int i = 0; i < 600; ++i) {
    std::vector<std::string> lines = good;
    std::string& line = lines[below(lines.size())];
    line = line.substr(0, line.find(':') + 1) + " " + values[below(values.size())];
    expect_sound(joined(lines));
  }
  EXPECT_GT(loaded_, 0) << "no mutation was harmless: the test does not reach the loader's far side";
}

TEST_P(RobotFileFuzz, NeverLoadsAKeyItDoesNotKnow) {
  const std::vector<std::string> good = lines_of(print_config(load_shipped(GetParam())));
  int tried = 0;
  for (std::size_t at = 0; at < good.size(); ++at) {
    const auto first = good[at].find_first_not_of(' ');
    if (good[at][first] == '"') {
      continue;  // a name the author chose, free to be any
    }
    std::vector<std::string> lines = good;
    lines.insert(lines.begin() + static_cast<long>(at), std::string(first, ' ') + "zzz_unheard_of: 1");
    const auto robot = load_robot_text(joined(lines), "fuzz.yaml");
    ASSERT_FALSE(robot.ok()) << joined(lines);
    const config::Problems& problems = robot.error();
    EXPECT_TRUE(std::any_of(problems.begin(), problems.end(), [&](const config::Problem& problem) {
      return problem.line == static_cast<int>(at) + 1 && problem.where.find("zzz_unheard_of") != std::string::npos;
    })) << to_string(problems);
    ++tried;
  }
  EXPECT_GT(tried, 50);
}

INSTANTIATE_TEST_SUITE_P(Shipped, RobotFileFuzz, testing::Values("hyq", "fc1d", "fc1d_real"));

}  // namespace fuzz_test
}  // namespace farrier::robot
