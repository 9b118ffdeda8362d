#pragma once

#include <fastdds/dds/subscriber/DataReader.hpp>
#include <fastdds/dds/subscriber/DataReaderListener.hpp>

#include <algorithm>
#include <atomic>
#include <memory>

#include "bus/bus.hpp"
#include "bus_fastdds/fast_qos.hpp"

namespace farrier::bus_fastdds {

/// Counts what happens to a reader, on Fast DDS's receive and event threads.
class ReaderEvents final : public dds::DataReaderListener {
 public:
  explicit ReaderEvents(std::shared_ptr<bus::Notifier> notifier) : notifier_(std::move(notifier)) {}

  /// Without data_available if no thread waits for samples.
  dds::StatusMask mask() const {
    const dds::StatusMask always = dds::StatusMask::sample_lost() << dds::StatusMask::requested_deadline_missed()
                                                                  << dds::StatusMask::liveliness_changed()
                                                                  << dds::StatusMask::requested_incompatible_qos()
                                                                  << dds::StatusMask::subscription_matched();
    return notifier_ ? dds::StatusMask(always) << dds::StatusMask::data_available() : always;
  }

  /// Bracket the removal of one sample, which may find none.
  void taking() noexcept { taken_at_most_.fetch_add(1); }
  void taken(bool removed) noexcept { removed ? taken_at_least_.fetch_add(1) : taken_at_most_.fetch_sub(1); }

  bus::ReaderStatus status() const noexcept {
    bus::ReaderStatus status;
    status.lost = lost_.load(std::memory_order_relaxed);
    status.deadline_missed = deadline_missed_.load(std::memory_order_relaxed);
    status.liveliness_lost = liveliness_lost_.load(std::memory_order_relaxed);
    status.incompatible_qos = incompatible_qos_.load(std::memory_order_relaxed);
    status.matched_writers = matched_writers_.load(std::memory_order_relaxed);
    return status;
  }

  // One call may report several samples. Their number follows from the samples that wait now, those that waited before
  // and those taken in between; a take under way makes that a range, of which the upper end is used.
  void on_data_available(dds::DataReader* reader) override {
    const std::uint64_t at_least = taken_at_least_.load();
    const std::uint64_t at_most = taken_at_most_.load();
    const std::uint64_t waiting = reader->get_unread_count();
    const std::uint64_t seen = waiting + at_most;
    const std::uint64_t fresh = seen > seen_at_least_ ? seen - seen_at_least_ : 1;
    seen_at_least_ = waiting + at_least;
    for (std::uint64_t i = 0; i < fresh; ++i) {
      notifier_->arrived();
    }
  }
  void on_sample_lost(dds::DataReader*, const dds::SampleLostStatus& status) override {
    lost_.store(static_cast<std::uint64_t>(status.total_count), std::memory_order_relaxed);
  }
  void on_requested_deadline_missed(dds::DataReader*, const dds::RequestedDeadlineMissedStatus& status) override {
    deadline_missed_.store(status.total_count, std::memory_order_relaxed);
  }
  void on_liveliness_changed(dds::DataReader*, const dds::LivelinessChangedStatus& status) override {
    const int died = std::max(0, status.not_alive_count_change);
    liveliness_lost_.fetch_add(static_cast<std::uint64_t>(died), std::memory_order_relaxed);
  }
  void on_requested_incompatible_qos(dds::DataReader*, const dds::RequestedIncompatibleQosStatus& status) override {
    incompatible_qos_.store(status.total_count, std::memory_order_relaxed);
  }
  void on_subscription_matched(dds::DataReader*, const dds::SubscriptionMatchedStatus& status) override {
    matched_writers_.store(status.current_count, std::memory_order_relaxed);
  }

 private:
  std::shared_ptr<bus::Notifier> notifier_;
  std::atomic<std::uint64_t> taken_at_least_{0};
  std::atomic<std::uint64_t> taken_at_most_{0};
  std::uint64_t seen_at_least_ = 0;  // receive thread alone: Fast DDS serialises the calls of a reader
  std::atomic<std::uint64_t> lost_{0};
  std::atomic<std::uint64_t> deadline_missed_{0};
  std::atomic<std::uint64_t> liveliness_lost_{0};
  std::atomic<std::uint64_t> incompatible_qos_{0};
  std::atomic<int> matched_writers_{0};
};

}  // namespace farrier::bus_fastdds
