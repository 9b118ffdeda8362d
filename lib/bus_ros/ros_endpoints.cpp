#include <dds/ddsi/ddsi_cdrstream.h>
#include <dds/ddsi/ddsi_serdata.h>
#include <dds/ddsi/q_protocol.h>

#include <algorithm>
#include <array>
#include <cstdlib>

#include "bus_ros/cyclone_ros_endpoints.hpp"
#include "bus_ros/ros_domain.hpp"
#include "bus_ros/ros_types.hpp"
#include "cyclone_base/cyclone_base.hpp"

namespace farrier::bus_ros {
namespace {

/// As both rmw implementations have them, without a partition. A reliable writer of ours never waits for a slow reader.
cyclone_base::QosPtr dds_qos(const RosQos& wanted, const std::string& user_data) {
  cyclone_base::QosPtr qos = cyclone_base::endpoint_qos(wanted.depth);
  dds_qset_reliability(qos.get(), wanted.reliable ? DDS_RELIABILITY_RELIABLE : DDS_RELIABILITY_BEST_EFFORT, 0);
  dds_qset_durability(qos.get(), wanted.transient_local ? DDS_DURABILITY_TRANSIENT_LOCAL : DDS_DURABILITY_VOLATILE);
  if (!user_data.empty()) {
    dds_qset_userdata(qos.get(), user_data.data(), user_data.size());
  }
  return qos;
}

/// A sample of Cyclone's in memory of its size, aligned. Memory that one message takes beyond it serves the next one.
class Sample {
 public:
  explicit Sample(const dds_topic_descriptor_t& type) : type_(type), words_((type.m_size + 7) / 8, 0) {}
  ~Sample() { dds_stream_free_sample(words_.data(), type_.m_ops); }
  Sample(const Sample&) = delete;
  Sample& operator=(const Sample&) = delete;

  /// Reads bytes that are a message of this type, behind their header.
  void read(std::span<const std::uint8_t> bytes) {
    aligned_.resize((bytes.size() + 7) / 8 + 1);
    std::copy(bytes.begin(), bytes.end(), reinterpret_cast<std::uint8_t*>(aligned_.data()));
    dds_istream_t stream;
    dds_istream_init(&stream, static_cast<std::uint32_t>(bytes.size()), aligned_.data(), CDR_ENC_VERSION_1);
    dds_stream_read(&stream, reinterpret_cast<char*>(words_.data()), type_.m_ops);
  }
  const void* data() const noexcept { return words_.data(); }

 private:
  const dds_topic_descriptor_t& type_;
  std::vector<std::uint64_t> words_;
  std::vector<std::uint64_t> aligned_;
};

class CycloneRosWriter final : public RawRosWriter {
 public:
  CycloneRosWriter(dds_entity_t writer, const dds_topic_descriptor_t& type) : writer_(writer), sample_(type) {}
  ~CycloneRosWriter() override { dds_delete(writer_); }
  CycloneRosWriter(const CycloneRosWriter&) = delete;
  CycloneRosWriter& operator=(const CycloneRosWriter&) = delete;

  bool write(std::span<const std::uint8_t> cdr) override {
    sample_.read(cdr.subspan(ros_messages::kCdrHeader.size()));
    const bool written = dds_write(writer_, sample_.data()) == DDS_RETCODE_OK;
    dropped_ += written ? 0 : 1;
    return written;
  }
  std::uint64_t dropped() const noexcept override { return dropped_; }
  int matched_readers() const override {
    dds_publication_matched_status_t status{};
    dds_get_publication_matched_status(writer_, &status);
    return static_cast<int>(status.current_count);
  }
  Gid gid() const override { return gid_of(writer_); }

 private:
  dds_entity_t writer_;
  Sample sample_;
  std::uint64_t dropped_ = 0;
};

class CycloneRosReader final : public RawRosReader {
 public:
  explicit CycloneRosReader(dds_entity_t reader) : reader_(reader) {}
  ~CycloneRosReader() override { dds_delete(reader_); }
  CycloneRosReader(const CycloneRosReader&) = delete;
  CycloneRosReader& operator=(const CycloneRosReader&) = delete;

  void take(const std::function<void(std::span<const std::uint8_t>, std::uint64_t)>& use) override {
    constexpr std::uint32_t kAtOnce = 16;
    std::array<ddsi_serdata*, kAtOnce> samples{};
    std::array<dds_sample_info_t, kAtOnce> infos;
    dds_return_t count = 0;
    do {
      count = dds_takecdr(reader_, samples.data(), kAtOnce, infos.data(), DDS_ANY_STATE);
      for (dds_return_t i = 0; i < count; ++i) {
        ddsi_serdata* const sample = samples[static_cast<std::size_t>(i)];
        const dds_sample_info_t& info = infos[static_cast<std::size_t>(i)];
        if (info.valid_data) {
          const std::uint32_t size = ddsi_serdata_size(sample);
          bytes_.resize(size);
          ddsi_serdata_to_ser(sample, 0, size, bytes_.data());
          use(bytes_, info.publication_handle);
        }
        ddsi_serdata_unref(sample);
      }
    } while (count > 0);
  }
  int matched_writers() const override {
    dds_subscription_matched_status_t status{};
    dds_get_subscription_matched_status(reader_, &status);
    return static_cast<int>(status.current_count);
  }
  std::uint64_t lost() const override {
    dds_sample_lost_status_t status{};
    dds_get_sample_lost_status(reader_, &status);
    return status.total_count;
  }
  Gid gid() const override { return gid_of(reader_); }

 private:
  dds_entity_t reader_;
  std::vector<std::uint8_t> bytes_;
};

/// A topic, or Cyclone's reason.
Result<dds_entity_t> open_topic(dds_entity_t participant, const std::string& topic, const std::string& ros_type) {
  const dds_topic_descriptor_t* const type = descriptor_of(ros_type);
  if (type == nullptr) {
    return Error{"ros.idl has no message " + ros_type};
  }
  const dds_entity_t entity = dds_create_topic(participant, type, topic.c_str(), nullptr, nullptr);
  return entity < 0 ? Result<dds_entity_t>(cyclone_base::refused("topic " + topic, entity)) : entity;
}

}  // namespace

Gid gid_of(dds_entity_t entity) {
  dds_guid_t guid{};
  dds_get_guid(entity, &guid);
  Gid gid{};
  std::copy(std::begin(guid.v), std::end(guid.v), gid.begin());
  return gid;
}

Result<std::shared_ptr<RawRosWriter>> open_writer(dds_entity_t participant, const std::string& topic,
                                                  const std::string& ros_type, const RosQos& qos,
                                                  const std::string& user_data) {
  const dds_entity_t entity = FARRIER_TRY(open_topic(participant, topic, ros_type));
  const dds_entity_t writer = dds_create_writer(participant, entity, dds_qos(qos, user_data).get(), nullptr);
  dds_delete(entity);  // the writer keeps it
  if (writer < 0) {
    return cyclone_base::refused("a writer of " + topic, writer);
  }
  return std::shared_ptr<RawRosWriter>(std::make_shared<CycloneRosWriter>(writer, *descriptor_of(ros_type)));
}

Result<std::shared_ptr<RawRosReader>> open_reader(dds_entity_t participant, const std::string& topic,
                                                  const std::string& ros_type, const RosQos& qos,
                                                  const std::string& user_data) {
  const dds_entity_t entity = FARRIER_TRY(open_topic(participant, topic, ros_type));
  const dds_entity_t reader = dds_create_reader(participant, entity, dds_qos(qos, user_data).get(), nullptr);
  dds_delete(entity);
  if (reader < 0) {
    return cyclone_base::refused("a reader of " + topic, reader);
  }
  return std::shared_ptr<RawRosReader>(std::make_shared<CycloneRosReader>(reader));
}

}  // namespace farrier::bus_ros
