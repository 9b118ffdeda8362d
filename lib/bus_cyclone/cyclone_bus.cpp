#include "bus_cyclone/cyclone_bus.hpp"

#include <dds/dds.h>
#include <dds/ddsrt/log.h>

#include <cctype>
#include <cstdio>
#include <map>
#include <mutex>
#include <string_view>

#include "bus/endpoint_check.hpp"
#include "bus/said_once.hpp"
#include "bus_cyclone/cyclone_domain.hpp"
#include "bus_cyclone/cyclone_endpoints.hpp"
#include "bus_cyclone/cyclone_qos.hpp"

namespace farrier::bus_cyclone {
namespace {

/// Warnings from Cyclone's log, by domain. Cyclone reports the participants that it keeps out only in its log, of which
/// a process has one.
class LogWarnings {
 public:
  std::shared_ptr<bus::SaidOnce> of(std::uint32_t local_domain) {
    const std::lock_guard lock(mutex_);
    auto& warnings = by_domain_[local_domain];
    auto alive = warnings.lock();
    if (!alive) {
      alive = std::make_shared<bus::SaidOnce>();
      warnings = alive;
    }
    return alive;
  }

 private:
  std::mutex mutex_;
  std::map<std::uint32_t, std::weak_ptr<bus::SaidOnce>> by_domain_;
};

LogWarnings& log_warnings() {
  static LogWarnings warnings;
  return warnings;
}

/// Cyclone logs this for a participant that announces itself again before its handshake is over: no warning.
constexpr std::string_view kNotYetAllowed = "Remote secure participant";

/// Passes the log on to standard error, as without this function, and keeps its warnings.
void on_log(void*, const dds_log_data_t* line) {
  std::fputs(line->message - line->hdrsize, stderr);
  if ((line->priority & (DDS_LC_WARNING | DDS_LC_ERROR)) != 0) {
    std::string sentence(line->message);
    while (!sentence.empty() && std::isspace(static_cast<unsigned char>(sentence.back())) != 0) {
      sentence.pop_back();
    }
    if (!sentence.starts_with(kNotYetAllowed)) {
      log_warnings().of(line->domid)->add(sentence);
    }
  }
}

class CycloneBus final : public bus::Bus {
 public:
  CycloneBus(dds_entity_t domain, dds_entity_t participant, std::shared_ptr<bus::SaidOnce> warnings,
             std::string refusals)
      : domain_(domain), participant_(participant), warnings_(std::move(warnings)), refusals_(std::move(refusals)) {}
  ~CycloneBus() override { dds_delete(domain_); }

  std::vector<std::string> take_security_warnings() override { return warnings_->take(); }

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
      return refused(std::string("the writer of ") + bus::spec(endpoint.topic).name + refusals_, writer);
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
    auto reader = make_reader(endpoint.topic, subscriber, topic, *qos, notifier_of(endpoint));
    if (!reader) {
      return Error{reader.error().message + refusals_};
    }
    return reader;
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
  std::shared_ptr<bus::SaidOnce> warnings_;
  std::string refusals_;
  std::map<bus::TopicId, dds_entity_t> topics_;
  Parents publishers_;
  Parents subscribers_;
};

}  // namespace

Result<std::unique_ptr<bus::Bus>> create_cyclone_bus(const bus::NetworkOptions& options) {
  const auto domain = FARRIER_TRY(open_domain(options));
  auto warnings = log_warnings().of(domain.number);
  if (options.security) {
    dds_set_log_sink(on_log, nullptr);
  }
  const auto participant = FARRIER_TRY(join_domain(domain, options));
  return std::unique_ptr<bus::Bus>(std::make_unique<CycloneBus>(domain.entity, participant,
                                                                std::move(warnings), bus::refusals_by(options)));
}

}  // namespace farrier::bus_cyclone
