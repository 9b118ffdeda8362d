#pragma once

#include <fastdds/dds/domain/DomainParticipant.hpp>
#include <fastdds/dds/domain/DomainParticipantFactory.hpp>
#include <fastdds/dds/publisher/Publisher.hpp>
#include <fastdds/dds/subscriber/Subscriber.hpp>
#include <fastdds/dds/topic/Topic.hpp>
#include <fastdds/dds/topic/TypeSupport.hpp>

#include <array>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "bus_fastdds/fast_qos.hpp"

namespace farrier::bus_fastdds {

/// The participant and what its endpoints share: topics, and one publisher and subscriber per list of partitions.
/// Endpoints hold it alive, so they may outlive the bus.
class FastSession {
 public:
  static Result<std::shared_ptr<FastSession>> open(const bus::NetworkOptions& options);
  ~FastSession();
  FastSession(const FastSession&) = delete;
  FastSession& operator=(const FastSession&) = delete;

  /// Null when Fast DDS refuses; its own log says why.
  dds::Topic* topic(bus::TopicId id, dds::TypeSupport (*make_type)());
  dds::Publisher* publisher(const std::vector<std::string>& partitions);
  dds::Subscriber* subscriber(const std::vector<std::string>& partitions);

 private:
  FastSession(std::shared_ptr<dds::DomainParticipantFactory> factory, dds::DomainParticipant* participant)
      : factory_(std::move(factory)), participant_(participant) {}

  std::shared_ptr<dds::DomainParticipantFactory> factory_;
  dds::DomainParticipant* participant_;
  std::array<dds::Topic*, bus::kTopicCount> topics_{};
  std::map<std::vector<std::string>, dds::Publisher*> publishers_;
  std::map<std::vector<std::string>, dds::Subscriber*> subscribers_;
};

}  // namespace farrier::bus_fastdds
