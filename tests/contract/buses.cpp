#include "buses.hpp"

#include <unistd.h>

#include "bus_cyclone/cyclone_bus.hpp"
#ifdef FARRIER_HAVE_FASTDDS
#include "bus_fastdds/fast_bus.hpp"
#endif

namespace farrier::contract {
namespace {

constexpr int kFirstDomain = 20;
constexpr int kDomains = 80;

std::unique_ptr<bus::Bus> required(Result<std::unique_ptr<bus::Bus>> created) {
  FARRIER_ENSURE(created.ok(), created.error().message.c_str());
  return std::move(created).value();
}

}  // namespace

int own_domain() { return kFirstDomain + getpid() % kDomains; }

bool available(bus::Vendor vendor) {
#ifdef FARRIER_HAVE_FASTDDS
  static_cast<void>(vendor);
  return true;
#else
  return vendor != bus::Vendor::kFast;
#endif
}

std::unique_ptr<bus::Bus> make_bus(bus::Vendor vendor, int domain, const std::shared_ptr<bus::InprocDomain>& inproc) {
  bus::NetworkOptions options;
  options.domain = domain;
  switch (vendor) {
    case bus::Vendor::kInproc: return bus::create_inproc_bus(inproc);
    case bus::Vendor::kCyclone: return required(bus_cyclone::create_cyclone_bus(options));
    case bus::Vendor::kFast:
#ifdef FARRIER_HAVE_FASTDDS
      return required(bus_fastdds::create_fast_bus(options));
#endif
      break;
  }
  FARRIER_ENSURE(false, "this build has no such bus");
  return nullptr;
}

}  // namespace farrier::contract
