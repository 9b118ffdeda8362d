#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "core/result.hpp"
#include "ros_messages/cdr.hpp"

namespace farrier::bus_ros {

/// QoS of a topic as ROS names it; the rest is that of every ROS endpoint.
struct RosQos {
  bool reliable = true;
  bool transient_local = false;  ///< late joiners get the newest samples
  int depth = 10;                ///< samples kept
};

/// Global identity of an endpoint or participant: its DDS GUID, which ROS takes as gid.
using Gid = std::array<std::uint8_t, 16>;

/// Writer of one topic of ROS, of messages as bytes.
class RawRosWriter {
 public:
  virtual ~RawRosWriter() = default;
  /// Sends ros_messages::to_cdr of a message. Never waits: false, and counted, if a slow reader leaves no room.
  virtual bool write(std::span<const std::uint8_t> cdr) = 0;
  virtual std::uint64_t dropped() const noexcept = 0;
  virtual int matched_readers() const = 0;
  virtual Gid gid() const = 0;
};

/// Reader of one topic of ROS, of messages as bytes.
class RawRosReader {
 public:
  virtual ~RawRosReader() = default;
  /// Calls use(cdr, sender) with each message that waits; `sender` differs between writers.
  virtual void take(const std::function<void(std::span<const std::uint8_t>, std::uint64_t sender)>& use) = 0;
  virtual int matched_writers() const = 0;
  /// Messages that Cyclone knows to be lost.
  virtual std::uint64_t lost() const = 0;
  virtual Gid gid() const = 0;
};

template <ros_messages::Message M>
class RosWriter {
 public:
  explicit RosWriter(std::shared_ptr<RawRosWriter> raw) : raw_(std::move(raw)) {}

  bool write(const M& message) {
    ros_messages::to_cdr(message, bytes_);
    return raw_->write(bytes_);
  }
  /// False: a message of a topic that keeps none for late joiners need not be made.
  bool has_readers() const { return raw_->matched_readers() > 0; }
  const RawRosWriter& raw() const noexcept { return *raw_; }

 private:
  std::shared_ptr<RawRosWriter> raw_;
  std::vector<std::uint8_t> bytes_;
};

template <ros_messages::Message M>
class RosReader {
 public:
  explicit RosReader(std::shared_ptr<RawRosReader> raw) : raw_(std::move(raw)) {}

  /// Calls use(message, sender) with each message that waits.
  template <class Use>
  void take(Use&& use) {
    raw_->take([&](std::span<const std::uint8_t> cdr, std::uint64_t sender) {
      if (const auto message = ros_messages::from_cdr<M>(cdr)) {
        use(*message, sender);
      } else {
        ++refused_;
      }
    });
  }
  /// Messages that were none of this type.
  std::uint64_t refused() const noexcept { return refused_; }
  const RawRosReader& raw() const noexcept { return *raw_; }

 private:
  std::shared_ptr<RawRosReader> raw_;
  std::uint64_t refused_ = 0;
};

}  // namespace farrier::bus_ros
