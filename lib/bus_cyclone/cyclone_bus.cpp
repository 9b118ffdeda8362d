#include "bus_cyclone/cyclone_bus.hpp"

#include <dds/dds.h>
#include <dds/ddsrt/log.h>

#include <cctype>
#include <cstdio>
#include <cstdlib>
#include <map>
#include <mutex>
#include <string_view>

#include "bus/endpoint_check.hpp"
#include "bus/security_warnings.hpp"
#include "bus_cyclone/cyclone_config.hpp"
#include "bus_cyclone/cyclone_endpoints.hpp"
#include "bus_cyclone/cyclone_qos.hpp"

namespace farrier::bus_cyclone {
namespace {

constexpr int kMaxDomain = 232;  // RTPS 2.2, 9.6.1: the last whose ports stay below 65536

// A second bus of a domain in one process gets a Cyclone domain of its own, so that samples between the two cross
// the network as between processes. Only Cyclone's own number of it differs.
constexpr dds_domainid_t kLocalDomainStride = 1000;
constexpr int kMaxBusesOfADomain = 200;
// Cyclone looks for its own number in governance and permissions, whose parser takes none above 230.
constexpr dds_domainid_t kSecureDomains = 231;

dds_domainid_t local_number(const bus::NetworkOptions& options, int bus) {
  const auto domain = static_cast<dds_domainid_t>(options.domain);
  const auto others = static_cast<dds_domainid_t>(bus);
  return options.security ? (domain + others) % kSecureDomains : domain + others * kLocalDomainStride;
}

Error refused(const std::string& what, dds_return_t code) {
  return Error{"Cyclone refuses " + what + ": " + dds_strretcode(code)};
}

/// Cyclone tells of those it keeps out in its log alone, which is one for the process: who hears of which domain.
class LogWarnings {
 public:
  std::shared_ptr<bus::SecurityWarnings> of(std::uint32_t local_domain) {
    const std::lock_guard lock(mutex_);
    auto& warnings = by_domain_[local_domain];
    auto alive = warnings.lock();
    if (!alive) {
      alive = std::make_shared<bus::SecurityWarnings>();
      warnings = alive;
    }
    return alive;
  }

 private:
  std::mutex mutex_;
  std::map<std::uint32_t, std::weak_ptr<bus::SecurityWarnings>> by_domain_;
};

LogWarnings& log_warnings() {
  static LogWarnings warnings;
  return warnings;
}

/// Said of everybody whose announcement comes once more before the handshake with him is over: nothing to warn of.
constexpr std::string_view kNotYetAllowed = "Remote secure participant";

/// Passes the log on to where it goes without this, and keeps what it warns of.
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
  CycloneBus(dds_entity_t domain, dds_entity_t participant, std::shared_ptr<bus::SecurityWarnings> warnings,
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
    auto reader = make_reader(endpoint.topic, subscriber, topic, *qos, notifier_);
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
  std::shared_ptr<bus::SecurityWarnings> warnings_;
  std::string refusals_;
  std::map<bus::TopicId, dds_entity_t> topics_;
  Parents publishers_;
  Parents subscribers_;
};

std::string config_with_user_part(const bus::NetworkOptions& options) {
  std::string config = cyclone_config(options);
  const char* user = std::getenv("CYCLONEDDS_URI");
  if (user != nullptr && *user != '\0') {
    config += std::string(",") + user;
  }
  return config;
}

}  // namespace

Result<std::unique_ptr<bus::Bus>> create_cyclone_bus(const bus::NetworkOptions& options) {
  if (options.domain < 0 || options.domain > kMaxDomain) {
    return Error{"DDS domain " + std::to_string(options.domain) + " is outside 0.." + std::to_string(kMaxDomain)};
  }
  if (options.max_processes < 1 || options.peers.empty()) {
    return Error{"network: max_processes must be at least 1 and peers must name a computer"};
  }
  const std::string config = config_with_user_part(options);
  dds_domainid_t local_id = local_number(options, 0);
  dds_entity_t domain = dds_create_domain(local_id, config.c_str());
  for (int i = 1; i < kMaxBusesOfADomain && domain == DDS_RETCODE_PRECONDITION_NOT_MET; ++i) {
    local_id = local_number(options, i);
    domain = dds_create_domain(local_id, config.c_str());
  }
  if (domain < 0) {
    return refused("domain " + std::to_string(options.domain) + " on " + options.address +
                       " (its own message is above; is the address this computer's, CYCLONEDDS_URI well-formed, and " +
                       "are fewer than " + std::to_string(options.max_processes) + " processes running?)",
                   domain);
  }
  auto warnings = log_warnings().of(local_id);
  if (options.security) {
    dds_set_log_sink(on_log, nullptr);
  }
  const QosPtr qos = participant_qos(options.security);
  const dds_entity_t participant = dds_create_participant(local_id, qos.get(), nullptr);
  if (participant < 0) {
    dds_delete(domain);
    if (options.security) {
      return refused("a secure participant with " + options.security->certificate + " (its own message is above)",
                     participant);
    }
    return refused("a participant in domain " + std::to_string(options.domain), participant);
  }
  return std::unique_ptr<bus::Bus>(std::make_unique<CycloneBus>(domain, participant, std::move(warnings), bus::refusals_by(options)));
}

}  // namespace farrier::bus_cyclone
