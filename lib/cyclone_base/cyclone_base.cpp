#include "cyclone_base/cyclone_base.hpp"

namespace farrier::cyclone_base {

QosPtr endpoint_qos(int depth) {
  QosPtr qos(dds_create_qos());
  dds_qset_history(qos.get(), DDS_HISTORY_KEEP_LAST, depth);
  // This, not the history, sets what a transient-local writer keeps for late joiners.
  dds_qset_durability_service(qos.get(), 0, DDS_HISTORY_KEEP_LAST, depth, DDS_LENGTH_UNLIMITED, DDS_LENGTH_UNLIMITED,
                              DDS_LENGTH_UNLIMITED);
  dds_qset_writer_data_lifecycle(qos.get(), false);
  const dds_data_representation_id_t representation = DDS_DATA_REPRESENTATION_XCDR1;
  dds_qset_data_representation(qos.get(), 1, &representation);
  return qos;
}

Error refused(const std::string& what, dds_return_t code) {
  return Error{"Cyclone refuses " + what + ": " + dds_strretcode(code)};
}

std::string element(const std::string& name, const std::string& content) {
  return '<' + name + '>' + content + "</" + name + '>';
}

std::string prefix_text(const dds_guid_t& guid) {
  constexpr char kDigits[] = "0123456789abcdef";
  std::string text;
  for (std::size_t i = 0; i < kPrefixBytes; ++i) {
    text += kDigits[guid.v[i] >> 4];
    text += kDigits[guid.v[i] & 0xf];
  }
  return text;
}

}  // namespace farrier::cyclone_base
