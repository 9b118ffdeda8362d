#include "bus_fastdds/fast_bus.hpp"

#include "bus/endpoint_check.hpp"
#include "bus/settings/user_settings.hpp"
#include "bus_fastdds/fast_endpoints.hpp"

namespace farrier::bus_fastdds {
namespace {

constexpr int kMaxDomain = 232;  // RTPS 2.2, 9.6.1: the last whose ports stay below 65536

class FastBus final : public bus::Bus {
 public:
  explicit FastBus(std::shared_ptr<FastSession> session) : session_(std::move(session)) {}

  bus::Vendor vendor() const noexcept override { return bus::Vendor::kFast; }
  std::vector<std::string> take_security_warnings() override { return session_->take_security_warnings(); }

  Result<std::unique_ptr<bus::RawWriter>> create_writer(const bus::EndpointSpec& endpoint) override {
    if (auto error = bus::endpoint_error(endpoint)) {
      return *error;
    }
    return make_writer(session_, endpoint);
  }

  Result<std::unique_ptr<bus::RawReader>> create_reader(const bus::EndpointSpec& endpoint) override {
    if (auto error = bus::endpoint_error(endpoint)) {
      return *error;
    }
    return make_reader(session_, endpoint, notifier_of(endpoint));
  }

 private:
  std::shared_ptr<FastSession> session_;
};

}  // namespace

Result<std::unique_ptr<bus::Bus>> create_fast_bus(const bus::NetworkOptions& options) {
  if (options.domain < 0 || options.domain > kMaxDomain) {
    return Error{"DDS domain " + std::to_string(options.domain) + " is outside 0.." + std::to_string(kMaxDomain)};
  }
  if (options.max_processes < 1 || options.peers.empty()) {
    return Error{"network: max_processes must be at least 1 and peers must name a computer"};
  }
  bus::set_aside_discovery_servers();
  auto session = FARRIER_TRY(FastSession::open(options));
  return std::unique_ptr<bus::Bus>(std::make_unique<FastBus>(std::move(session)));
}

}  // namespace farrier::bus_fastdds
