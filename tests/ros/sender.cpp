#include "tests/ros/sender.hpp"

#include <gtest/gtest.h>

#include "bus_ros/cyclone_ros_endpoints.hpp"
#include "bus_ros/ros_domain.hpp"
#include "tests/ros/fast_sender.hpp"

namespace farrier::test {
namespace {

class CycloneSender final : public Sender {
 public:
  CycloneSender(int domain, const std::string& topic, const std::string& type, bool reliable)
      : domain_(bus_ros::open_ros_domain({.domain = domain, .address = "127.0.0.1", .peers = {}}).value()),
        participant_(bus_ros::join_ros_domain(domain_).value()),
        writer_(
            bus_ros::open_writer(participant_, "rt" + topic, type, {.reliable = reliable, .depth = 1}, "").value()) {}
  ~CycloneSender() override {
    writer_.reset();
    dds_delete(domain_);
  }
  void write(std::span<const std::uint8_t> cdr) override { writer_->write(cdr); }
  int matched_readers() const override { return writer_->matched_readers(); }

 private:
  dds_entity_t domain_, participant_;
  std::shared_ptr<bus_ros::RawRosWriter> writer_;
};

}  // namespace

std::vector<std::string> sender_vendors() {
  return has_fast_sender() ? std::vector<std::string>{"cyclone", "fast"} : std::vector<std::string>{"cyclone"};
}

std::unique_ptr<Sender> make_sender(const std::string& vendor, int domain, const std::string& topic,
                                    const std::string& type, bool reliable) {
  if (vendor == "fast") {
    return make_fast_sender(domain, topic, type, reliable);
  }
  return std::make_unique<CycloneSender>(domain, topic, type, reliable);
}

}  // namespace farrier::test
