#include "bus/bus.hpp"

namespace farrier::bus {

const char* to_string(Vendor vendor) noexcept {
  switch (vendor) {
    case Vendor::kInproc: return "inproc";
    case Vendor::kCyclone: return "cyclone";
    case Vendor::kFast: return "fast";
  }
  return "unknown vendor";
}

Result<Vendor> parse_vendor(const std::string& text) {
  for (const Vendor vendor : {Vendor::kInproc, Vendor::kCyclone, Vendor::kFast}) {
    if (text == to_string(vendor)) {
      return vendor;
    }
  }
  return Error{"unknown DDS vendor '" + text + "': use cyclone, fast or inproc"};
}

}  // namespace farrier::bus
