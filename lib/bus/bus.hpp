#pragma once

// DDS as a process sees it: untyped endpoints behind one interface, typed ports on top. The in-process bus is a full
// implementation with the same QoS semantics and the oracle of the conformance suite.

#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "bus/notifier.hpp"
#include "bus/topics.hpp"
#include "core/result.hpp"

namespace farrier::bus {

using farrier::Vendor;

using farrier::to_string;
Result<Vendor> parse_vendor(const std::string& text);

struct EndpointSpec {
  TopicId topic;
  Qos qos;
  std::vector<std::string> partitions;  ///< exact names; a writer and a reader meet when they share one
  int ownership_strength = 0;           ///< writers of EXCLUSIVE topics; the higher wins
  bool wakes = true;                    ///< of a reader: its samples are arrivals, for which a thread may wait
};

/// Counters of an endpoint since it was created.
struct ReaderStatus {
  std::uint64_t received = 0;          ///< samples taken
  std::uint64_t lost = 0;              ///< samples the transport knows it lost
  std::uint64_t deadline_missed = 0;
  std::uint64_t liveliness_lost = 0;   ///< times a writer was declared dead
  std::uint64_t incompatible_qos = 0;  ///< writers refused for their QoS, as far as the vendor checks
  int matched_writers = 0;             ///< not proof that samples flow: see SystemHello
};

/// Untyped writer; its topic fixes which signal struct `write` reads.
class RawWriter {
 public:
  virtual ~RawWriter() = default;
  /// Publishes one signal, at once or with the next flush as its topic says. Returns false if the transport refused it.
  /// Not for the 1 kHz thread of the real-time clock.
  virtual bool write(const void* signal) noexcept = 0;
  /// Sends written samples that have not gone yet, on a topic whose samples go together (Sending::kTogether).
  virtual void flush() noexcept {}
  /// Asserts MANUAL_BY_TOPIC liveliness of a writer that has nothing to write.
  virtual void assert_liveliness() noexcept = 0;
  virtual int matched_readers() const noexcept = 0;
};

/// Untyped reader; its topic fixes which signal struct `take` writes.
class RawReader {
 public:
  virtual ~RawReader() = default;
  /// Copies the oldest waiting samples, at most `capacity`, into an array of signals; returns their number.
  virtual std::size_t take(void* signals, std::size_t capacity) noexcept = 0;
  virtual ReaderStatus status() const noexcept = 0;
};

/// One process's membership in a DDS domain. Endpoints must be destroyed before their bus.
class Bus {
 public:
  virtual ~Bus() = default;

  virtual Vendor vendor() const noexcept = 0;
  /// Refuses, with the reason, a QoS this vendor cannot honour.
  virtual Result<std::unique_ptr<RawWriter>> create_writer(const EndpointSpec& endpoint) = 0;
  virtual Result<std::unique_ptr<RawReader>> create_reader(const EndpointSpec& endpoint) = 0;

  /// Returns what DDS Security has reported since the last call about participants that it keeps out. One sentence
  /// each, without repetition.
  virtual std::vector<std::string> take_security_warnings() { return {}; }
  /// Returns the injected faults of this bus that have acted for the first time since the last call.
  virtual std::vector<std::string> take_faults_begun() { return {}; }

  /// Arrivals so far; read it before looking for samples, then wait for as many more as are still needed.
  std::uint64_t arrivals() const noexcept { return notifier_->arrivals(); }
  void wait_for_arrivals(std::uint64_t target, std::chrono::nanoseconds timeout) noexcept {
    notifier_->wait_for_arrivals(target, timeout);
  }
  void wake() noexcept { notifier_->wake(); }
  /// Counter of arrivals, for a bus that wraps another.
  const std::shared_ptr<Notifier>& notifier() const noexcept { return notifier_; }

 protected:
  Bus() = default;
  explicit Bus(std::shared_ptr<Notifier> notifier) : notifier_(std::move(notifier)) {}

  /// Counter of a reader's arrivals, or null if its samples do not wake.
  std::shared_ptr<Notifier> notifier_of(const EndpointSpec& reader) const { return reader.wakes ? notifier_ : nullptr; }

  std::shared_ptr<Notifier> notifier_ = std::make_shared<Notifier>();
};

/// Typed writing end of a topic.
template <class Signal>
class Publisher {
 public:
  static Result<Publisher> create(Bus& bus, const EndpointSpec& endpoint) {
    auto writer = FARRIER_TRY(bus.create_writer(endpoint));
    return Publisher(std::move(writer));
  }

  bool publish(const Signal& signal) noexcept {
    const bool written = queue(signal);
    flush();
    return written;
  }
  /// For a topic whose samples go together: the sample leaves with the next flush.
  bool queue(const Signal& signal) noexcept {
    ++sent_;
    return writer_->write(&signal);
  }
  void flush() noexcept { writer_->flush(); }
  void assert_liveliness() noexcept { writer_->assert_liveliness(); }
  std::uint64_t sent() const noexcept { return sent_; }
  int matched_readers() const noexcept { return writer_->matched_readers(); }

 private:
  explicit Publisher(std::unique_ptr<RawWriter> writer) : writer_(std::move(writer)) {}

  std::unique_ptr<RawWriter> writer_;
  std::uint64_t sent_ = 0;
};

/// Typed reading end of a topic.
template <class Signal>
class Subscription {
 public:
  static Result<Subscription> create(Bus& bus, const EndpointSpec& endpoint) {
    auto reader = FARRIER_TRY(bus.create_reader(endpoint));
    return Subscription(std::move(reader));
  }

  /// Calls consume(signal) for every waiting sample, oldest first; returns the number of samples.
  template <class Consume>
  std::size_t drain(Consume&& consume) {
    std::size_t total = 0;
    for (;;) {
      const std::size_t count = reader_->take(batch_.data(), batch_.size());
      for (std::size_t i = 0; i < count; ++i) {
        consume(static_cast<const Signal&>(batch_[i]));
      }
      total += count;
      if (count < batch_.size()) {
        return total;
      }
    }
  }
  ReaderStatus status() const noexcept { return reader_->status(); }

 private:
  explicit Subscription(std::unique_ptr<RawReader> reader) : reader_(std::move(reader)) {}

  std::unique_ptr<RawReader> reader_;
  std::array<Signal, 8> batch_{};
};

}  // namespace farrier::bus
