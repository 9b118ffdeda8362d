#include "bus_cyclone/cyclone_bus.hpp"

#include <dds/dds.h>

#include <map>

#include "bus/endpoint_check.hpp"
#include "bus_cyclone/cyclone_domain.hpp"
#include "bus_cyclone/cyclone_endpoints.hpp"
#include "bus_cyclone/cyclone_qos.hpp"

namespace farrier::bus_cyclone {
namespace {

Error refused(const std::string& what, dds_return_t code) {
  return Error{"Cyclone refuses " + what + ": " + dds_strretcode(code)};
}

class CycloneBus final : public bus::Bus {
 public:
  CycloneBus(dds_entity_t domain, dds_entity_t participant) : domain_(domain), participant_(participant) {}
  ~CycloneBus() override { dds_delete(domain_); }

  bus::Vendor vendor() const noexcept override { return bus::Vendor::kCyclone; }

  Result<std::unique_ptr<bus::RawWriter>> create_writer(const bus::EndpointSpec& endpoint) override {
    if (auto error = bus::endpoint_error(endpoint)) {
      return *error;
    }
    const dds_entity_t topic = topic_of(endpoint.topic);
    if (topic < 0) {
      return refused(std::string("topic ") + bus::spec(endpoint.topic).name, topic);
    }
    const dds_entity_t publisher = parent(publishers_, endpoint.partitions, &dds_create_publisher);
    if (publisher < 0) {
      return refused("the partitions of a writer", publisher);
    }
    const QosPtr qos = endpoint_qos(endpoint);
    const dds_entity_t writer = dds_create_writer(publisher, topic, qos.get(), nullptr);
    if (writer < 0) {
      return refused(std::string("the QoS of the writer of ") + bus::spec(endpoint.topic).name, writer);
    }
    return wrap_writer(endpoint.topic, writer);
  }

  Result<std::unique_ptr<bus::RawReader>> create_reader(const bus::EndpointSpec& endpoint) override {
    if (auto error = bus::endpoint_error(endpoint)) {
      return *error;
    }
    const dds_entity_t topic = topic_of(endpoint.topic);
    if (topic < 0) {
      return refused(std::string("topic ") + bus::spec(endpoint.topic).name, topic);
    }
    const dds_entity_t subscriber = parent(subscribers_, endpoint.partitions, &dds_create_subscriber);
    if (subscriber < 0) {
      return refused("the partitions of a reader", subscriber);
    }
    const QosPtr qos = endpoint_qos(endpoint);
    return make_reader(endpoint.topic, subscriber, topic, *qos, notifier_);
  }

 private:
  using Parents = std::map<std::vector<std::string>, dds_entity_t>;

  dds_entity_t topic_of(bus::TopicId id) {
    const auto found = topics_.find(id);
    if (found != topics_.end()) {
      return found->second;
    }
    const dds_entity_t topic =
        dds_create_topic(participant_, &topic_descriptor(id), bus::spec(id).name, nullptr, nullptr);
    if (topic > 0) {
      topics_.emplace(id, topic);
    }
    return topic;
  }

  template <class Create>
  dds_entity_t parent(Parents& parents, const std::vector<std::string>& partitions, Create create) {
    const auto found = parents.find(partitions);
    if (found != parents.end()) {
      return found->second;
    }
    const QosPtr qos = partition_qos(partitions);
    const dds_entity_t entity = create(participant_, qos.get(), nullptr);
    if (entity > 0) {
      parents.emplace(partitions, entity);
    }
    return entity;
  }

  dds_entity_t domain_;
  dds_entity_t participant_;
  std::map<bus::TopicId, dds_entity_t> topics_;
  Parents publishers_;
  Parents subscribers_;
};

}  // namespace

Result<std::unique_ptr<bus::Bus>> create_cyclone_bus(const bus::NetworkOptions& options) {
  const auto joined = join_domain(options);
  if (!joined) {
    return joined.error();
  }
  return std::unique_ptr<bus::Bus>(std::make_unique<CycloneBus>(joined.value().domain, joined.value().participant));
}

}  // namespace farrier::bus_cyclone
