#include "bus_cyclone/cyclone_domain.hpp"

#include <cstdlib>
#include <string>

#include "bus_cyclone/cyclone_config.hpp"

namespace farrier::bus_cyclone {
namespace {

constexpr int kMaxDomain = 232;  // RTPS 2.2, 9.6.1: the last whose ports stay below 65536

// A second bus of a domain in one process gets a Cyclone domain of its own, so that samples between the two cross
// the network as between processes. Only Cyclone's own number of it differs.
constexpr dds_domainid_t kLocalDomainStride = 1000;
constexpr int kMaxBusesOfADomain = 256;

Error refused(const std::string& what, dds_return_t code) {
  return Error{"Cyclone refuses " + what + ": " + dds_strretcode(code)};
}

std::string config_with_user_part(const bus::NetworkOptions& options) {
  std::string config = cyclone_config(options);
  const char* user = std::getenv("CYCLONEDDS_URI");
  if (user != nullptr && *user != '\0') {
    config += std::string(",") + user;
  }
  return config;
}

}  // namespace

Result<JoinedDomain> join_domain(const bus::NetworkOptions& options) {
  if (options.domain < 0 || options.domain > kMaxDomain) {
    return Error{"DDS domain " + std::to_string(options.domain) + " is outside 0.." + std::to_string(kMaxDomain)};
  }
  if (options.max_processes < 1 || options.peers.empty()) {
    return Error{"network: max_processes must be at least 1 and peers must name a computer"};
  }
  const std::string config = config_with_user_part(options);
  auto local_id = static_cast<dds_domainid_t>(options.domain);
  dds_entity_t domain = dds_create_domain(local_id, config.c_str());
  for (int i = 1; i < kMaxBusesOfADomain && domain == DDS_RETCODE_PRECONDITION_NOT_MET; ++i) {
    local_id += kLocalDomainStride;
    domain = dds_create_domain(local_id, config.c_str());
  }
  if (domain < 0) {
    return refused("domain " + std::to_string(options.domain) + " on " + options.address +
                       " (its own message is above; is the address this computer's, CYCLONEDDS_URI well-formed, and " +
                       "are fewer than " + std::to_string(options.max_processes) + " processes running?)",
                   domain);
  }
  const dds_entity_t participant = dds_create_participant(local_id, nullptr, nullptr);
  if (participant < 0) {
    dds_delete(domain);
    return refused("a participant in domain " + std::to_string(options.domain), participant);
  }
  return JoinedDomain{domain, participant};
}

}  // namespace farrier::bus_cyclone
