#pragma once

#include <fastdds/dds/domain/DomainParticipant.hpp>
#include <fastdds/dds/domain/DomainParticipantFactory.hpp>
#include <fastdds/dds/domain/DomainParticipantListener.hpp>
#include <fastdds/dds/publisher/Publisher.hpp>
#include <fastdds/dds/subscriber/Subscriber.hpp>
#include <fastdds/dds/topic/Topic.hpp>
#include <fastdds/dds/topic/TypeSupport.hpp>

#include <array>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "bus/endpoint_check.hpp"
#include "bus/said_once.hpp"
#include "bus_fastdds/fast_qos.hpp"

namespace farrier::bus_fastdds {

/// Hears from Fast DDS whom it keeps out.
class AuthenticationEvents final : public dds::DomainParticipantListener {
 public:
  void onParticipantAuthentication(dds::DomainParticipant* participant,
                                   eprosima::fastrtps::rtps::ParticipantAuthenticationInfo&& info) override;

  bus::SaidOnce warnings;
};

/// The participant and what its endpoints share: topics, and one publisher and subscriber per list of partitions.
/// Endpoints hold it alive, so they may outlive the bus.
class FastSession {
 public:
  static Result<std::shared_ptr<FastSession>> open(const bus::NetworkOptions& options);
  ~FastSession();
  FastSession(const FastSession&) = delete;
  FastSession& operator=(const FastSession&) = delete;

  bool secured() const noexcept { return secured_; }
  /// Where to look when an endpoint is refused.
  const std::string& refusals() const noexcept { return refusals_; }
  std::vector<std::string> take_security_warnings() { return events_->warnings.take(); }

  /// Null when Fast DDS refuses; its own log says why.
  dds::Topic* topic(bus::TopicId id, dds::TypeSupport (*make_type)());
  dds::Publisher* publisher(const std::vector<std::string>& partitions);
  dds::Subscriber* subscriber(const std::vector<std::string>& partitions);

 private:
  FastSession(std::shared_ptr<dds::DomainParticipantFactory> factory, dds::DomainParticipant* participant,
              std::unique_ptr<AuthenticationEvents> events, const bus::NetworkOptions& options)
      : factory_(std::move(factory)),
        events_(std::move(events)),
        participant_(participant),
        secured_(options.security.has_value()),
        refusals_(bus::refusals_by(options)) {}

  std::shared_ptr<dds::DomainParticipantFactory> factory_;
  std::unique_ptr<AuthenticationEvents> events_;
  dds::DomainParticipant* participant_;
  bool secured_;
  std::string refusals_;
  std::array<dds::Topic*, bus::kTopicCount> topics_{};
  std::map<std::vector<std::string>, dds::Publisher*> publishers_;
  std::map<std::vector<std::string>, dds::Subscriber*> subscribers_;
};

}  // namespace farrier::bus_fastdds
