#include "bus_faults/faulty_bus.hpp"

#include <algorithm>
#include <iterator>

#include "bus/said_once.hpp"
#include "bus_faults/faulty_reader.hpp"

namespace farrier::bus_faults {
namespace {

bool is_order(bus::TopicId topic) noexcept {
  switch (topic) {
#define FARRIER_CASE(Signal, file)  \
  case bus::TopicId::k##Signal:     \
    return signals::kIsOrder<signals::Signal>;
    FARRIER_SIGNALS(FARRIER_CASE)
#undef FARRIER_CASE
  }
  return false;
}

class FaultyBus final : public bus::Bus {
 public:
  FaultyBus(std::unique_ptr<bus::Bus> inner, std::vector<ArrowFault> faults, std::uint64_t seed, std::string name,
            Clock clock)
      : bus::Bus(inner->notifier()),
        inner_(std::move(inner)),
        faults_(std::move(faults)),
        seed_(seed),
        name_(std::move(name)),
        clock_(std::move(clock)),
        due_(notifier(), clock_),
        concerns_orders_(std::ranges::any_of(faults_, [](const ArrowFault& fault) { return is_order(fault.topic); })) {}

  bus::Vendor vendor() const noexcept override { return inner_->vendor(); }
  std::vector<std::string> take_security_warnings() override { return inner_->take_security_warnings(); }
  std::vector<std::string> take_faults_begun() override { return begun_.take(); }

  Result<std::unique_ptr<bus::RawWriter>> create_writer(const bus::EndpointSpec& endpoint) override {
    return inner_->create_writer(endpoint);
  }

  Result<std::unique_ptr<bus::RawReader>> create_reader(const bus::EndpointSpec& endpoint) override {
    std::vector<ArrowFault> mine;
    std::ranges::copy_if(faults_, std::back_inserter(mine), [&](const auto& f) { return f.topic == endpoint.topic; });
    auto reader = inner_->create_reader(endpoint);
    if (!reader || (mine.empty() && !concerns_orders_)) {
      return reader;
    }
    switch (endpoint.topic) {
#define FARRIER_CASE(Signal, file)                                                             \
  case bus::TopicId::k##Signal:                                                                \
    return std::unique_ptr<bus::RawReader>(std::make_unique<FaultyReader<signals::Signal>>(    \
        std::move(reader).value(), mine, seed_, name_, clock_, due_, newest_, begun_));
      FARRIER_SIGNALS(FARRIER_CASE)
#undef FARRIER_CASE
    }
    return reader;
  }

 private:
  std::unique_ptr<bus::Bus> inner_;
  std::vector<ArrowFault> faults_;
  std::uint64_t seed_;
  std::string name_;
  Clock clock_;
  DueTimes due_;
  bool concerns_orders_;               ///< then every reader tells the tick
  std::atomic<Tick> newest_{kNoTick};
  bus::SaidOnce begun_;
};

}  // namespace

std::unique_ptr<bus::Bus> with_faults(std::unique_ptr<bus::Bus> inner, std::vector<ArrowFault> faults,
                                      std::uint64_t seed, const std::string& name, Clock clock) {
  return std::make_unique<FaultyBus>(std::move(inner), std::move(faults), seed, name, std::move(clock));
}

}  // namespace farrier::bus_faults
