#include <gtest/gtest.h>

#include <array>
#include <atomic>
#include <chrono>
#include <thread>

#include "core/latest_value.hpp"
#include "core/spsc_ring.hpp"
#include "tests/support/allocation_guard.hpp"

namespace farrier {
namespace threads_test {

/// Larger than a cache line, so that a torn copy would show.
struct Block {
  std::array<std::uint64_t, 32> words{};

  static Block of(std::uint64_t number) {
    Block block;
    block.words.fill(number);
    return block;
  }
  bool whole() const {
    for (const std::uint64_t word : words) {
      if (word != words[0]) {
        return false;
      }
    }
    return true;
  }
};

// Long enough for two threads to meet often, also on a busy machine with one core.
constexpr auto kTogether = std::chrono::milliseconds(60);

std::chrono::steady_clock::time_point until_parting() { return std::chrono::steady_clock::now() + kTogether; }

TEST(LatestValue, HasNothingBeforeTheFirstStore) {
  LatestValue<int> cell;
  int out = 17;
  EXPECT_FALSE(cell.fetch(out));
  EXPECT_EQ(out, 17);
}

TEST(LatestValue, GivesAValueOnce) {
  LatestValue<int> cell;
  int out = 0;
  cell.store(5);
  EXPECT_TRUE(cell.fetch(out));
  EXPECT_EQ(out, 5);
  EXPECT_FALSE(cell.fetch(out));
}

TEST(LatestValue, KeepsOnlyTheNewest) {
  LatestValue<int> cell;
  for (int value = 1; value <= 10; ++value) {
    cell.store(value);
  }
  int out = 0;
  EXPECT_TRUE(cell.fetch(out));
  EXPECT_EQ(out, 10);
  EXPECT_FALSE(cell.fetch(out));
}

TEST(LatestValue, NeverTearsNorGoesBackBetweenTwoThreads) {
  LatestValue<Block> cell;
  std::atomic<bool> stop{false};
  std::uint64_t written = 0;
  std::thread writer([&] {
    while (!stop) {
      cell.store(Block::of(++written));
    }
  });
  Block block;
  std::uint64_t last = 0, fetched = 0, torn = 0, backwards = 0;
  const auto look = [&] {
    if (cell.fetch(block)) {
      ++fetched;
      torn += block.whole() ? 0 : 1;
      backwards += block.words[0] > last ? 0 : 1;
      last = block.words[0];
    }
  };
  for (const auto end = until_parting(); std::chrono::steady_clock::now() < end;) {
    look();
  }
  stop = true;
  writer.join();
  look();
  EXPECT_EQ(torn, 0u);
  EXPECT_EQ(backwards, 0u);
  EXPECT_EQ(last, written) << "the newest must win";
  EXPECT_GT(fetched, 1u);
}

TEST(SpscRing, GivesBackInOrder) {
  SpscRing<int, 4> ring;
  EXPECT_TRUE(ring.push(1));
  EXPECT_TRUE(ring.push(2));
  int out = 0;
  EXPECT_TRUE(ring.pop(out));
  EXPECT_EQ(out, 1);
  EXPECT_TRUE(ring.pop(out));
  EXPECT_EQ(out, 2);
  EXPECT_FALSE(ring.pop(out));
}

TEST(SpscRing, DropsTheNewestWhenFullAndCountsIt) {
  SpscRing<int, 4> ring;
  for (int value = 0; value < 7; ++value) {
    EXPECT_EQ(ring.push(value), value < 4);
  }
  EXPECT_EQ(ring.dropped(), 3u);
  int out = 0;
  for (int value = 0; value < 4; ++value) {
    ASSERT_TRUE(ring.pop(out));
    EXPECT_EQ(out, value);
  }
  EXPECT_TRUE(ring.push(7)) << "room again";
}

TEST(SpscRing, LosesNothingItDidNotCountBetweenTwoThreads) {
  SpscRing<Block, 16> ring;
  std::atomic<bool> stop{false};
  std::uint64_t offered = 0, accepted = 0;
  std::thread producer([&] {
    while (!stop) {
      accepted += ring.push(Block::of(++offered)) ? 1 : 0;
    }
  });
  Block block;
  std::uint64_t popped = 0, last = 0, torn = 0, disordered = 0;
  const auto take = [&] {
    if (!ring.pop(block)) {
      return false;
    }
    ++popped;
    torn += block.whole() ? 0 : 1;
    disordered += block.words[0] > last ? 0 : 1;
    last = block.words[0];
    return true;
  };
  for (const auto end = until_parting(); std::chrono::steady_clock::now() < end;) {
    take();
  }
  stop = true;
  producer.join();
  while (take()) {
  }
  EXPECT_EQ(torn, 0u);
  EXPECT_EQ(disordered, 0u);
  EXPECT_EQ(popped, accepted);
  EXPECT_EQ(popped + ring.dropped(), offered);
  EXPECT_GT(popped, 16u);
}

TEST(Channels, DoNotAllocate) {
  LatestValue<Block> cell;
  SpscRing<Block, 16> ring;
  Block block;
  const test::AllocationGuard guard;
  for (std::uint64_t number = 0; number < 100; ++number) {
    cell.store(Block::of(number));
    cell.fetch(block);
    ring.push(block);
    ring.pop(block);
  }
  EXPECT_EQ(guard.allocations(), 0u);
}

}  // namespace threads_test
}  // namespace farrier
