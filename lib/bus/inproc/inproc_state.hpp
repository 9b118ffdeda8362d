#pragma once

// Matching, ownership, liveliness and deadlines of the in-process domain. Everything here runs under its mutex.

#include <algorithm>
#include <cstdint>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <vector>

#include "bus/bus.hpp"
#include "bus/inproc/key_history.hpp"

namespace farrier::bus {

struct ReaderState;

struct WriterState {
  EndpointSpec endpoint;
  std::uint32_t (*key_of)(const void* signal);
  std::uint64_t number = 0;          ///< order of creation; the elder of two equally strong writers owns
  SteadyTime asserted{};             ///< creation or last write
  bool alive = true;
  std::optional<KeyHistory> history{};  ///< TRANSIENT_LOCAL: what late readers get
  std::vector<ReaderState*> readers{};  ///< matched
};

/// A reader's state of one key.
struct KeyState {
  const WriterState* owner = nullptr;     ///< EXCLUSIVE: whose samples count
  const WriterState* last_writer = nullptr;
  std::optional<SteadyTime> due_from;     ///< the next sample is due one deadline after this
};

struct ReaderState {
  EndpointSpec endpoint;
  std::shared_ptr<Notifier> notifier;  ///< null: no thread waits for samples
  KeyHistory history;
  std::vector<KeyState> keys{};         ///< by the history's number of the key
  std::vector<WriterState*> writers{};  ///< matched
  ReaderStatus status{};
};

/// True when the offer of a writer satisfies the request of a reader (DDS 1.4, 2.2.3, table of requested/offered).
inline bool compatible(const Qos& offered, const Qos& requested) noexcept {
  return offered.reliability >= requested.reliability && offered.durability >= requested.durability &&
         offered.deadline <= requested.deadline && offered.liveliness >= requested.liveliness &&
         offered.lease <= requested.lease && offered.ownership == requested.ownership;
}

/// True when the two lists share a name; no partition at all is the one with the empty name.
inline bool share_partition(const std::vector<std::string>& a, const std::vector<std::string>& b) {
  if (a.empty() || b.empty()) {
    const auto& other = a.empty() ? b : a;
    return other.empty() || std::find(other.begin(), other.end(), "") != other.end();
  }
  return std::find_first_of(a.begin(), a.end(), b.begin(), b.end()) != a.end();
}

template <class T>
void erase_one(std::vector<T*>& list, const T* item) {
  list.erase(std::find(list.begin(), list.end(), item));
}

/// EXCLUSIVE ownership: true when `writer` outranks the owner of a key.
inline bool outranks(const WriterState& writer, const WriterState& owner) noexcept {
  const int own = writer.endpoint.ownership_strength;
  const int other = owner.endpoint.ownership_strength;
  return own != other ? own > other : writer.number < owner.number;
}

struct InprocState {
  std::function<SteadyTime()> clock;
  mutable std::mutex mutex;
  std::uint64_t writers_created = 0;
  std::uint64_t overwritten = 0;
  std::vector<WriterState*> writers;
  std::vector<ReaderState*> readers;

  void add(WriterState& writer);
  void add(ReaderState& reader);
  void remove(WriterState& writer);
  void remove(ReaderState& reader);

  void assert_liveliness(WriterState& writer);
  void write(WriterState& writer, const void* signal);
  /// Brings a reader's liveliness and deadline counters up to `now`.
  void refresh(ReaderState& reader, SteadyTime now);

 private:
  void match(WriterState& writer, ReaderState& reader);
  void deliver(const WriterState& writer, ReaderState& reader, const void* signal, SteadyTime now);
  void judge_liveliness(WriterState& writer, SteadyTime now);
  static void judge_deadline(ReaderState& reader, KeyState& key, SteadyTime now);
  static void release(ReaderState& reader, const WriterState& writer);
};

inline void InprocState::add(WriterState& writer) {
  writer.number = writers_created++;
  writer.asserted = clock();
  writers.push_back(&writer);
  for (ReaderState* reader : readers) {
    match(writer, *reader);
  }
}

inline void InprocState::add(ReaderState& reader) {
  readers.push_back(&reader);
  for (WriterState* writer : writers) {
    match(*writer, reader);
  }
  if (reader.endpoint.qos.durability != Durability::kTransientLocal) {
    return;
  }
  // Strongest first, so that of an EXCLUSIVE key only its owner's samples arrive.
  std::vector<WriterState*> sources = reader.writers;
  std::sort(sources.begin(), sources.end(),
            [](const WriterState* a, const WriterState* b) { return outranks(*a, *b); });
  const SteadyTime now = clock();
  for (WriterState* writer : sources) {
    judge_liveliness(*writer, now);
    writer->history->for_each([&](const void* signal) { deliver(*writer, reader, signal, now); });
  }
}

inline void InprocState::remove(WriterState& writer) {
  erase_one(writers, &writer);
  for (ReaderState* reader : writer.readers) {
    refresh(*reader, clock());
    erase_one(reader->writers, &writer);
    release(*reader, writer);
    for (KeyState& key : reader->keys) {
      if (key.last_writer == &writer) {
        key.last_writer = nullptr;
        key.due_from.reset();  // no writer is left that could be late
      }
    }
  }
}

inline void InprocState::remove(ReaderState& reader) {
  erase_one(readers, &reader);
  for (WriterState* writer : reader.writers) {
    erase_one(writer->readers, &reader);
  }
}

inline void InprocState::match(WriterState& writer, ReaderState& reader) {
  if (writer.endpoint.topic != reader.endpoint.topic ||
      !share_partition(writer.endpoint.partitions, reader.endpoint.partitions)) {
    return;
  }
  if (!compatible(writer.endpoint.qos, reader.endpoint.qos)) {
    ++reader.status.incompatible_qos;
    return;
  }
  writer.readers.push_back(&reader);
  reader.writers.push_back(&writer);
}

inline void InprocState::assert_liveliness(WriterState& writer) {
  const SteadyTime now = clock();
  judge_liveliness(writer, now);  // a lease that ran out before now is counted, however late
  writer.asserted = now;
  writer.alive = true;
}

inline void InprocState::write(WriterState& writer, const void* signal) {
  assert_liveliness(writer);
  if (writer.history) {
    writer.history->push(writer.history->index_of(writer.key_of(signal)), signal);
  }
  for (ReaderState* reader : writer.readers) {
    deliver(writer, *reader, signal, writer.asserted);
  }
}

inline void InprocState::deliver(const WriterState& writer, ReaderState& reader, const void* signal, SteadyTime now) {
  const std::size_t index = reader.history.index_of(writer.key_of(signal));
  if (index == reader.keys.size()) {
    reader.keys.emplace_back();
  }
  KeyState& key = reader.keys[index];
  judge_deadline(reader, key, now);
  if (reader.endpoint.qos.ownership == Ownership::kExclusive) {
    for (WriterState* other : reader.writers) {
      judge_liveliness(*other, now);
    }
    if (key.owner != nullptr && key.owner != &writer && !outranks(writer, *key.owner)) {
      return;
    }
    key.owner = &writer;
  }
  key.last_writer = &writer;
  if (reader.endpoint.qos.deadline != kInfinite) {
    key.due_from = now;
  }
  overwritten += reader.history.push(index, signal) ? 1 : 0;
  if (reader.notifier) {
    reader.notifier->arrived();
  }
}

inline void InprocState::refresh(ReaderState& reader, SteadyTime now) {
  for (WriterState* writer : reader.writers) {
    judge_liveliness(*writer, now);
  }
  for (KeyState& key : reader.keys) {
    judge_deadline(reader, key, now);
  }
}

inline void InprocState::judge_liveliness(WriterState& writer, SteadyTime now) {
  // AUTOMATIC is asserted by the process being there, and in here it is.
  const Qos& qos = writer.endpoint.qos;
  if (!writer.alive || qos.liveliness == Liveliness::kAutomatic || now - writer.asserted <= qos.lease) {
    return;
  }
  writer.alive = false;
  for (ReaderState* reader : writer.readers) {
    ++reader->status.liveliness_lost;
    release(*reader, writer);
  }
}

inline void InprocState::judge_deadline(ReaderState& reader, KeyState& key, SteadyTime now) {
  const Nanoseconds deadline = reader.endpoint.qos.deadline;
  if (!key.due_from || now - *key.due_from <= deadline) {
    return;
  }
  const auto missed = (now - *key.due_from) / deadline;
  reader.status.deadline_missed += static_cast<std::uint64_t>(missed);
  *key.due_from += missed * deadline;
  key.owner = nullptr;
}

inline void InprocState::release(ReaderState& reader, const WriterState& writer) {
  for (KeyState& key : reader.keys) {
    if (key.owner == &writer) {
      key.owner = nullptr;
    }
  }
}

}  // namespace farrier::bus
