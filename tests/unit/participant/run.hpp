#pragma once

// Participants of one run over the in-process bus, on a clock the test moves.

#include <gtest/gtest.h>

#include <chrono>
#include <memory>

#include "bus/inproc/inproc_bus.hpp"
#include "participant/participant.hpp"

namespace farrier::participant::testing {

inline constexpr std::uint64_t kSession = 5;

/// A member with its bus. Ports go before the bus they are on.
struct Member {
  std::unique_ptr<bus::Bus> bus;
  std::unique_ptr<Participant> participant;

  Participant* operator->() const { return participant.get(); }
};

class TestRun {
 public:
  explicit TestRun(std::uint16_t participants) : participants_(participants) {}

  Identity identity(std::uint16_t number, const std::string& name) const {
    return {name, "hyq", number, participants_, kSession, bus::ClockKind::kLockstep};
  }

  Member join(const Identity& identity) const {
    Member member{bus::create_inproc_bus(domain_), nullptr};
    auto joined = Participant::join(*member.bus, identity);
    EXPECT_TRUE(joined.ok());
    member.participant = std::move(joined).value();
    return member;
  }
  Member join(std::uint16_t number, const std::string& name) const { return join(identity(number, name)); }

  std::unique_ptr<bus::Bus> bus() const { return bus::create_inproc_bus(domain_); }

  void pass(Nanoseconds time) { *now_ += time; }
  SteadyTime now() const { return *now_; }

 private:
  std::uint16_t participants_;
  std::shared_ptr<SteadyTime> now_ = std::make_shared<SteadyTime>();
  std::shared_ptr<bus::InprocDomain> domain_ =
      std::make_shared<bus::InprocDomain>([now = now_] { return *now; });
};

/// The value of a set-up that must not fail.
template <class T>
T opened(Result<T> result) {
  EXPECT_TRUE(result.ok()) << (result ? "" : result.error().message);
  return result ? std::move(result).value() : T{};
}

}  // namespace farrier::participant::testing
