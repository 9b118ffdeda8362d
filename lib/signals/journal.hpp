#pragma once

// Content of a SystemJournal's bytes: consecutive samples of one stream, each as nanoseconds since the first was
// published and its CDR.

#include <algorithm>
#include <cstring>

#include "signals/cdr.hpp"
#include "signals/sequence_of.hpp"

namespace farrier::signals {

/// True for signals that are gathered in journals: those of every tick, estimates, and the copies for slow networks.
template <class Signal>
inline constexpr bool kJournalled =
    kOfEveryTick<Signal> || std::is_same_v<Signal, JointModelEstimate> ||
    std::is_same_v<Signal, JointModelEstimateCopy> || std::is_same_v<Signal, JointSummary>;

/// Number of a stream: of one participant's samples of one topic.
constexpr std::uint16_t stream_of(std::uint16_t participant, std::uint8_t topic) noexcept {
  return static_cast<std::uint16_t>(participant * kMaxTopics + topic);
}
/// Number of a stream's topic.
constexpr std::uint8_t topic_of_stream(std::uint16_t stream) noexcept {
  return static_cast<std::uint8_t>(stream % kMaxTopics);
}

/// Bytes of one sample in a journal.
template <class Signal>
std::size_t journal_entry_size() {
  static const std::size_t size = sizeof(std::uint32_t) + cdr_size<Signal>();
  return size;
}

/// True if another sample has room in a journal of at most `most` bytes.
template <class Signal>
bool has_room(const SystemJournal& journal, std::size_t most = decltype(SystemJournal::bytes)::capacity()) {
  return journal.bytes.size() + journal_entry_size<Signal>() <= most;
}

/// Adds a sample, which must have room, that was published so long after the first.
template <class Signal>
void append(SystemJournal& journal, const Signal& signal, std::uint32_t after_first_ns) {
  const std::size_t size = journal_entry_size<Signal>();
  const std::size_t before = journal.bytes.size();
  journal.bytes.resize(before + size);
  std::uint8_t* const entry = journal.bytes.data() + before;
  std::fill_n(entry, size, std::uint8_t{0});
  std::memcpy(entry, &after_first_ns, sizeof after_first_ns);
  write_cdr(signal, entry + sizeof after_first_ns);
  ++journal.samples;
}

/// Leaves no sample in it.
inline void clear(SystemJournal& journal) noexcept {
  journal.samples = 0;
  journal.bytes.resize(0);
}

/// Calls use(signal, cdr, age_ns) for every sample, oldest first; age_ns: from its publication to the journal's. At
/// bytes that are no such samples it stops and returns false.
template <class Signal, class Use>
bool visit_journal(const SystemJournal& journal, Use&& use) {
  const std::size_t size = journal_entry_size<Signal>();
  if (journal.samples * size > journal.bytes.size()) {
    return false;
  }
  for (std::size_t i = 0; i < journal.samples; ++i) {
    const auto entry = std::span(journal.bytes.data() + i * size, size);
    std::uint32_t after_first_ns = 0;
    std::memcpy(&after_first_ns, entry.data(), sizeof after_first_ns);
    const std::span<const std::uint8_t> cdr = entry.subspan(sizeof after_first_ns);
    Signal signal;
    if (!from_cdr(cdr, signal)) {
      return false;
    }
    use(signal, cdr, journal.closed_after_ns - std::min(after_first_ns, journal.closed_after_ns));
  }
  return true;
}

}  // namespace farrier::signals
