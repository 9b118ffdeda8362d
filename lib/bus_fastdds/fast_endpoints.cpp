#include "bus_fastdds/fast_endpoints.hpp"

#include <fastdds/dds/publisher/DataWriter.hpp>
#include <fastdds/dds/subscriber/DataReader.hpp>
#include <fastdds/dds/subscriber/SampleInfo.hpp>

#include <thread>

#include "bus_fastdds/gathered_sends.hpp"
#include "bus_fastdds/reader_events.hpp"
#include "bus_fastdds/wire_types.hpp"

namespace farrier::bus_fastdds {
namespace {

class FastWriter final : public bus::RawWriter {
 public:
  FastWriter(std::shared_ptr<FastSession> session, dds::Publisher* publisher, dds::DataWriter* writer,
             bus::Sending sending)
      : session_(std::move(session)),
        publisher_(publisher),
        writer_(writer),
        sending_(sending),
        asynchronous_(writer->get_qos().publish_mode().kind == dds::ASYNCHRONOUS_PUBLISH_MODE) {}
  /// Removes all samples before it deletes the writer. If Fast DDS 2.9 ends a writer that still keeps samples, a
  /// heartbeat between their releases searches a sequence number that is no longer there, and never ends.
  ~FastWriter() override {
    std::size_t removed = 0;
    writer_->clear_history(&removed);
    publisher_->delete_datawriter(writer_);
  }

  bool write(const void* signal) noexcept override {
    // Fast DDS asks for a pointer to non-const and hands it to SignalType, which only reads.
    void* sample = const_cast<void*>(signal);
    if (sending_ == bus::Sending::kAtOnce) {
      return writer_->write(sample);
    }
    const GatheredSends::Scope until_flush(together_);
    return writer_->write(sample);
  }

  void flush() noexcept override {
    together_.send();
    if (asynchronous_) {
      std::this_thread::yield();  // to the thread that sends, which has this one's priority
    }
  }

  void assert_liveliness() noexcept override { writer_->assert_liveliness(); }

  int matched_readers() const noexcept override {
    dds::PublicationMatchedStatus status;
    writer_->get_publication_matched_status(status);
    return status.current_count;
  }

 private:
  std::shared_ptr<FastSession> session_;
  dds::Publisher* publisher_;
  dds::DataWriter* writer_;
  bus::Sending sending_;
  bool asynchronous_;
  GatheredSends together_;
};

template <class Signal>
class FastReader final : public bus::RawReader {
 public:
  FastReader(std::shared_ptr<FastSession> session, dds::Subscriber* subscriber,
             std::shared_ptr<bus::Notifier> notifier)
      : session_(std::move(session)), subscriber_(subscriber), events_(std::move(notifier)) {}
  ~FastReader() override {
    if (reader_ != nullptr) {
      // Deleting alone would wait for callbacks under way too, but could start new ones first.
      reader_->set_listener(nullptr);
      subscriber_->delete_datareader(reader_);
    }
  }

  bool open(dds::Topic* topic, const dds::DataReaderQos& qos) {
    reader_ = subscriber_->create_datareader(topic, qos, &events_, events_.mask());
    return reader_ != nullptr;
  }

  std::size_t take(void* signals, std::size_t capacity) noexcept override {
    auto* out = static_cast<Signal*>(signals);
    std::size_t filled = 0;
    dds::SampleInfo info;
    while (filled < capacity) {
      events_.taking();
      const bool removed = reader_->take_next_sample(&out[filled], &info) == ReturnCode_t::RETCODE_OK;
      events_.taken(removed);
      if (!removed) {
        break;
      }
      if (info.valid_data) {
        ++filled;
      }
    }
    received_.fetch_add(filled, std::memory_order_relaxed);
    return filled;
  }

  bus::ReaderStatus status() const noexcept override {
    bus::ReaderStatus status = events_.status();
    status.received = received_.load(std::memory_order_relaxed);
    return status;
  }

 private:
  std::shared_ptr<FastSession> session_;
  dds::Subscriber* subscriber_;
  ReaderEvents events_;
  dds::DataReader* reader_ = nullptr;
  std::atomic<std::uint64_t> received_{0};
};

/// Functions of a topic that depend on its signal type.
struct TopicFactory {
  dds::TypeSupport (*type)();
  Result<std::unique_ptr<bus::RawReader>> (*reader)(const std::shared_ptr<FastSession>&, dds::Subscriber*, dds::Topic*,
                                                    const dds::DataReaderQos&, std::shared_ptr<bus::Notifier>);
};

template <class Signal>
dds::TypeSupport make_type() {
  return dds::TypeSupport(new SignalType<Signal>);
}

template <class Signal>
Result<std::unique_ptr<bus::RawReader>> make_typed_reader(const std::shared_ptr<FastSession>& session,
                                                          dds::Subscriber* subscriber, dds::Topic* topic,
                                                          const dds::DataReaderQos& qos,
                                                          std::shared_ptr<bus::Notifier> notifier) {
  auto reader = std::make_unique<FastReader<Signal>>(session, subscriber, std::move(notifier));
  if (!reader->open(topic, qos)) {
    return Error{"Fast DDS refuses the reader of " + topic->get_name() + " (its own message is above)" + session->refusals()};
  }
  return std::unique_ptr<bus::RawReader>(std::move(reader));
}

#define FARRIER_FACTORY(Signal, file) TopicFactory{&make_type<signals::Signal>, &make_typed_reader<signals::Signal>},
constexpr std::array<TopicFactory, bus::kTopicCount> kFactories{FARRIER_SIGNALS(FARRIER_FACTORY)};
#undef FARRIER_FACTORY

const TopicFactory& factory(bus::TopicId topic) { return kFactories[static_cast<std::size_t>(topic)]; }

Error refused(const FastSession& session, const std::string& what, bus::TopicId topic) {
  return Error{"Fast DDS refuses " + what + " of " + bus::spec(topic).name + " (its own message is above)" +
               session.refusals()};
}

}  // namespace

Result<std::unique_ptr<bus::RawWriter>> make_writer(const std::shared_ptr<FastSession>& session,
                                                    const bus::EndpointSpec& endpoint) {
  dds::Topic* topic = session->topic(endpoint.topic, factory(endpoint.topic).type);
  if (topic == nullptr) {
    return refused(*session, "the topic", endpoint.topic);
  }
  dds::Publisher* publisher = session->publisher(endpoint.partitions);
  if (publisher == nullptr) {
    return refused(*session, "the partitions of a writer", endpoint.topic);
  }
  dds::DataWriter* writer = publisher->create_datawriter(topic, writer_qos(endpoint, session->secured()));
  if (writer == nullptr) {
    return refused(*session, "the writer", endpoint.topic);
  }
  return std::unique_ptr<bus::RawWriter>(std::make_unique<FastWriter>(session, publisher, writer, bus::spec(endpoint.topic).sending));
}

Result<std::unique_ptr<bus::RawReader>> make_reader(const std::shared_ptr<FastSession>& session,
                                                    const bus::EndpointSpec& endpoint,
                                                    std::shared_ptr<bus::Notifier> notifier) {
  dds::Topic* topic = session->topic(endpoint.topic, factory(endpoint.topic).type);
  if (topic == nullptr) {
    return refused(*session, "the topic", endpoint.topic);
  }
  dds::Subscriber* subscriber = session->subscriber(endpoint.partitions);
  if (subscriber == nullptr) {
    return refused(*session, "the partitions of a reader", endpoint.topic);
  }
  return factory(endpoint.topic).reader(session, subscriber, topic, reader_qos(endpoint), std::move(notifier));
}

}  // namespace farrier::bus_fastdds
