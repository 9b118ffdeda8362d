#include "bus/inproc/inproc_bus.hpp"

#include "bus/endpoint_check.hpp"
#include "bus/inproc/inproc_state.hpp"
#include "bus/key.hpp"

namespace farrier::bus {
namespace {

using KeyFunction = std::uint32_t (*)(const void*);

#define FARRIER_KEY_FUNCTION(Signal, file) \
  [](const void* signal) { return key_of(*static_cast<const signals::Signal*>(signal)); },
constexpr std::array<KeyFunction, kTopicCount> kKeyFunctions{FARRIER_SIGNALS(FARRIER_KEY_FUNCTION)};
#undef FARRIER_KEY_FUNCTION

class InprocWriter final : public RawWriter {
 public:
  InprocWriter(std::shared_ptr<InprocDomain> domain, const EndpointSpec& endpoint)
      : domain_(std::move(domain)),
        state_{.endpoint = endpoint, .key_of = kKeyFunctions[static_cast<std::size_t>(endpoint.topic)]} {
    if (endpoint.qos.durability == Durability::kTransientLocal) {
      state_.history.emplace(spec(endpoint.topic).signal_size, endpoint.qos.history_depth);
    }
    const std::lock_guard lock(domain_->state().mutex);
    domain_->state().add(state_);
  }
  ~InprocWriter() override {
    const std::lock_guard lock(domain_->state().mutex);
    domain_->state().remove(state_);
  }

  bool write(const void* signal) noexcept override {
    const std::lock_guard lock(domain_->state().mutex);
    domain_->state().write(state_, signal);
    return true;
  }

  void assert_liveliness() noexcept override {
    const std::lock_guard lock(domain_->state().mutex);
    domain_->state().assert_liveliness(state_);
  }

  int matched_readers() const noexcept override {
    const std::lock_guard lock(domain_->state().mutex);
    return static_cast<int>(state_.readers.size());
  }

 private:
  std::shared_ptr<InprocDomain> domain_;
  WriterState state_;
};

class InprocReader final : public RawReader {
 public:
  InprocReader(std::shared_ptr<InprocDomain> domain, const EndpointSpec& endpoint, std::shared_ptr<Notifier> notifier)
      : domain_(std::move(domain)),
        state_{.endpoint = endpoint,
               .notifier = std::move(notifier),
               .history = KeyHistory(spec(endpoint.topic).signal_size, endpoint.qos.history_depth)} {
    const std::lock_guard lock(domain_->state().mutex);
    domain_->state().add(state_);
  }
  ~InprocReader() override {
    const std::lock_guard lock(domain_->state().mutex);
    domain_->state().remove(state_);
  }

  std::size_t take(void* signals, std::size_t capacity) noexcept override {
    InprocState& domain = domain_->state();
    const std::lock_guard lock(domain.mutex);
    domain.refresh(state_, domain.clock());
    const std::size_t count = state_.history.pop(signals, capacity);
    state_.status.received += count;
    return count;
  }

  ReaderStatus status() const noexcept override {
    InprocState& domain = domain_->state();
    const std::lock_guard lock(domain.mutex);
    domain.refresh(state_, domain.clock());
    ReaderStatus status = state_.status;
    status.matched_writers = static_cast<int>(state_.writers.size());
    return status;
  }

 private:
  std::shared_ptr<InprocDomain> domain_;
  mutable ReaderState state_;  // asking for the status is what lets time pass for a reader
};

class InprocBus final : public Bus {
 public:
  explicit InprocBus(std::shared_ptr<InprocDomain> domain) : domain_(std::move(domain)) {}

  Vendor vendor() const noexcept override { return Vendor::kInproc; }

  Result<std::unique_ptr<RawWriter>> create_writer(const EndpointSpec& endpoint) override {
    if (auto error = endpoint_error(endpoint)) {
      return *error;
    }
    return std::unique_ptr<RawWriter>(std::make_unique<InprocWriter>(domain_, endpoint));
  }

  Result<std::unique_ptr<RawReader>> create_reader(const EndpointSpec& endpoint) override {
    if (auto error = endpoint_error(endpoint)) {
      return *error;
    }
    return std::unique_ptr<RawReader>(std::make_unique<InprocReader>(domain_, endpoint, notifier_of(endpoint)));
  }

 private:
  std::shared_ptr<InprocDomain> domain_;
};

}  // namespace

InprocDomain::InprocDomain(std::function<SteadyTime()> clock) : state_(std::make_unique<InprocState>()) {
  state_->clock = std::move(clock);
}

InprocDomain::~InprocDomain() = default;

std::uint64_t InprocDomain::overwritten() const noexcept {
  const std::lock_guard lock(state_->mutex);
  return state_->overwritten;
}

std::unique_ptr<Bus> create_inproc_bus(std::shared_ptr<InprocDomain> domain) {
  return std::make_unique<InprocBus>(std::move(domain));
}

}  // namespace farrier::bus
