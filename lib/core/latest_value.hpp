#pragma once

#include <array>
#include <atomic>
#include <cstdint>
#include <type_traits>

namespace farrier {

/// Latest-value cell between one writer thread and one reader thread: wait-free on both sides, never tears,
/// keeps only the newest value (a triple buffer; Simpson 1990 gives the four-slot relative of it).
template <class T>
class LatestValue {
  static_assert(std::is_trivially_copyable_v<T>);

 public:
  /// Writer side. Replaces whatever the reader has not fetched yet.
  void store(const T& value) noexcept {
    slots_[back_] = value;
    back_ = shared_.exchange(back_ | kFresh, std::memory_order_acq_rel) & kIndex;
  }

  /// Reader side. True when a value newer than the last one fetched was copied to `out`.
  bool fetch(T& out) noexcept {
    if ((shared_.load(std::memory_order_relaxed) & kFresh) == 0) {
      return false;
    }
    front_ = shared_.exchange(front_, std::memory_order_acq_rel) & kIndex;
    out = slots_[front_];
    return true;
  }

 private:
  static constexpr std::uint32_t kFresh = 4;
  static constexpr std::uint32_t kIndex = 3;

  std::array<T, 3> slots_{};
  alignas(64) std::uint32_t back_ = 0;
  alignas(64) std::uint32_t front_ = 1;
  alignas(64) std::atomic<std::uint32_t> shared_{2};
};

}  // namespace farrier
