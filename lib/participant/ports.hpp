#pragma once

// Typed ports of a participant. A port knows which keys it must hear (or speak for), so that before a run starts
// every route can be proved by a probe: a sample that carries its key and no tick.

#include <algorithm>
#include <atomic>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "bus/bus.hpp"
#include "core/ticks_since.hpp"
#include "participant/stream_journal.hpp"
#include "signals/tick_of.hpp"

namespace farrier::participant {

/// The key of a signal. A sample without a tick is a probe.
inline std::uint16_t& key_of(signals::GaitPhase& s) { return s.leg; }
inline std::uint16_t& key_of(signals::SystemMode& s) { return s.robot; }
inline std::uint16_t& key_of(signals::SystemRequest& s) { return s.robot; }
inline std::uint16_t& key_of(signals::ClockTick& s) { return s.clock; }
inline std::uint16_t& key_of(signals::BodyCommand& s) { return s.robot; }
template <class Signal>
requires requires(Signal s) { s.supply; }
std::uint16_t& key_of(Signal& s) { return s.supply; }
template <class Signal>
requires requires(Signal s) { s.trunk; }
std::uint16_t& key_of(Signal& s) { return s.trunk; }
template <class Signal>
requires requires(Signal s) {
  s.joint;
  s.tick;
}
std::uint16_t& key_of(Signal& s) { return s.joint; }
inline std::uint16_t& key_of(signals::JointControllerGains& s) { return s.joint; }
inline std::uint16_t& key_of(signals::ClockTickDone& s) { return s.participant; }
inline std::uint16_t& key_of(signals::SystemJournal& s) { return s.stream; }

template <class Signal>
std::uint16_t key_of(const Signal& s) {
  return key_of(const_cast<Signal&>(s));
}

/// Interface of any port for the greeting and the health report.
class Port {
 public:
  virtual ~Port() = default;
  virtual void probe() noexcept {}
  virtual int routes_expected() const noexcept { return 0; }
  virtual int routes_heard() const noexcept { return 0; }
  virtual std::string first_unheard() const { return {}; }
  /// The run has started: what was lost while greeting does not count.
  virtual void start() noexcept {}
  /// The run is over: sends samples that were kept back. In lock-step, where a process has one thread.
  virtual void finish() noexcept {}
  virtual void count(signals::SystemHealth& health) const noexcept = 0;
};

/// Receiving port: one reader, and the keys that must be heard on it.
template <class Signal>
class In final : public Port {
 public:
  In(bus::Subscription<Signal> subscription, std::vector<std::uint16_t> keys)
      : subscription_(std::move(subscription)), keys_(std::move(keys)), heard_(keys_.size(), false) {}

  /// Calls consume(signal) for every waiting sample, oldest first. Returns the number of samples.
  template <class Consume>
  std::size_t drain(Consume&& consume) {
    return subscription_.drain([&](const Signal& signal) {
      if (bus::spec(kTopic).route == bus::Route::kLeg && !is_mine(key_of(signal))) {
        return;
      }
      if (unheard_left_) {
        mark(key_of(signal));
      }
      if (tick_of(signal) != kNoTick) {
        if (received_++ == 0) {
          forget_lost_probes();  // a writer that started later than this reader went on probing
        }
        count_gap(signal);
        consume(signal);
      }
    });
  }

  int routes_expected() const noexcept override { return static_cast<int>(keys_.size()); }
  int routes_heard() const noexcept override {
    return static_cast<int>(std::count(heard_.begin(), heard_.end(), true));
  }
  std::string first_unheard() const override {
    const auto place = std::find(heard_.begin(), heard_.end(), false);
    if (place == heard_.end()) {
      return {};
    }
    return std::string(bus::spec(kTopic).name) + " of " + std::to_string(keys_[place - heard_.begin()]);
  }
  void start() noexcept override { forget_lost_probes(); }
  void count(signals::SystemHealth& health) const noexcept override {
    health.received[static_cast<std::size_t>(kTopic)] += received_;
    health.lost[static_cast<std::size_t>(kTopic)] += subscription_.status().lost - lost_before_ + skipped_;
  }
  bus::ReaderStatus status() const noexcept { return subscription_.status(); }

 private:
  static constexpr bus::TopicId kTopic = bus::TopicOf<Signal>::id;

  bool is_mine(std::uint16_t key) const noexcept { return std::find(keys_.begin(), keys_.end(), key) != keys_.end(); }

  void forget_lost_probes() noexcept { lost_before_ = subscription_.status().lost; }

  // Sensors come for every tick of a joint. A missing one was overwritten or dropped on the way, which the transport
  // does not report.
  void count_gap(const Signal& signal) noexcept {
    if constexpr (std::is_same_v<Signal, signals::JointSensors>) {
      const auto place = std::find(keys_.begin(), keys_.end(), key_of(signal)) - keys_.begin();
      if (static_cast<std::size_t>(place) < last_tick_.size()) {
        Tick& last = last_tick_[static_cast<std::size_t>(place)];
        skipped_ += last != kNoTick && signal.tick > last ? ticks_since(last, signal.tick) - 1 : 0;
        last = signal.tick;
      }
    }
  }

  void mark(std::uint16_t key) noexcept {
    for (std::size_t i = 0; i < keys_.size(); ++i) {
      if (keys_[i] == key) {
        heard_[i] = true;
      }
    }
    unheard_left_ = std::find(heard_.begin(), heard_.end(), false) != heard_.end();
  }

  bus::Subscription<Signal> subscription_;
  std::vector<std::uint16_t> keys_;
  std::vector<bool> heard_;
  bool unheard_left_ = true;
  std::uint64_t received_ = 0;
  std::vector<Tick> last_tick_ = std::vector<Tick>(keys_.size(), kNoTick);
  std::uint64_t skipped_ = 0;
  std::uint64_t lost_before_ = 0;  ///< probes lost while endpoints found each other
};

/// Sending port: the keys it speaks for, with one writer per leg where the topic is routed by leg.
template <class Signal>
class Out final : public Port {
 public:
  /// `publisher_of_key`: the place in `publishers` of each key's.
  Out(std::vector<bus::Publisher<Signal>> publishers, std::vector<std::uint16_t> keys,
      std::vector<std::size_t> publisher_of_key)
      : publishers_(std::move(publishers)), keys_(std::move(keys)), publisher_of_key_(std::move(publisher_of_key)) {}

  /// Publishes a sample. One that the transport refuses counts as lost. On a topic whose samples go together it goes
  /// with the next flush.
  void publish(const Signal& signal) noexcept {
    sent_.fetch_add(1, std::memory_order_relaxed);
    if (!publisher_of(key_of(signal)).queue(signal)) {
      refused_.fetch_add(1, std::memory_order_relaxed);
    }
    if constexpr (signals::kJournalled<Signal>) {
      if (journal_) {
        journal_->add(signal);
        if (bus::spec(bus::TopicOf<Signal>::id).sending == bus::Sending::kAtOnce) {
          journal_->flush();
        }
      }
    }
  }
  /// Copies what this port publishes to recorders by `journal`.
  void keep_journal(std::unique_ptr<StreamJournal> journal) noexcept { journal_ = std::move(journal); }
  /// Sends what was published of a topic whose samples go together.
  void flush() noexcept {
    for (bus::Publisher<Signal>& publisher : publishers_) {
      publisher.flush();
    }
    if (journal_) {
      journal_->flush();
    }
  }
  /// Keeps the authority of a topic whose writer seldom writes.
  void assert_liveliness() noexcept {
    for (bus::Publisher<Signal>& publisher : publishers_) {
      publisher.assert_liveliness();
    }
  }
  void probe() noexcept override {
    for (const std::uint16_t key : keys_) {
      Signal signal;
      key_of(signal) = key;
      publisher_of(key).publish(signal);
    }
    flush();
    if (journal_) {
      journal_->probe();
    }
  }
  void start() noexcept override {
    if (journal_) {
      journal_->look();
    }
  }
  void finish() noexcept override {
    if (journal_) {
      journal_->finish();
    }
  }
  std::uint64_t sent() const noexcept { return sent_.load(std::memory_order_relaxed); }
  void count(signals::SystemHealth& health) const noexcept override {
    health.sent[static_cast<std::size_t>(bus::TopicOf<Signal>::id)] += sent();
    health.lost[static_cast<std::size_t>(bus::TopicOf<Signal>::id)] += refused_.load(std::memory_order_relaxed);
  }

 private:
  bus::Publisher<Signal>& publisher_of(std::uint16_t key) noexcept {
    if (publishers_.size() == 1) {
      return publishers_.front();
    }
    const auto place = std::find(keys_.begin(), keys_.end(), key);
    return publishers_[publisher_of_key_[static_cast<std::size_t>(place - keys_.begin())]];
  }

  std::vector<bus::Publisher<Signal>> publishers_;
  std::vector<std::uint16_t> keys_;
  std::vector<std::size_t> publisher_of_key_;
  std::unique_ptr<StreamJournal> journal_;  ///< where signals::kJournalled
  std::atomic<std::uint64_t> sent_{0};      ///< the sender thread counts, the bus thread reports
  std::atomic<std::uint64_t> refused_{0};
};

/// Holds the samples of the next few ticks of each key until their tick is due.
template <class Signal>
class TickInbox {
 public:
  explicit TickInbox(std::vector<std::uint16_t> keys) : keys_(std::move(keys)), slots_(keys_.size()) {}

  void put(const Signal& signal) noexcept {
    const auto place = std::find(keys_.begin(), keys_.end(), key_of(signal));
    if (place != keys_.end()) {
      slots_[static_cast<std::size_t>(place - keys_.begin())][index(tick_of(signal))] = signal;
    }
  }
  /// The sample of the i-th key for exactly this tick, or null.
  const Signal* find(std::size_t i, Tick tick) const noexcept {
    if (tick < 0) {
      return nullptr;
    }
    const Signal& signal = slots_[i][index(tick)];
    return tick_of(signal) == tick ? &signal : nullptr;
  }
  int missing(Tick tick) const noexcept {
    int count = 0;
    for (std::size_t i = 0; i < keys_.size(); ++i) {
      count += find(i, tick) == nullptr ? 1 : 0;
    }
    return count;
  }
  std::uint16_t first_missing(Tick tick) const noexcept {
    for (std::size_t i = 0; i < keys_.size(); ++i) {
      if (find(i, tick) == nullptr) {
        return keys_[i];
      }
    }
    return 0;
  }
  const std::vector<std::uint16_t>& keys() const noexcept { return keys_; }

 private:
  static constexpr std::size_t kDepth = 4;
  static std::size_t index(Tick tick) noexcept { return static_cast<std::size_t>(tick) % kDepth; }

  std::vector<std::uint16_t> keys_;
  std::vector<std::array<Signal, kDepth>> slots_;
};

}  // namespace farrier::participant
