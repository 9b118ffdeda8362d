#include "bus_cyclone/cyclone_domain.hpp"

#include <cstdio>
#include <cstdlib>
#include <string>

#include "bus/settings/user_settings.hpp"
#include "bus_cyclone/cyclone_config.hpp"
#include "bus_cyclone/cyclone_qos.hpp"
#include "bus_cyclone/cyclone_reception.hpp"
#include "bus_cyclone/cyclone_waits.hpp"

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

/// XML of the settings of a user's CYCLONEDDS_URI that are honoured.
std::string users_config(const bus::NetworkOptions& options) {
  const char* const user = std::getenv("CYCLONEDDS_URI");
  return user == nullptr ? "" : bus::cyclone_settings(user, options).config;
}

Domain open_domain_with(const std::string& config, const bus::NetworkOptions& options) {
  dds_domainid_t number = local_number(options, 0);
  dds_entity_t domain = dds_create_domain(number, config.c_str());
  for (int i = 1; i < kMaxBusesOfADomain && domain == DDS_RETCODE_PRECONDITION_NOT_MET; ++i) {
    number = local_number(options, i);
    domain = dds_create_domain(number, config.c_str());
  }
  return {domain, number};
}

}  // namespace

Result<Domain> open_domain(const bus::NetworkOptions& options) {
  if (options.domain < 0 || options.domain > kMaxDomain) {
    return Error{"DDS domain " + std::to_string(options.domain) + " is outside 0.." + std::to_string(kMaxDomain)};
  }
  if (options.max_processes < 1 || options.peers.empty()) {
    return Error{"network: max_processes must be at least 1 and peers must name a computer"};
  }
  wait_on_steady_clock();
  if (options.unhurried) {
    gather_arrivals();
  }
  const std::string config = cyclone_config(options);
  const std::string users = users_config(options);
  Domain domain = open_domain_with(users.empty() ? config : config + "," + users, options);
  if (domain.entity < 0 && !users.empty()) {
    domain = open_domain_with(config, options);
    if (domain.entity >= 0) {
      std::fputs("CYCLONEDDS_URI: set aside, Cyclone refuses what it says (its own message is above)\n", stderr);
    }
  }
  if (domain.entity < 0) {
    return refused("domain " + std::to_string(options.domain) + " on " + options.address +
                       " (its own message is above; is the address this computer's, and are fewer than " +
                       std::to_string(options.max_processes) + " processes running?)",
                   domain.entity);
  }
  return domain;
}

Result<dds_entity_t> join_domain(const Domain& domain, const bus::NetworkOptions& options) {
  const QosPtr qos = participant_qos(options.security);
  const dds_entity_t participant = dds_create_participant(domain.number, qos.get(), nullptr);
  if (participant < 0) {
    dds_delete(domain.entity);
    if (options.security) {
      return refused("a secure participant with " + options.security->certificate + " (its own message is above)",
                     participant);
    }
    return refused("a participant in domain " + std::to_string(options.domain), participant);
  }
  return participant;
}

}  // namespace farrier::bus_cyclone
