#include "bus_cyclone/cyclone_qos.hpp"

namespace farrier::bus_cyclone {
namespace {

// A reliable KEEP_LAST writer replaces its oldest sample rather than wait; this bounds the exception, a writer
// whose history over all keys exceeds Cyclone's high-water mark while a reader does not acknowledge.
constexpr dds_duration_t kMaxBlockingTime = DDS_MSECS(10);

// Our kInfinite and Cyclone's are the same number.
static_assert(bus::kInfinite.count() == DDS_INFINITY);

dds_liveliness_kind_t liveliness_kind(bus::Liveliness liveliness) {
  return liveliness == bus::Liveliness::kAutomatic ? DDS_LIVELINESS_AUTOMATIC : DDS_LIVELINESS_MANUAL_BY_TOPIC;
}

/// One of the three plug-ins that Cyclone loads; Debian's finds them by their plain names.
void use_plugin(dds_qos_t& qos, const std::string& part, const std::string& library, const std::string& functions) {
  const std::string prefix = "dds.sec." + part + ".library.";
  dds_qset_prop(&qos, (prefix + "path").c_str(), library.c_str());
  dds_qset_prop(&qos, (prefix + "init").c_str(), ("init_" + functions).c_str());
  dds_qset_prop(&qos, (prefix + "finalize").c_str(), ("finalize_" + functions).c_str());
}

}  // namespace

QosPtr participant_qos(const std::optional<bus::SecurityFiles>& security) {
  QosPtr qos(dds_create_qos());
  if (!security) {
    return qos;
  }
  use_plugin(*qos, "auth", "dds_security_auth", "authentication");
  use_plugin(*qos, "access", "dds_security_ac", "access_control");
  use_plugin(*qos, "crypto", "dds_security_crypto", "crypto");
  const std::pair<const char*, const std::string&> files[] = {
      {"dds.sec.auth.identity_ca", security->identity_ca}, {"dds.sec.auth.identity_certificate", security->certificate},
      {"dds.sec.auth.private_key", security->private_key}, {"dds.sec.access.permissions_ca", security->permissions_ca},
      {"dds.sec.access.governance", security->governance}, {"dds.sec.access.permissions", security->permissions}};
  for (const auto& [name, path] : files) {
    dds_qset_prop(qos.get(), name, ("file:" + path).c_str());
  }
  return qos;
}

QosPtr partition_qos(const std::vector<std::string>& partitions) {
  QosPtr qos(dds_create_qos());
  std::vector<const char*> names;
  for (const std::string& name : partitions) {
    names.push_back(name.c_str());
  }
  if (!names.empty()) {
    dds_qset_partition(qos.get(), static_cast<std::uint32_t>(names.size()), names.data());
  }
  return qos;
}

QosPtr endpoint_qos(const bus::EndpointSpec& endpoint) {
  const bus::Qos& wanted = endpoint.qos;
  QosPtr qos = cyclone_base::endpoint_qos(wanted.history_depth);
  dds_qset_reliability(
      qos.get(),
      wanted.reliability == bus::Reliability::kReliable ? DDS_RELIABILITY_RELIABLE : DDS_RELIABILITY_BEST_EFFORT,
      kMaxBlockingTime);
  dds_qset_durability(qos.get(), wanted.durability == bus::Durability::kTransientLocal ? DDS_DURABILITY_TRANSIENT_LOCAL
                                                                                       : DDS_DURABILITY_VOLATILE);
  dds_qset_deadline(qos.get(), wanted.deadline.count());
  dds_qset_liveliness(qos.get(), liveliness_kind(wanted.liveliness), wanted.lease.count());
  dds_qset_ownership(qos.get(),
                     wanted.ownership == bus::Ownership::kExclusive ? DDS_OWNERSHIP_EXCLUSIVE : DDS_OWNERSHIP_SHARED);
  dds_qset_ownership_strength(qos.get(), endpoint.ownership_strength);
  return qos;
}

}  // namespace farrier::bus_cyclone
