#pragma once

// Writers of a ROS node on either vendor, with QoS as its rmw has them. They know nothing of our nodes but the bytes of
// messages.

#include <memory>
#include <span>
#include <string>
#include <vector>

#include "ros_messages/cdr.hpp"

namespace farrier::test {

/// A writer of one topic, in a participant of its own.
class Sender {
 public:
  virtual ~Sender() = default;
  virtual void write(std::span<const std::uint8_t> cdr) = 0;
  virtual int matched_readers() const = 0;

  template <ros_messages::Message M>
  void send(const M& message) {
    ros_messages::to_cdr(message, bytes_);
    write(bytes_);
  }

 private:
  std::vector<std::uint8_t> bytes_;
};

/// The vendors that this build has, "cyclone" and "fast".
std::vector<std::string> sender_vendors();

/// `topic`: "/hyq/stop"; `type`: "std_msgs/msg/Bool". On the loopback interface.
std::unique_ptr<Sender> make_sender(const std::string& vendor, int domain, const std::string& topic,
                                    const std::string& type, bool reliable = true);

template <ros_messages::Message M>
std::unique_ptr<Sender> sender_of(const std::string& vendor, int domain, const std::string& topic,
                                  bool reliable = true) {
  return make_sender(vendor, domain, topic, M::kRosName, reliable);
}

}  // namespace farrier::test
