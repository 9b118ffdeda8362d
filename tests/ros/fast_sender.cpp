#include "tests/ros/fast_sender.hpp"

#include <fastdds/dds/domain/DomainParticipant.hpp>
#include <fastdds/dds/domain/DomainParticipantFactory.hpp>
#include <fastdds/dds/publisher/DataWriter.hpp>
#include <fastdds/dds/publisher/Publisher.hpp>
#include <fastdds/dds/topic/TopicDataType.hpp>
#include <fastdds/dds/topic/TypeSupport.hpp>
#include <fastdds/rtps/transport/UDPv4TransportDescriptor.h>
#include <gtest/gtest.h>

#include <cstring>

#include "bus_ros/ros_types.hpp"

namespace farrier::test {
namespace {

namespace dds = eprosima::fastdds::dds;
namespace rtps = eprosima::fastrtps::rtps;
using Bytes = std::vector<std::uint8_t>;

/// A type whose samples are their bytes, as rmw_fastrtps has them: without a type object.
class BytesType final : public dds::TopicDataType {
 public:
  explicit BytesType(const std::string& name) {
    setName(name.c_str());
    m_typeSize = kMost;
    m_isGetKeyDefined = false;
    auto_fill_type_object(false);
    auto_fill_type_information(false);
  }
  bool serialize(void* data, rtps::SerializedPayload_t* payload) override {
    const Bytes& bytes = *static_cast<Bytes*>(data);
    payload->encapsulation = CDR_LE;
    payload->length = static_cast<std::uint32_t>(bytes.size());
    std::memcpy(payload->data, bytes.data(), bytes.size());
    return true;
  }
  bool deserialize(rtps::SerializedPayload_t*, void*) override { return false; }
  std::function<std::uint32_t()> getSerializedSizeProvider(void* data) override {
    return [data] { return static_cast<std::uint32_t>(static_cast<Bytes*>(data)->size()); };
  }
  void* createData() override { return new Bytes; }
  void deleteData(void* data) override { delete static_cast<Bytes*>(data); }
  bool getKey(void*, rtps::InstanceHandle_t*, bool) override { return false; }

 private:
  static constexpr std::uint32_t kMost = 4 << 20;
};

class FastSender final : public Sender {
 public:
  FastSender(int domain, const std::string& topic, const std::string& type, bool reliable) {
    auto transport = std::make_shared<eprosima::fastdds::rtps::UDPv4TransportDescriptor>();
    transport->interfaceWhiteList.emplace_back("127.0.0.1");
    dds::DomainParticipantQos qos;
    qos.transport().use_builtin_transports = false;
    qos.transport().user_transports.push_back(transport);
    const std::string enclave = "enclave=/;";
    qos.user_data().setValue({enclave.begin(), enclave.end()});
    auto* const factory = dds::DomainParticipantFactory::get_instance();
    participant_ = factory->create_participant(static_cast<std::uint32_t>(domain), qos);
    dds::TypeSupport support(new BytesType(bus_ros::dds_type_name(type)));
    support.register_type(participant_);
    topic_ = participant_->create_topic("rt" + topic, support.get_type_name(), dds::TOPIC_QOS_DEFAULT);
    publisher_ = participant_->create_publisher(dds::PUBLISHER_QOS_DEFAULT);
    dds::DataWriterQos writer = dds::DATAWRITER_QOS_DEFAULT;
    writer.reliability().kind = reliable ? dds::RELIABLE_RELIABILITY_QOS : dds::BEST_EFFORT_RELIABILITY_QOS;
    writer.history().depth = 1;
    writer.endpoint().history_memory_policy = rtps::PREALLOCATED_WITH_REALLOC_MEMORY_MODE;
    writer_ = publisher_->create_datawriter(topic_, writer);
  }
  ~FastSender() override {
    participant_->delete_contained_entities();
    dds::DomainParticipantFactory::get_instance()->delete_participant(participant_);
  }
  void write(std::span<const std::uint8_t> cdr) override {
    Bytes bytes(cdr.begin(), cdr.end());
    writer_->write(&bytes);
  }
  int matched_readers() const override {
    dds::PublicationMatchedStatus status;
    writer_->get_publication_matched_status(status);
    return status.current_count;
  }

 private:
  dds::DomainParticipant* participant_ = nullptr;
  dds::Topic* topic_ = nullptr;
  dds::Publisher* publisher_ = nullptr;
  dds::DataWriter* writer_ = nullptr;
};

}  // namespace

bool has_fast_sender() { return true; }

std::unique_ptr<Sender> make_fast_sender(int domain, const std::string& topic, const std::string& type, bool reliable) {
  return std::make_unique<FastSender>(domain, topic, type, reliable);
}

}  // namespace farrier::test
