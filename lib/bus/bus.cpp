#include "bus/bus.hpp"

namespace farrier::bus {

Result<Vendor> parse_vendor(const std::string& text) {
  return parse_choice("DDS vendor", kVendors, text);
}

}  // namespace farrier::bus
