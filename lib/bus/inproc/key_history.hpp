#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <utility>
#include <vector>

namespace farrier::bus {

/// KEEP_LAST history: the newest `depth` samples of every key, with one order over all keys. Allocates with the first
/// sample of a key and never again for it.
class KeyHistory {
 public:
  KeyHistory(std::size_t sample_size, int depth)
      : sample_size_(sample_size), depth_(static_cast<std::size_t>(depth)), links_(1), samples_(sample_size) {}

  /// Number of a key, counted from 0 in order of first appearance.
  std::size_t index_of(std::uint32_t key) {
    const auto place = std::lower_bound(keys_.begin(), keys_.end(), std::pair(key, std::size_t{0}));
    if (place != keys_.end() && place->first == key) {
      return place->second;
    }
    const std::size_t index = rings_.size();
    keys_.insert(place, {key, index});
    rings_.emplace_back();
    links_.resize(links_.size() + depth_);
    samples_.resize(samples_.size() + depth_ * sample_size_);
    return index;
  }

  /// Adds a sample of the key with this number. True when it replaced the key's oldest.
  bool push(std::size_t index, const void* sample) noexcept {
    Ring& ring = rings_[index];
    const bool full = ring.count == depth_;
    if (full) {
      unlink(slot(index, ring.first));
      drop_oldest(ring);
    }
    const std::size_t added = slot(index, (ring.first + ring.count) % depth_);
    ++ring.count;
    std::memcpy(at(added), sample, sample_size_);
    link_last(added);
    return full;
  }

  /// Moves at most `capacity` samples, oldest first, into an array of samples; returns how many.
  std::size_t pop(void* samples, std::size_t capacity) noexcept {
    auto* out = static_cast<std::byte*>(samples);
    std::size_t count = 0;
    for (; count < capacity && links_[kEnd].next != kEnd; ++count) {
      const std::size_t oldest = links_[kEnd].next;
      std::memcpy(out + count * sample_size_, at(oldest), sample_size_);
      unlink(oldest);
      drop_oldest(rings_[(oldest - 1) / depth_]);
    }
    return count;
  }

  /// Calls visit(sample) for every sample, oldest first.
  template <class Visit>
  void for_each(Visit&& visit) const {
    for (std::size_t i = links_[kEnd].next; i != kEnd; i = links_[i].next) {
      visit(static_cast<const void*>(&samples_[i * sample_size_]));
    }
  }

 private:
  struct Link {
    std::size_t previous = 0;
    std::size_t next = 0;
  };
  struct Ring {
    std::size_t first = 0;
    std::size_t count = 0;
  };
  // Slot 0 holds no sample: it closes the list of all samples, oldest first.
  static constexpr std::size_t kEnd = 0;

  std::size_t slot(std::size_t index, std::size_t position) const noexcept { return 1 + index * depth_ + position; }
  std::byte* at(std::size_t slot) noexcept { return &samples_[slot * sample_size_]; }

  // The oldest of all samples is the oldest of its key, too: a ring loses samples only at its front.
  void drop_oldest(Ring& ring) noexcept {
    ring.first = (ring.first + 1) % depth_;
    --ring.count;
  }
  void unlink(std::size_t slot) noexcept {
    links_[links_[slot].previous].next = links_[slot].next;
    links_[links_[slot].next].previous = links_[slot].previous;
  }
  void link_last(std::size_t slot) noexcept {
    links_[slot] = {links_[kEnd].previous, kEnd};
    links_[links_[kEnd].previous].next = slot;
    links_[kEnd].previous = slot;
  }

  std::size_t sample_size_;
  std::size_t depth_;
  std::vector<std::pair<std::uint32_t, std::size_t>> keys_;  // sorted by key
  std::vector<Ring> rings_;
  std::vector<Link> links_;
  std::vector<std::byte> samples_;
};

}  // namespace farrier::bus
