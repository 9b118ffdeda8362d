#include "bus_fastdds/session_keys.hpp"

#include <dlfcn.h>

#include <array>
#include <atomic>
#include <cstddef>
#include <vector>

#include "core/ensure.hpp"

namespace {

using Key = std::array<std::uint8_t, 32>;

/// Inputs of the derivation of a session key (DDS Security 1.1, 9.5.3.3.3).
struct Source {
  std::uint32_t session_id;
  bool receiver_specific;
  int key_bytes;
  Key master_key, master_salt;

  bool operator==(const Source&) const = default;
};

std::atomic<std::uint64_t> derived{0};

}  // namespace

namespace eprosima::fastrtps::rtps::security {

/// The needed part of Fast DDS 2.9's own class. Its function of this name is called by the procedure linkage table, so
/// the one below replaces it.
class AESGCMGMAC_Transform {
 public:
  void compute_sessionkey(Key& session_key, bool receiver_specific, const Key& master_key, const Key& master_salt,
                          std::uint32_t session_id, int key_bytes);
};

void AESGCMGMAC_Transform::compute_sessionkey(Key& session_key, bool receiver_specific, const Key& master_key,
                                              const Key& master_salt, std::uint32_t session_id, int key_bytes) {
  using Derive = void (*)(AESGCMGMAC_Transform*, Key&, bool, const Key&, const Key&, std::uint32_t, int);
  static const auto derive = reinterpret_cast<Derive>(
      ::dlsym(RTLD_NEXT, "_ZN8eprosima8fastrtps4rtps8security20AESGCMGMAC_Transform18compute_sessionkeyERSt5arrayIhLm32EEbRKS5_"
                         "S8_ji"));
  FARRIER_ENSURE(derive != nullptr, "Fast DDS derives session keys by a function of another name");

  // A thread hears the participants of a robot, each with one session at a time. The sessions are on the heap, because
  // thread_local data take space on the stack of every thread, and civetweb's threads have only 100 KiB.
  struct Session {
    Source source;
    Key key;
  };
  constexpr std::size_t kSessions = 64;
  thread_local std::vector<Session> sessions;
  thread_local std::size_t oldest = 0;

  const Source source{session_id, receiver_specific, key_bytes, master_key, master_salt};
  for (const Session& session : sessions) {
    if (session.source == source) {
      session_key = session.key;
      return;
    }
  }
  derive(this, session_key, receiver_specific, master_key, master_salt, session_id, key_bytes);
  ++derived;
  if (sessions.size() < kSessions) {
    sessions.push_back({source, session_key});
    return;
  }
  sessions[oldest] = {source, session_key};
  oldest = (oldest + 1) % kSessions;
}

}  // namespace eprosima::fastrtps::rtps::security

namespace farrier::bus_fastdds {

void remember_session_keys() noexcept {}

std::uint64_t session_keys_derived() noexcept { return derived; }

}  // namespace farrier::bus_fastdds
