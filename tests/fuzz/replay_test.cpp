// Runs every harness on the inputs that are kept for it and on a fixed number of their mutations. Errors that fuzzing
// has found stay fixed, and a build without clang still tries every decoder.

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <random>
#include <vector>

#include "tests/fuzz/harness.hpp"

namespace farrier::fuzz {

void PrintTo(const Harness& harness, std::ostream* out) { *out << harness.name; }

namespace replay_test {

constexpr std::uint32_t kSeed = 20140701;
constexpr int kMutationsOfEach = 20;
constexpr int kMostMutations = 2000;

struct Kept {
  std::string name;
  std::vector<std::uint8_t> bytes;
};

std::vector<Kept> kept_for(const Harness& harness) {
  std::vector<Kept> all;
  const std::filesystem::path folder = std::filesystem::path(FARRIER_CORPUS) / harness.name;
  for (const auto& entry : std::filesystem::directory_iterator(folder)) {
    std::ifstream file(entry.path(), std::ios::binary);
    all.push_back({entry.path().filename().string(), {std::istreambuf_iterator<char>(file), {}}});
  }
  std::ranges::sort(all, {}, &Kept::name);  // directories have no order
  return all;
}

class Mutations {
 public:
  /// One to eight changes: a byte another one, gone, twice or moved, a stretch of another input, the end cut off.
  std::vector<std::uint8_t> of(std::vector<std::uint8_t> bytes, const std::vector<std::uint8_t>& other) {
    for (std::size_t change = 0; change <= below(8); ++change) {
      const auto at = bytes.begin() + static_cast<std::ptrdiff_t>(below(bytes.size()));
      switch (bytes.empty() ? 2 : below(7)) {
        case 0: *at = static_cast<std::uint8_t>(random_()); break;
        case 1: *at = static_cast<std::uint8_t>(*at ^ (1u << below(8))); break;
        case 2: bytes.insert(at, static_cast<std::uint8_t>(random_())); break;
        case 3: bytes.erase(at); break;
        case 4: std::iter_swap(at, bytes.begin() + static_cast<std::ptrdiff_t>(below(bytes.size()))); break;
        case 5: splice(bytes, at, other); break;
        default: bytes.erase(below(4) == 0 ? at : bytes.end() - 1, bytes.end()); break;
      }
    }
    return bytes;
  }
  std::size_t below(std::size_t bound) { return bound == 0 ? 0 : random_() % bound; }

 private:
  using Place = std::vector<std::uint8_t>::iterator;

  void splice(std::vector<std::uint8_t>& bytes, Place at, const std::vector<std::uint8_t>& other) {
    const std::size_t from = below(other.size());
    const std::size_t count = std::min(other.size() - from, below(64));
    const auto begin = other.begin() + static_cast<std::ptrdiff_t>(from);
    bytes.insert(at, begin, begin + static_cast<std::ptrdiff_t>(count));
  }

  std::mt19937 random_{kSeed};
};

class Replay : public testing::TestWithParam<Harness> {
 protected:
  void run(Bytes bytes, const std::string& what) {
    try {
      GetParam().run(bytes);
    } catch (const Broken& broken) {
      const std::string path = testing::TempDir() + std::string(GetParam().name) + "_finding";
      std::ofstream(path, std::ios::binary).write(text_of(bytes).data(), static_cast<std::streamsize>(bytes.size()));
      ADD_FAILURE() << what << ": broken promise: " << broken.what() << "\nthe input is kept as " << path;
    }
  }
};

TEST_P(Replay, KeptInputsAndMutationsOfThemBreakNothing) {
  const std::vector<Kept> kept = kept_for(GetParam());
  ASSERT_FALSE(kept.empty());
  for (const Kept& input : kept) {
    run(input.bytes, input.name);
  }
  Mutations mutations;
  const int tries = std::min(kMostMutations, kMutationsOfEach * static_cast<int>(kept.size()));
  for (int i = 0; i < tries && !HasFailure(); ++i) {
    const Kept& input = kept[mutations.below(kept.size())];
    const auto bytes = mutations.of(input.bytes, kept[mutations.below(kept.size())].bytes);
    run(bytes, "mutation " + std::to_string(i) + " of " + input.name);
  }
}

INSTANTIATE_TEST_SUITE_P(Fuzz, Replay, testing::ValuesIn(harnesses().begin(), harnesses().end()),
                         [](const auto& instance) { return std::string(instance.param.name); });

}  // namespace replay_test
}  // namespace farrier::fuzz
