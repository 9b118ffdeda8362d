#include "bus_cyclone/cyclone_reception.hpp"

#include <dds/dds.h>
#include <dds/ddsrt/sockets.h>
#include <dlfcn.h>

#include <atomic>
#include <cstdlib>
#include <thread>

namespace farrier::bus_cyclone {
namespace {

std::atomic<bool> gathering{false};

using Receive = decltype(&ddsrt_recvmsg);

/// Cyclone's own function, which the one below takes the place of.
Receive cyclones_receive() {
  auto* const found = reinterpret_cast<Receive>(::dlsym(RTLD_NEXT, "ddsrt_recvmsg"));
  if (found == nullptr) {
    std::abort();  // libddsc calls it, so it is there
  }
  return found;
}

}  // namespace

void gather_arrivals() noexcept { gathering = true; }

}  // namespace farrier::bus_cyclone

// The library libddsc calls this function by its procedure linkage table, so it replaces Cyclone's own.
extern "C" dds_return_t ddsrt_recvmsg(ddsrt_socket_t socket, ddsrt_msghdr_t* message, int flags, ssize_t* received) {
  using namespace farrier::bus_cyclone;
  static const Receive receive = cyclones_receive();
  if (gathering) {
    const dds_return_t at_once = receive(socket, message, flags | MSG_DONTWAIT, received);
    if (at_once != DDS_RETCODE_TRY_AGAIN) {
      return at_once;
    }
    std::this_thread::sleep_for(kGatheringTime);
  }
  return receive(socket, message, flags, received);
}
