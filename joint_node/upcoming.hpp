#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <optional>
#include <type_traits>
#include <utility>

#include "core/time.hpp"

namespace farrier::joint_node {

/// Announced items that are not due yet. Each has a number that rises by one with every issue (0 is never issued) and
/// the tick from which it holds. The newest item that is due holds, in any order of arrival; an early item never
/// replaces one that is due before it.
template <class Item, auto kNumber, Tick Item::*kTick>
class Upcoming {
 public:
  using Number = std::remove_cvref_t<decltype(std::declval<Item>().*kNumber)>;

  /// Puts an item to wait. If more wait than there are places, the oldest number is dropped.
  void put(const Item& item) noexcept {
    Item& oldest = *std::min_element(waiting_.begin(), waiting_.end(), older);
    if (item.*kNumber > std::max(taken_, oldest.*kNumber)) {
      oldest = item;
    }
  }

  /// The newest item that is due at `tick` and newer than any taken before; forgets those it supersedes.
  std::optional<Item> take_due(Tick tick) noexcept {
    std::optional<Item> due;
    for (Item& item : waiting_) {
      if (item.*kNumber > taken_ && item.*kTick <= tick) {
        taken_ = item.*kNumber;
        due = item;
      }
    }
    for (Item& item : waiting_) {
      if (item.*kNumber <= taken_) {
        item.*kNumber = 0;
      }
    }
    return due;
  }

  /// Largest number seen, taken or waiting; 0 without any.
  Number newest() const noexcept {
    return std::max(taken_, std::max_element(waiting_.begin(), waiting_.end(), older)->*kNumber);
  }

 private:
  static bool older(const Item& one, const Item& other) noexcept { return one.*kNumber < other.*kNumber; }

  std::array<Item, 4> waiting_{};
  Number taken_ = 0;
};

}  // namespace farrier::joint_node
