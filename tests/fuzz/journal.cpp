// Journals as a recorder takes them from the network.

#include "recorder/journal_streams.hpp"
#include "tests/fuzz/harness.hpp"
#include "tests/fuzz/input.hpp"

namespace farrier::fuzz {

void journal(Bytes bytes) {
  Input input(bytes);
  recorder::JournalStreams streams;
  std::uint64_t handed_on = 0;
  constexpr int kJournals = 4;
  for (int i = 0; i < kJournals && !input.empty(); ++i) {
    signals::SystemJournal journal;
    journal.stream = input.raw<std::uint16_t>();
    journal.contract = bus::contract_hash();
    journal.samples_before = input.raw<std::uint64_t>();
    journal.tick = input.tick(i);
    journal.closed_after_ns = input.raw<std::uint32_t>();
    journal.samples = input.raw<std::uint16_t>();
    journal.bytes.assign(input.rest());
    const recorder::Now now;
    streams.take(journal, now, [&](const farrier::recording::Sample& sample) {
      require(recorder::is_journalled(sample.topic), "a sample is of a topic with journals");
      require(sample.log_time_ns + journal.closed_after_ns >= now.date_ns, "a sample is no older than its journal says");
      ++handed_on;
    });
  }
  std::vector<recorder::TopicProgress> progress;
  streams.append_progress(progress, {});
  std::uint64_t counted = 0;
  for (const recorder::TopicProgress& topic : progress) {
    counted += topic.samples;
  }
  require(counted == handed_on, "what is handed on is counted");
}

}  // namespace farrier::fuzz
