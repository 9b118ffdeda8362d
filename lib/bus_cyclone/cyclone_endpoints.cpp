#include "bus_cyclone/cyclone_endpoints.hpp"

#include <atomic>

#include "bus_cyclone/wire_types.hpp"

namespace farrier::bus_cyclone {
namespace {

template <class Signal>
class CycloneWriter final : public bus::RawWriter {
 public:
  CycloneWriter(dds_entity_t writer, bus::Sending sending) : writer_(writer), sending_(sending) {}
  ~CycloneWriter() override { dds_delete(writer_); }

  bool write(const void* signal) noexcept override {
    typename Wire<Signal>::Type sample;
    Wire<Signal>::copy(sample, *static_cast<const Signal*>(signal));
    const bool written = dds_write(writer_, &sample) == DDS_RETCODE_OK;
    if (sending_ == bus::Sending::kAtOnce) {
      flush();
    }
    return written;
  }

  void flush() noexcept override { dds_write_flush(writer_); }

  void assert_liveliness() noexcept override { dds_assert_liveliness(writer_); }

  int matched_readers() const noexcept override {
    dds_publication_matched_status_t status{};
    dds_get_publication_matched_status(writer_, &status);
    return static_cast<int>(status.current_count);
  }

 private:
  dds_entity_t writer_;
  bus::Sending sending_;
};

/// Counters that the listener callbacks of a reader write, on Cyclone's receive and event threads.
struct ReaderEvents {
  std::shared_ptr<bus::Notifier> notifier;
  std::atomic<std::uint64_t> liveliness_lost{0};
};

// Called for every sample stored, on the receive thread, after the sample can be taken.
void on_data_available(dds_entity_t, void* events) { static_cast<ReaderEvents*>(events)->notifier->arrived(); }

void on_liveliness_changed(dds_entity_t, const dds_liveliness_changed_status_t status, void* events) {
  if (status.not_alive_count_change > 0) {
    static_cast<ReaderEvents*>(events)->liveliness_lost += static_cast<std::uint64_t>(status.not_alive_count_change);
  }
}

template <class Signal>
class CycloneReader final : public bus::RawReader {
 public:
  explicit CycloneReader(std::shared_ptr<bus::Notifier> notifier) {
    events_.notifier = std::move(notifier);
    for (std::size_t i = 0; i < kBatch; ++i) {
      buffers_[i] = &samples_[i];
    }
  }
  ~CycloneReader() override {
    if (reader_ > 0) {
      dds_delete(reader_);  // waits for callbacks under way
    }
    for (auto& sample : samples_) {
      dds_sample_free(&sample, &Wire<Signal>::descriptor(), DDS_FREE_CONTENTS);
    }
  }

  dds_return_t open(dds_entity_t subscriber, dds_entity_t topic, const dds_qos_t& qos) {
    dds_listener_t* listener = dds_create_listener(&events_);
    if (events_.notifier) {
      dds_lset_data_available(listener, on_data_available);
    }
    dds_lset_liveliness_changed(listener, on_liveliness_changed);
    reader_ = dds_create_reader(subscriber, topic, &qos, listener);
    dds_delete_listener(listener);
    return reader_;
  }

  std::size_t take(void* signals, std::size_t capacity) noexcept override {
    auto* out = static_cast<Signal*>(signals);
    std::size_t filled = 0;
    while (filled < capacity) {
      const auto wanted = static_cast<std::uint32_t>(std::min(capacity - filled, kBatch));
      const dds_return_t count = dds_take(reader_, buffers_.data(), infos_.data(), wanted, wanted);
      if (count <= 0) {
        break;
      }
      for (std::size_t i = 0; i < static_cast<std::size_t>(count); ++i) {
        if (infos_[i].valid_data) {
          Wire<Signal>::copy(out[filled++], samples_[i]);
        }
      }
      if (static_cast<std::uint32_t>(count) < wanted) {
        break;
      }
    }
    received_ += filled;
    return filled;
  }

  bus::ReaderStatus status() const noexcept override {
    bus::ReaderStatus out;
    out.received = received_;
    dds_sample_lost_status_t lost{};
    dds_get_sample_lost_status(reader_, &lost);
    out.lost = lost.total_count;
    dds_requested_deadline_missed_status_t deadline{};
    dds_get_requested_deadline_missed_status(reader_, &deadline);
    out.deadline_missed = deadline.total_count;
    out.liveliness_lost = events_.liveliness_lost;
    dds_requested_incompatible_qos_status_t incompatible{};
    dds_get_requested_incompatible_qos_status(reader_, &incompatible);
    out.incompatible_qos = incompatible.total_count;
    dds_subscription_matched_status_t matched{};
    dds_get_subscription_matched_status(reader_, &matched);
    out.matched_writers = static_cast<int>(matched.current_count);
    return out;
  }

 private:
  static constexpr std::size_t kBatch = 8;

  dds_entity_t reader_ = 0;
  ReaderEvents events_;
  std::uint64_t received_ = 0;
  std::array<typename Wire<Signal>::Type, kBatch> samples_{};
  std::array<void*, kBatch> buffers_{};
  std::array<dds_sample_info_t, kBatch> infos_{};
};

template <class Signal>
std::unique_ptr<bus::RawWriter> wrap_typed_writer(dds_entity_t writer, bus::Sending sending) {
  return std::make_unique<CycloneWriter<Signal>>(writer, sending);
}

template <class Signal>
Result<std::unique_ptr<bus::RawReader>> make_typed_reader(dds_entity_t subscriber, dds_entity_t topic,
                                                          const dds_qos_t& qos,
                                                          std::shared_ptr<bus::Notifier> notifier) {
  auto reader = std::make_unique<CycloneReader<Signal>>(std::move(notifier));
  const dds_return_t opened = reader->open(subscriber, topic, qos);
  if (opened < 0) {
    return cyclone_base::refused(std::string("the reader of ") + bus::spec(bus::TopicOf<Signal>::id).name, opened);
  }
  return std::unique_ptr<bus::RawReader>(std::move(reader));
}

/// Functions of a topic that depend on its signal type.
struct TopicFactory {
  const dds_topic_descriptor_t& (*descriptor)();
  decltype(&wrap_typed_writer<signals::ClockTick>) writer;
  decltype(&make_typed_reader<signals::ClockTick>) reader;
};

#define FARRIER_FACTORY(Signal, file)                                                   \
  TopicFactory{&Wire<signals::Signal>::descriptor, &wrap_typed_writer<signals::Signal>, \
               &make_typed_reader<signals::Signal>},
constexpr std::array<TopicFactory, bus::kTopicCount> kFactories{FARRIER_SIGNALS(FARRIER_FACTORY)};
#undef FARRIER_FACTORY

const TopicFactory& factory(bus::TopicId topic) { return kFactories[static_cast<std::size_t>(topic)]; }

}  // namespace

const dds_topic_descriptor_t& topic_descriptor(bus::TopicId topic) { return factory(topic).descriptor(); }

std::unique_ptr<bus::RawWriter> wrap_writer(bus::TopicId topic, dds_entity_t writer) {
  return factory(topic).writer(writer, bus::spec(topic).sending);
}

Result<std::unique_ptr<bus::RawReader>> make_reader(bus::TopicId topic, dds_entity_t subscriber, dds_entity_t dds_topic,
                                                    const dds_qos_t& qos, std::shared_ptr<bus::Notifier> notifier) {
  return factory(topic).reader(subscriber, dds_topic, qos, std::move(notifier));
}

}  // namespace farrier::bus_cyclone
