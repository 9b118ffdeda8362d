#include "bus_fastdds/fast_session.hpp"

#include <fastdds/dds/log/Log.hpp>
#include <fastrtps/utils/IPFinder.h>
#include <fastrtps/xmlparser/XMLProfileManager.h>

#include <algorithm>
#include <atomic>
#include <regex>
#include <sstream>

#include "bus_fastdds/free_index.hpp"
#include "bus_fastdds/session_keys.hpp"

namespace farrier::bus_fastdds {
namespace {

// Two buses of one process are two computers to each other; Fast DDS's short cut between them would let tests pass
// that no network would. A library-wide setting, made after a user's profiles are read so that it holds.
void disable_intraprocess_delivery(dds::DomainParticipantFactory& factory) {
  factory.load_profiles();
  eprosima::fastrtps::LibrarySettingsAttributes settings;
  settings.intraprocess_delivery = eprosima::fastrtps::INTRAPROCESS_OFF;
  eprosima::fastrtps::xmlparser::XMLProfileManager::library_settings(settings);
}

// Fast DDS starts the thread of its log with the first message: on the real-time clock in the middle of the run, with a
// stack that is locked at once. It is started here, by a message that is filtered out.
void start_log_thread() {
  static const bool started = [] {
    dds::Log::SetErrorStringFilter(std::regex("(?!)"));
    dds::Log::QueueLog("", {}, dds::Log::Kind::Info);
    dds::Log::Flush();
    dds::Log::SetErrorStringFilter(std::regex(""));
    return true;
  }();
  static_cast<void>(started);
}

// Fast DDS would join with a participant that hears nobody.
bool is_address_of_this_computer(const std::string& address) {
  using eprosima::fastrtps::rtps::IPFinder;
  std::vector<IPFinder::info_IP> interfaces;
  IPFinder::getIPs(&interfaces, true);
  return std::any_of(interfaces.begin(), interfaces.end(),
                     [&](const IPFinder::info_IP& ip) { return ip.name == address; });
}

}  // namespace

void AuthenticationEvents::onParticipantAuthentication(dds::DomainParticipant*,
                                                       eprosima::fastrtps::rtps::ParticipantAuthenticationInfo&& info) {
  if (info.status == eprosima::fastrtps::rtps::ParticipantAuthenticationInfo::UNAUTHORIZED_PARTICIPANT) {
    std::ostringstream sentence;
    sentence << "participant " << info.guid << " could not prove who it is and is kept out";
    warnings.add(sentence.str());
  }
}

Result<std::shared_ptr<FastSession>> FastSession::open(const bus::NetworkOptions& options) {
  if (!is_address_of_this_computer(options.address)) {
    return Error{"network: " + options.address + " is not an IPv4 address of this computer"};
  }
  auto factory = dds::DomainParticipantFactory::get_shared_instance();
  disable_intraprocess_delivery(*factory);
  start_log_thread();
  remember_session_keys();
  // Fast DDS 2.9 does not give back the index of a participant that it refuses for its security.
  static std::atomic<int> lost_indices{0};
  for (int index = free_participant_index(options, lost_indices); index >= 0;
       index = free_participant_index(options, index + 1)) {
    const auto udp = transport(options);
    auto events = std::make_unique<AuthenticationEvents>();
    dds::DomainParticipant* participant =
        factory->create_participant(static_cast<std::uint32_t>(options.domain), participant_qos(options, index, udp),
                                    events.get(), dds::StatusMask::none());
    if (participant != nullptr) {
      *udp->receiving = true;
      return std::shared_ptr<FastSession>(
          new FastSession(std::move(factory), participant, std::move(events), options));
    }
    if (options.security) {
      lost_indices = index + 1;
      return Error{"Fast DDS refuses a secure participant with " + options.security->certificate +
                   " (its own message is above)"};
    }
  }
  return Error{"Fast DDS has no free participant index on " + options.address + " in domain " +
               std::to_string(options.domain) + ": are " + std::to_string(options.max_processes) +
               " processes (network: max_processes) running, or did it print another reason above?"};
}

FastSession::~FastSession() {
  participant_->delete_contained_entities();
  factory_->delete_participant(participant_);
}

dds::Topic* FastSession::topic(bus::TopicId id, dds::TypeSupport (*make_type)()) {
  dds::Topic*& topic = topics_[static_cast<std::size_t>(id)];
  if (topic == nullptr) {
    const bus::TopicSpec& spec = bus::spec(id);
    if (make_type().register_type(participant_, spec.type_name) != ReturnCode_t::RETCODE_OK) {
      return nullptr;
    }
    topic = participant_->create_topic(spec.name, spec.type_name, dds::TopicQos());
  }
  return topic;
}

dds::Publisher* FastSession::publisher(const std::vector<std::string>& partitions) {
  dds::Publisher*& publisher = publishers_[partitions];
  if (publisher == nullptr) {
    publisher = participant_->create_publisher(publisher_qos(partitions));
  }
  return publisher;
}

dds::Subscriber* FastSession::subscriber(const std::vector<std::string>& partitions) {
  dds::Subscriber*& subscriber = subscribers_[partitions];
  if (subscriber == nullptr) {
    subscriber = participant_->create_subscriber(subscriber_qos(partitions));
  }
  return subscriber;
}

}  // namespace farrier::bus_fastdds
