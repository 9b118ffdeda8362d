#include "bus_factory/bus_factory.hpp"

#include "bus/settings/peer_address.hpp"
#include "bus_cyclone/cyclone_bus.hpp"
#include "bus_cyclone/cyclone_discovery.hpp"
#ifdef FARRIER_HAVE_FASTDDS
#include "bus_fastdds/fast_bus.hpp"
#endif

namespace farrier::bus_factory {

Result<std::unique_ptr<bus::Bus>> create_bus(bus::Vendor vendor, const bus::NetworkOptions& options) {
  const bus::NetworkOptions network = FARRIER_TRY(bus::resolve(options));
  switch (vendor) {
    case bus::Vendor::kCyclone:
      return bus_cyclone::create_cyclone_bus(network);
    case bus::Vendor::kFast:
#ifdef FARRIER_HAVE_FASTDDS
      return bus_fastdds::create_fast_bus(network);
#else
      return Error{
          "this build is without Fast DDS: './farrier test' or './farrier trot --dds fast' in the source tree adds it"};
#endif
    case bus::Vendor::kInproc:
      break;
  }
  return Error{"a process of its own needs a DDS vendor: --dds cyclone or --dds fast"};
}

Result<bus::Discovery> discover(const bus::NetworkOptions& network, Nanoseconds how_long) {
  return bus_cyclone::discover(FARRIER_TRY(bus::resolve(network)), how_long);
}

}  // namespace farrier::bus_factory
