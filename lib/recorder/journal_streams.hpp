#pragma once

#include <array>
#include <memory>
#include <vector>

#include "recorder/recorder.hpp"
#include "recorder/stream.hpp"

namespace farrier::recorder {

/// True if processes keep journals of a topic: signals::kJournalled of its signal.
bool is_journalled(bus::TopicId topic);

/// Samples of one topic out of journals.
class JournalledTopic {
 public:
  virtual ~JournalledTopic() = default;
  virtual void take(const signals::SystemJournal& journal, const Now& now, const recording::TakeSample& take) = 0;
  virtual TopicProgress progress(const bus::ReaderStatus& reader) const = 0;
};

/// Samples of every topic out of journals.
class JournalStreams {
 public:
  JournalStreams();

  /// Hands the samples of a journal on. Passes over a probe and over a journal of another contract.
  void take(const signals::SystemJournal& journal, const Now& now, const recording::TakeSample& take);
  void append_progress(std::vector<TopicProgress>& all, const bus::ReaderStatus& reader) const;

 private:
  std::uint64_t contract_ = bus::contract_hash();
  std::array<std::unique_ptr<JournalledTopic>, bus::kTopicCount> topics_;  ///< null: has none
};

}  // namespace farrier::recorder
