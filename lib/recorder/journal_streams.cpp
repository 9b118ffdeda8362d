#include "recorder/journal_streams.hpp"

#include <unordered_map>

#include "signals/journal.hpp"
#include "signals/tick_of.hpp"

namespace farrier::recorder {
namespace {

template <class Signal>
class TypedJournalledTopic final : public JournalledTopic {
 public:
  void take(const signals::SystemJournal& journal, const Now& now, const recording::TakeSample& take) override {
    auto [next, first] = next_.try_emplace(journal.stream, journal.samples_before);
    if (!first && journal.samples_before > next->second) {
      lost_ += journal.samples_before - next->second;  // a process that restarts counts from 0
    }
    next->second = journal.samples_before + journal.samples;
    signals::visit_journal<Signal>(journal, [&](const Signal& signal, auto cdr, std::uint32_t age_ns) {
      samples_.hand_on(signal, cdr, now, age_ns, take);
    });
  }
  TopicProgress progress(const bus::ReaderStatus& reader) const override { return samples_.progress(lost_, reader); }

 private:
  Stream<Signal> samples_;
  std::unordered_map<std::uint16_t, std::uint64_t> next_;  ///< by stream, samples_before of its next journal
  std::uint64_t lost_ = 0;
};

template <class Signal>
std::unique_ptr<JournalledTopic> make_topic() {
  if constexpr (signals::kJournalled<Signal>) {
    return std::make_unique<TypedJournalledTopic<Signal>>();
  } else {
    return nullptr;
  }
}

}  // namespace

bool is_journalled(bus::TopicId topic) {
#define FARRIER_JOURNALLED(Signal, file) signals::kJournalled<signals::Signal>,
  static constexpr bool kAll[] = {FARRIER_SIGNALS(FARRIER_JOURNALLED)};
#undef FARRIER_JOURNALLED
  return kAll[static_cast<std::size_t>(topic)];
}

JournalStreams::JournalStreams()
#define FARRIER_TOPIC(Signal, file) make_topic<signals::Signal>(),
    : topics_{FARRIER_SIGNALS(FARRIER_TOPIC)} {
}
#undef FARRIER_TOPIC

void JournalStreams::take(const signals::SystemJournal& journal, const Now& now, const recording::TakeSample& take) {
  const std::size_t topic = signals::topic_of_stream(journal.stream);
  if (!signals::is_probe(journal) && journal.contract == contract_ && topic < topics_.size() && topics_[topic]) {
    topics_[topic]->take(journal, now, take);
  }
}

void JournalStreams::append_progress(std::vector<TopicProgress>& all, const bus::ReaderStatus& reader) const {
  for (const auto& topic : topics_) {
    if (topic) {
      all.push_back(topic->progress(reader));
    }
  }
}

}  // namespace farrier::recorder
